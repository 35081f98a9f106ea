// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra of a Datawell Waverider as its receiver's software writes them, .spt: one file a half
// hour. Twelve lines with a number each
//   transmission index; significant wave height [cm]; zero-upcross period [s]; Smax, the highest
//   density [m^2/Hz]; temperatures of reference and sea [C]; battery; three offsets of
//   accelerometers; orientation of the buoy [deg]; inclination of the magnetic field [deg]
// and a line for each frequency, separated by commas:
//   frequency [Hz], density / Smax, direction [deg, coming from, clockwise from north],
//   directional spread [deg], skewness and kurtosis of the directional distribution
// Station and time are in the file's name alone: buoy}2024-09-09T01h15Z.spt.
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "line_checks.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/internal/utc_time.hpp"

namespace ocean {
namespace {

constexpr std::array<std::string_view, 12> kHeader = {"transmission index",
                                                      "significant wave height",
                                                      "zero-upcross period",
                                                      "highest density, Smax",
                                                      "reference temperature",
                                                      "sea temperature",
                                                      "battery status",
                                                      "offset of the vertical accelerometer",
                                                      "offset of the x-accelerometer",
                                                      "offset of the y-accelerometer",
                                                      "orientation",
                                                      "magnetic inclination"};
constexpr std::size_t kSmax = 3;  // its line, from 0
constexpr std::size_t kColumns = 6;
/// Five digits may round the highest relative density up to here.
constexpr double kMaxRelative = 1.0001;

class DatawellReader {
  public:
    explicit DatawellReader(const SpectrumSource& source) : lines_(source.content, source.name) {}

    SpectrumRecord read() {
        const double smax = read_header();
        SpectrumRecord record;
        while (lines_.next_filled()) read_row(record, smax);
        if (record.frequency.size() < 2) throw lines_.fail("fewer than 2 frequencies");
        drop_unknown_moments(record);
        return record;
    }

  private:
    double read_header() {
        double smax = 0.0;
        for (std::size_t i = 0; i < kHeader.size(); ++i) {
            const std::string what = "the " + std::string(kHeader[i]);
            if (!lines_.next_filled()) throw lines_.fail("the file ends before " + what);
            const double value = number(trimmed(lines_.line()), what);
            if (i == kSmax) smax = within(value, 0.0, 1e6, what, "0 .. 1e6 m^2/Hz");
        }
        return smax;
    }

    void read_row(SpectrumRecord& record, double smax) {
        fields_ = exact_fields(lines_, kColumns, "than the 6 numbers of a frequency");
        const double frequency = within(number(fields_[0], "a frequency"), 0.0, kMaxFrequency,
                                        "a frequency", kFrequencyRange);
        append_frequency(lines_, frequency, record.frequency);
        record.density.push_back(smax * within(number(fields_[1], "a relative density"),
                                               -kMaxRelative, kMaxRelative, "a relative density",
                                               "0 .. 1, of Smax"));
        append_mean_and_spread(
            record,
            travel_direction(
                number_or_missing(fields_[2], -360.0, 720.0, "a direction", "-360 .. 720 degrees"),
                DirectionConvention::from_nautical),
            number_or_missing(fields_[3], 0.0, 180.0, "a spread", "0 .. 180 degrees"));
    }

    double number(std::string_view word, const std::string& what) const {
        const std::optional<double> value = text::parse_number(word);
        if (value && std::isfinite(*value)) return *value;
        throw lines_.fail("'" + text::printable(word, 20) + "' is not " + what);
    }
    /// Returns a number; NaN for an empty field or nan: the rest of the bin still counts.
    double number_or_missing(std::string_view word, double low, double high,
                             const std::string& what, std::string_view allowed) const {
        if (word.empty() || word == "nan" || word == "NaN") return kMissing;
        return within(number(word, what), low, high, what, allowed);
    }
    double within(double value, double low, double high, const std::string& what,
                  std::string_view allowed) const {
        if (value >= low && value <= high) return value;
        throw lines_.fail(what + " of " + shortest_text(value) +
                          "; allowed: " + std::string(allowed));
    }

    LineReader lines_;
    std::vector<std::string_view> fields_;  // of the line
};

/// Returns station and time of ".../buoy}2024-09-09T01h15Z.spt"; empty if the name does not contain
/// them.
std::pair<std::string, std::string> parse_name(std::string_view path) {
    path.remove_prefix(path.find_last_of("/\\") + 1);
    const std::size_t brace = path.find('}');
    if (brace == std::string_view::npos) return {};
    std::string_view station = path.substr(0, brace);
    if (station.ends_with('$')) station.remove_suffix(1);  // some receivers write $}
    std::string time(path.substr(brace + 1, std::string_view("2024-09-09T01h15Z").size()));
    const std::size_t hours = time.find('h');
    if (hours != std::string::npos) time[hours] = ':';
    const std::optional<UtcTime> read = parse_utc_time(time);
    return {text::printable(station), read ? read->text() : ""};
}

/// Recognises four numbers, each on a line of its own, and commas after the header.
bool recognises(std::string_view content) {
    LineReader lines(content, "");
    for (std::size_t i = 0; i < kHeader.size(); ++i) {
        if (!lines.next_filled()) return false;
        if (i <= kSmax && !text::parse_number(trimmed(lines.line()))) return false;
    }
    return lines.next_filled() && lines.line().find(',') != std::string_view::npos;
}

std::vector<SpectrumRecord> read(const SpectrumSource& source) {
    SpectrumRecord record = DatawellReader(source).read();
    std::tie(record.station, record.time) = parse_name(source.name);
    return {std::move(record)};
}

}  // namespace

const SpectrumFormat kDatawell = {"Datawell .spt", recognises, read};

}  // namespace ocean
