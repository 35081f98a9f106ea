// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra of Spotter buoys as JSON, as the interface of their maker answers:
//   {"data": {"spotterId": "SPOT-0070", "frequencyData": [{"timestamp": "2018-02-14T00:27:19.000Z",
//    "latitude": -61.09, "longitude": 173.42, "frequency": [...], "varianceDensity": [...],
//    "a1": [...], "b1": [...], "a2": [...], "b2": [...], "direction": [...],
//    "directionalSpread": [...]}, ...]}}
// Each list has a value for each frequency, null or NaN = missing; all other keys are skipped. The
// members of `data` may also be outside of it, and a list of such objects describes several buoys;
// or the file is a list of spectra alone. The moments are those of the travel direction, from east.
// The file is read as a stream of events: only the required values are stored, however deep or long
// the rest is.
#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#ifdef OCEAN_HAVE_JSON
#include <nlohmann/json.hpp>
#endif

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/utc_time.hpp"
#include "spectrum_format.hpp"
#include "spotter.hpp"

namespace ocean {
namespace {

constexpr std::string_view kStation = "spotterId";
constexpr std::string_view kSpectra = "frequencyData";
constexpr std::string_view kDensity = spotter::kNames[1];

#ifdef OCEAN_HAVE_JSON

using spotter::Quantity;

constexpr std::size_t kMaxDepth = 64;
/// 512 MiB of doubles over all records.
constexpr std::size_t kMaxValues = std::size_t{1} << 26;
/// Numbers of JSON out of the range of a double: an error of the parser with this number.
constexpr int kOutOfRange = 406;

/// Beside the quantities.
constexpr std::array<std::string_view, 3> kOtherKeys = {"timestamp", "latitude", "longitude"};
constexpr std::size_t kKeys = spotter::kQuantities + kOtherKeys.size();

/// Returns the index of a key of a spectrum: its quantity, or one of the other keys after them;
/// nothing for an unknown key.
std::optional<std::size_t> index_of(std::string_view key) {
    for (std::size_t i = 0; i < kKeys; ++i) {
        const bool quantity = i < spotter::kQuantities;
        if (key == (quantity ? spotter::kNames[i] : kOtherKeys[i - spotter::kQuantities])) return i;
    }
    return std::nullopt;
}

/// How far the parser has come.
struct Progress {
    std::size_t line = 1;  // of the last character that the parser has read
    char last = '\0';
    bool at_end = false;
};

/// Counts the lines of the parser's input, which the parser does not report to its handler.
class CountingIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, const char* end, Progress& progress)
        : at_(at), end_(end), progress_(&progress) {}
    const char& operator*() const { return *at_; }
    CountingIterator& operator++() {
        if (progress_->last == '\n') ++progress_->line;
        progress_->last = *at_++;
        return *this;
    }
    bool operator==(const CountingIterator& other) const {
        progress_->at_end |= at_ == end_;
        return at_ == other.at_;
    }

  private:
    const char* at_;
    const char* end_;
    Progress* progress_;
};

class SpotterJsonReader final : public nlohmann::json_sax<nlohmann::json> {
  public:
    explicit SpotterJsonReader(const SpectrumSource& source) : source_(source) {}

    std::vector<SpectrumRecord> read() {
        const std::string known = without_nan(source_.content);
        const std::string_view content = known.empty() ? source_.content : known;
        const char* begin = content.data();
        const char* end = begin + content.size();
        nlohmann::json::sax_parse(CountingIterator(begin, end, progress_),
                                  CountingIterator(end, end, progress_), this);
        return std::move(records_);
    }

    bool null() override {
        if (place() == Place::values) append(kMissing, "null");
        return true;
    }
    bool boolean(bool) override { return refuse_known("true or false"); }
    bool binary(nlohmann::json::binary_t&) override { return refuse_known("bytes"); }
    bool number_integer(std::int64_t value) override {
        return number(static_cast<double>(value), std::to_string(value));
    }
    bool number_unsigned(std::uint64_t value) override {
        return number(static_cast<double>(value), std::to_string(value));
    }
    bool number_float(double value, const std::string& spelled) override {
        return number(value, spelled);
    }
    bool string(std::string& value) override {
        if (place() == Place::answer && key_ == kStation) {
            answers_.back().station = text::printable(value);
        } else if (describes() && key_ == kOtherKeys[0]) {
            set_time(value);
        } else {
            refuse_known("a text");
        }
        return true;
    }

    bool key(std::string& value) override {
        key_ = value;
        const std::optional<std::size_t> known = index_of(key_);
        if (!describes() || !known) return true;
        if (seen_[*known]) blame("'" + key_ + "' appears twice in one spectrum");
        seen_[*known] = true;
        return true;
    }
    bool start_object(std::size_t) override {
        if (place() == Place::spectra) {
            begin_spectrum();
            return enter(Place::spectrum);
        }
        if (place() <= Place::answer) {
            answers_.push_back(
                {"", records_.size(), false, false, std::move(record_), std::move(bins_), seen_});
            begin_spectrum();
            return enter(Place::answer);
        }
        refuse_known("an object");
        return enter(Place::other);
    }
    bool end_object() override {
        if (place() == Place::spectrum) end_spectrum();
        if (place() == Place::answer) end_answer();
        return leave();
    }
    bool start_array(std::size_t) override {
        if (place() == Place::answer && key_ == kSpectra) {
            if (answers_.back().listed) throw fail("'" + key_ + "' appears twice");
            answers_.back().listed = true;
            return enter(Place::spectra);
        }
        const std::optional<std::size_t> known = index_of(key_);
        if (describes() && known && *known < spotter::kQuantities) {
            quantity_ = static_cast<Quantity>(*known);
            bins_[*known].clear();
            if (place() == Place::answer) answers_.back().spectrum = true;
            return enter(Place::values);
        }
        if (place() <= Place::answer) return enter(Place::answers);
        refuse_known("a list");
        return enter(Place::other);
    }
    bool end_array() override { return leave(); }

    /// Invalidates the spectrum that contains the error, and those after it.
    bool parse_error(std::size_t, const std::string& token,
                     const nlohmann::detail::exception& error) override {
        const std::string_view last(&progress_.last, 1);
        const std::string message =
            error.id == kOutOfRange
                ? "the number '" + text::printable(token, 20) + "' is out of range"
            : progress_.at_end ? "the file ends where its JSON does not"
                               : "'" + text::printable(last) + "' is not what JSON has here";
        const bool within = std::any_of(places_.begin(), places_.end(), [](Place place) {
            return place == Place::spectrum || place == Place::values;
        });
        if (records_.empty() && !within) throw fail(message);
        if (!within) record_ = {};
        record_.fault = fail(message).what();
        add_record();
        while (!answers_.empty()) leave_answer();
        return false;
    }

  private:
    /// The element around the parser's position. answer: the outermost object, its `data` and other
    /// objects within, which may be a spectrum themselves or contain a list of them; answers: a
    /// list of such; spectra: a list whose elements must be spectra; values: a list of a quantity;
    /// other: any other element within a spectrum.
    enum class Place { outside, answers, answer, spectra, spectrum, values, other };
    struct Answer {
        std::string station;
        std::size_t first;  // index of its first record
        bool listed;        // its list of spectra has begun
        bool spectrum;      // it is a spectrum itself
        // The values read of the enclosing object.
        SpectrumRecord outer_record;
        spotter::Bins outer_bins;
        std::array<bool, kKeys> outer_seen;
    };

    /// Returns the content without NaN, which Python writes and JSON lacks; nothing if it has none.
    static std::string without_nan(std::string_view content) {
        constexpr std::string_view kNan = "NaN";
        constexpr std::string_view kNull = "null";
        std::string out;
        if (content.find(kNan) == std::string_view::npos) return out;
        bool quoted = false;
        for (std::size_t i = 0; i < content.size(); ++i) {
            if (!quoted && content.substr(i).starts_with(kNan)) {
                out += kNull;
                i += kNan.size() - 1;
                continue;
            }
            if (content[i] == '"') quoted = !quoted;
            out += content[i];
            if (quoted && content[i] == '\\' && i + 1 < content.size()) out += content[++i];
        }
        return out;
    }

    Place place() const { return places_.empty() ? Place::outside : places_.back(); }
    bool enter(Place place) {
        if (places_.size() == kMaxDepth) throw fail("is nested more than 64 deep");
        places_.push_back(place);
        return true;
    }
    bool leave() {
        places_.pop_back();
        return true;
    }
    Error fail(const std::string& message) const {
        return text::error_at(ErrorKind::bad_file, source_.name, progress_.line, message);
    }
    /// Records a fault of the current spectrum.
    void blame(const std::string& message) {
        if (record_.fault.empty()) record_.fault = fail(message).what();
    }
    bool describes() const { return place() == Place::spectrum || place() == Place::answer; }
    /// Refuses a required value of the wrong kind; ignores all others.
    bool refuse_known(const std::string& what) {
        const bool known = describes() && index_of(key_);
        if (known || place() == Place::values) blame("'" + key_ + "' has " + what);
        return true;
    }

    bool number(double value, const std::string& spelled) {
        if (place() == Place::values) {
            append(value, spelled);
        } else if (describes() && key_ == kOtherKeys[1]) {
            set_within(record_.latitude, value, spotter::latitude_fault(value, spelled));
        } else if (describes() && key_ == kOtherKeys[2]) {
            set_within(record_.longitude, value, spotter::longitude_fault(value, spelled));
        } else {
            refuse_known("a single number");
        }
        return true;
    }
    void set_within(double& to, double value, const std::string& fault) {
        if (fault.empty()) to = value;
        if (!fault.empty()) blame(fault);
    }
    void append(double value, std::string_view spelled) {
        std::vector<double>& values = bins_[static_cast<std::size_t>(quantity_)];
        if (values.size() == kMaxFrequencies) return blame("more than 4096 frequencies");
        if (++values_ > kMaxValues) throw fail("more than 67108864 values over all records");
        values.push_back(value);
        if (const std::string fault = spotter::fault(quantity_, value, spelled); !fault.empty()) {
            blame(fault);
        }
    }
    void set_time(const std::string& spelled) {
        const std::optional<UtcTime> time = parse_utc_time(spelled);
        if (time) record_.time = time->text();
        if (!time) {
            blame("the time '" + text::printable(spelled, 30) +
                  "' is not UTC like 2018-02-14T00:27:19.000Z");
        }
    }

    void begin_spectrum() {
        record_ = {};
        bins_ = {};
        seen_ = {};
    }
    void end_spectrum() {
        const std::string fault = spotter::fault(bins_);
        if (!fault.empty()) blame("in the spectrum that ends here: " + fault);
        if (!record_.fault.empty()) return add_record();
        if (!spotter::has_spectrum(bins_)) return;
        spotter::set_spectrum(record_, bins_);
        add_record();
    }
    void add_record() {
        if (records_.size() == kMaxRecords) throw fail("more than 100000 records");
        records_.push_back(std::move(record_));
        record_ = {};
    }
    void end_answer() {
        if (answers_.back().spectrum) end_spectrum();
        leave_answer();
    }
    /// Ends an answer. Its station may precede or follow the spectra.
    void leave_answer() {
        Answer answer = std::move(answers_.back());
        answers_.pop_back();
        record_ = std::move(answer.outer_record);
        bins_ = std::move(answer.outer_bins);
        seen_ = answer.outer_seen;
        for (std::size_t i = answer.first; i < records_.size(); ++i) {
            if (records_[i].station.empty()) records_[i].station = answer.station;
        }
    }

    const SpectrumSource& source_;
    Progress progress_;
    std::vector<Place> places_;  // from the outermost
    std::string key_;            // the last
    std::vector<Answer> answers_;
    SpectrumRecord record_;  // that is being read, and its bins
    spotter::Bins bins_;
    std::array<bool, kKeys> seen_{};
    Quantity quantity_ = Quantity::frequency;
    std::size_t values_ = 0;  // over all records
    std::vector<SpectrumRecord> records_;
};

std::vector<SpectrumRecord> read(const SpectrumSource& source) {
    return SpotterJsonReader(source).read();
}

#else

std::vector<SpectrumRecord> read(const SpectrumSource& source) {
    throw text::error_at(ErrorKind::unsupported, source.name, 0,
                         "is JSON, and this libocean was built without nlohmann-json");
}

#endif

/// Recognises an object or a list that contains one of three keys.
bool recognises(std::string_view content) {
    if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos ||
        std::string_view("{[").find(content[first]) == std::string_view::npos) {
        return false;
    }
    const auto has_key = [&](std::string_view key) {
        return content.find("\"" + std::string(key) + "\"") != std::string_view::npos;
    };
    return has_key(kStation) || has_key(kSpectra) || has_key(kDensity);
}

}  // namespace

const SpectrumFormat kSpotterJson = {"Sofar Spotter as JSON", recognises, read};

}  // namespace ocean
