// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sentences of a Nortek AWAC (NMEA, $PNOR...). One measurement, by date MMDDYY and time hhmmss, has
//   $PNORW,050120,000101,3,4,2.30,...*4F                       wave parameters; the 6th is Hm0 [m]
//   $PNORE,050120,000101,3,0.02,0.01,98,0.063,0.029,...*75     first frequency and step [Hz], the
//                                                              number of densities, densities
//   $PNORF,A1,050120,000101,3,0.02,0.01,48,-0.1370,...*06      A1, B1, A2, B2 of the direction that
//                                                              waves come from, clockwise from
//                                                              north
// Other sentences are skipped. *hh is the exclusive or of all characters between $ and *. A moment
// of -9 is missing; there are fewer moments than densities. The manual gives densities in cm^2/Hz,
// but instruments send m^2/Hz too: Hm0 decides.
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "free_form.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/seafile.hpp"

namespace ocean {
namespace {

constexpr std::string_view kStart = "$PNOR";
constexpr double kMissingMoment = -9.0;
constexpr double kMaxMoment = 1.005;
constexpr double kSquareCentimetre = 1e-4;  // m^2
/// Max relative difference of Hm0 and the spectrum's own height: beyond it they do not belong
/// together.
constexpr double kSameHeight = 0.2;
constexpr std::size_t kFirstLines = 50;

/// Removes the checksum of a sentence. Returns why the sentence cannot be trusted; empty for a good
/// one.
std::string remove_checksum(std::string_view& sentence) {
    const std::size_t star = sentence.rfind('*');
    if (star == std::string_view::npos) return "the sentence has no checksum: it is cut off";
    unsigned sum = 0;
    for (const char c : sentence.substr(1, star - 1)) sum ^= static_cast<unsigned char>(c);
    const std::string_view digits = trimmed(sentence.substr(star + 1));
    unsigned told = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), told, 16);
    sentence = sentence.substr(0, star);
    const bool read = error == std::errc() && end == digits.data() + digits.size();
    return read && told == sum ? "" : "the checksum of the sentence is wrong";
}

class AwacReader {
  public:
    explicit AwacReader(const SpectrumSource& source) : lines_(source.content, source.name) {}

    std::vector<SpectrumRecord> read() {
        while (lines_.next_filled()) {
            const std::size_t start = lines_.line().find(kStart);
            if (start == std::string_view::npos) continue;
            read_sentence(lines_.line().substr(start));
        }
        end_measurement();
        return std::move(records_);
    }

  private:
    /// The sentences of one time.
    struct Measurement {
        SpectrumRecord record;
        double hm0 = kMissing;
        std::vector<double> density;
        std::array<std::vector<double>, 4> moments;  // a1 b1 a2 b2
        double start = 0.0;
        double step = 0.0;
    };

    void read_sentence(std::string_view sentence) {
        std::string fault = remove_checksum(sentence);
        const auto fields = csv::split(sentence, ',', 2 * kMaxFrequencies);
        if (!fields || fields->empty()) return;
        fields_ = *fields;
        const bool moments = fields_[0] == "$PNORF";
        const bool known = moments || fields_[0] == "$PNORE" || fields_[0] == "$PNORW";
        if (!known) return;
        std::string& of_record = now_.record.fault;
        std::string time;
        if (fault.empty()) catch_fault(fault, [&] { time = read_time(moments ? 2 : 1); });
        if (fault.empty() && (!begun_ || time != now_.record.time)) {
            end_measurement();
            begun_ = true;
            now_.record.time = time;
        }
        if (fault.empty()) {
            catch_fault(fault, [&] { read_values(); });
        } else {
            begun_ = true;
            if (!fault.starts_with(lines_.fail("").what())) fault = lines_.fail(fault).what();
        }
        if (of_record.empty()) of_record = fault;
    }

    std::string read_time(std::size_t at) const {
        const std::string text = field(at) + field(at + 1).substr(0, 6);
        const std::optional<UtcTime> read = match_time(text, "MMDDYYhhmmss");
        UtcTime time = read.value_or(UtcTime());
        time.year += 2000;
        if (read && time.valid()) return time.text();
        throw lines_.fail("'" + text::printable(text, 20) +
                          "' where date and time, MMDDYY,hhmmss, should be");
    }
    std::string field(std::size_t at) const {
        return at < fields_.size() ? std::string(fields_[at]) : std::string();
    }
    double number(std::size_t at, double low, double high, std::string_view what) const {
        return number_within(lines_, field(at), low, high, what);
    }

    void read_values() {
        if (fields_[0] == "$PNORW") {
            now_.hm0 = number(5, -99.0, 100.0, "Hm0");
        } else if (fields_[0] == "$PNORE") {
            if (!now_.density.empty()) throw lines_.fail("a second $PNORE of the same time");
            now_.density = read_list(4, 1e9, "a density");
        } else {
            const std::array<std::string_view, 4> kNames = {"A1", "B1", "A2", "B2"};
            const auto found = std::find(kNames.begin(), kNames.end(), fields_[1]);
            if (found == kNames.end()) throw lines_.fail("$PNORF is not of A1, B1, A2 or B2");
            auto& values = now_.moments[static_cast<std::size_t>(found - kNames.begin())];
            if (!values.empty()) throw lines_.fail("a second " + field(1) + " of the same time");
            values = read_list(5, -kMissingMoment, "a moment");
        }
    }

    /// Reads the frequencies, on which the sentences of one time must agree, and a value for each.
    std::vector<double> read_list(std::size_t at, double most, std::string_view what) {
        const double start = number(at, 0.0, kMaxFrequency, "a frequency");
        const double step = number(at + 1, kMinFrequency, kMaxFrequency, "a step of frequency");
        const double count = number(at + 2, 2.0, kMaxFrequencies, "a number of frequencies");
        const bool first = now_.step == 0.0;
        if (!first && (start != now_.start || step != now_.step)) {
            throw lines_.fail("other frequencies than the sentence before");
        }
        now_.start = start;
        now_.step = step;
        if (static_cast<double>(fields_.size() - at - 3) != count) {
            throw lines_.fail(std::to_string(fields_.size() - at - 3) + " values for " +
                              field(at + 2) + " frequencies");
        }
        std::vector<double> values;
        for (std::size_t i = at + 3; i < fields_.size(); ++i) {
            values.push_back(number(i, -most, most, what));
        }
        return values;
    }

    void end_measurement() {
        if (!begun_) return;
        Measurement done;
        std::swap(done, now_);
        begun_ = false;
        require_room(lines_, records_.size());
        if ((values_ += 5 * done.density.size()) > kMaxFileValues) {
            throw lines_.fail("more than 67108864 values over all records");
        }
        if (done.record.fault.empty() && done.density.empty()) {
            done.record.fault =
                lines_.fail("$PNORE, with the densities, is missing at " + done.record.time).what();
        }
        if (done.record.fault.empty()) set_spectrum(done);
        records_.push_back(std::move(done.record));
    }

    static void set_spectrum(Measurement& done) {
        SpectrumRecord& record = done.record;
        record.density = std::move(done.density);
        const std::size_t count = record.density.size();
        for (std::size_t i = 0; i < count; ++i) {
            record.frequency.push_back(done.start + static_cast<double>(i) * done.step);
            const auto moment = [&](std::size_t which) {
                const std::vector<double>& values = done.moments[which];
                const double value = i < values.size() ? values[i] : kMissing;
                return std::abs(value) <= kMaxMoment ? value : kMissing;
            };
            // The moments belong to the direction D that waves come from, clockwise from north: cos
            // D and sin D. Waves travel to T = 270 - D from east: cos T = -sin D, sin T = -cos D,
            // cos 2T = -cos 2D, sin 2T = sin 2D.
            append_moments(record, {-moment(1), -moment(0), -moment(2), moment(3)});
        }
        drop_unknown_moments(record);
        set_unit(done);
    }

    static void set_unit(Measurement& done) {
        SpectrumRecord& record = done.record;
        record.warnings.push_back("times are those of the instrument's clock, taken as UTC");
        const double metres = 4.0 * std::sqrt(std::max(summarize(record).m0, 0.0));
        const double centimetres = metres * std::sqrt(kSquareCentimetre);
        if (!(done.hm0 > 0.0 && metres > 0.0)) {
            record.warnings.push_back(
                "without Hm0 the unit of the densities is unknown: m^2/Hz is assumed");
            return;
        }
        const bool centi =
            std::abs(std::log(centimetres / done.hm0)) < std::abs(std::log(metres / done.hm0));
        if (centi) {
            for (double& density : record.density) density *= kSquareCentimetre;
        }
        const double height = centi ? centimetres : metres;
        if (std::abs(height / done.hm0 - 1.0) <= kSameHeight) return;
        record.warnings.push_back("the spectrum has a height of " + fixed_text(height, 2) +
                                  " m where the instrument says Hm0 = " + fixed_text(done.hm0, 2) +
                                  " m");
    }

    LineReader lines_;
    std::vector<std::string_view> fields_;  // of the sentence
    Measurement now_;
    bool begun_ = false;
    std::size_t values_ = 0;
    std::vector<SpectrumRecord> records_;
};

/// Recognises a recording, which may begin in the middle of a sentence.
bool recognises(std::string_view content) {
    LineReader lines(content, "");
    for (std::size_t i = 0; i < kFirstLines && lines.next_filled(); ++i) {
        if (lines.line().starts_with(kStart)) return true;
    }
    return false;
}

}  // namespace

const SpectrumFormat kAwac = {"Nortek AWAC (NMEA)", recognises, read_by<AwacReader>};

}  // namespace ocean
