// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spectra of Spotter buoys as JSON, as the interface of their maker answers:
//   {"data": {"spotterId": "SPOT-0070", "frequencyData": [{"timestamp": "2018-02-14T00:27:19.000Z",
//    "latitude": -61.09, "longitude": 173.42, "frequency": [...], "varianceDensity": [...],
//    "a1": [...], "b1": [...], "a2": [...], "b2": [...], "direction": [...],
//    "directionalSpread": [...]}, ...]}}
// Each list has a value for each frequency, null = missing; all other keys are passed over. What is
// in `data` may also stand outside of it. The moments are those of the travel direction, from east.
// The file is read as a stream of events: nothing is kept but what is asked for, however deep or
// long the rest is.
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#ifdef OCEAN_HAVE_JSON
#include <nlohmann/json.hpp>
#endif

#include "ocean/checked_text.hpp"
#include "ocean/utc_time.hpp"
#include "spectrum_format.hpp"
#include "spotter.hpp"

namespace ocean {
namespace {

constexpr std::string_view kStation = "spotterId";
constexpr std::string_view kSpectra = "frequencyData";

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

/// Of a spectrum: its quantity, or one of the other keys after them; nothing for others.
std::optional<std::size_t> index_of(std::string_view key) {
    for (std::size_t i = 0; i < kKeys; ++i) {
        const bool quantity = i < spotter::kQuantities;
        if (key == (quantity ? spotter::kNames[i] : kOtherKeys[i - spotter::kQuantities])) return i;
    }
    return std::nullopt;
}

/// How far the parser has come.
struct Progress {
    std::size_t line = 1;  // of the last character that it took
    char last = '\0';
    bool at_end = false;
};

/// Characters for the parser, which tells its handler nothing of lines.
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
        const char* begin = source_.content.data();
        const char* end = begin + source_.content.size();
        nlohmann::json::sax_parse(CountingIterator(begin, end, progress_),
                                  CountingIterator(end, end, progress_), this);
        for (SpectrumRecord& record : records_) record.station = station_;
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
        if (place() == Place::top && key_ == kStation) {
            station_ = text::printable(value);
        } else if (place() == Place::spectrum && key_ == kOtherKeys[0]) {
            record_.time = time_of(value);
        } else {
            refuse_known("a text");
        }
        return true;
    }

    bool key(std::string& value) override {
        key_ = value;
        const std::optional<std::size_t> known = index_of(key_);
        if (place() != Place::spectrum || !known) return true;
        if (seen_[*known]) throw fail("'" + key_ + "' is there twice in one spectrum");
        seen_[*known] = true;
        return true;
    }
    bool start_object(std::size_t) override {
        if (place() == Place::spectra) {
            record_ = {};
            bins_ = {};
            seen_ = {};
            return enter(Place::spectrum);
        }
        refuse_known("an object");
        const bool data = places_.empty() || (place() == Place::top && key_ == "data");
        return enter(data ? Place::top : Place::other);
    }
    bool end_object() override {
        if (place() == Place::spectrum) end_spectrum();
        return leave();
    }
    bool start_array(std::size_t) override {
        if (place() == Place::top && key_ == kSpectra) {
            if (listed_) throw fail("'" + key_ + "' is there twice");
            listed_ = true;
            return enter(Place::spectra);
        }
        if (place() == Place::spectrum) {
            const std::optional<std::size_t> known = index_of(key_);
            if (known && *known < spotter::kQuantities) {
                quantity_ = static_cast<Quantity>(*known);
                return enter(Place::values);
            }
        }
        refuse_known("a list");
        return enter(Place::other);
    }
    bool end_array() override { return leave(); }

    bool parse_error(std::size_t, const std::string& token,
                     const nlohmann::detail::exception& error) override {
        if (error.id == kOutOfRange) {
            throw fail("the number '" + text::printable(token, 20) + "' is out of range");
        }
        if (progress_.at_end) throw fail("the file ends where its JSON does not");
        const std::string_view last(&progress_.last, 1);
        throw fail("'" + text::printable(last) + "' is not what JSON has here");
    }

  private:
    /// top: the outermost object and its `data`; spectra: the list of them; values: of a quantity.
    enum class Place { outside, top, spectra, spectrum, values, other };

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
    /// Only what is asked for must be of the right kind.
    bool refuse_known(const std::string& what) const {
        const bool known = place() == Place::spectrum && index_of(key_);
        if (known || place() == Place::values) throw fail("'" + key_ + "' has " + what);
        return true;
    }

    bool number(double value, const std::string& spelled) {
        if (place() == Place::values) {
            append(value, spelled);
            return true;
        }
        if (place() != Place::spectrum) return true;
        if (key_ == kOtherKeys[1]) {
            record_.latitude = within(value, spotter::latitude_fault(value, spelled));
        } else if (key_ == kOtherKeys[2]) {
            record_.longitude = within(value, spotter::longitude_fault(value, spelled));
        } else {
            refuse_known("a single number");
        }
        return true;
    }
    double within(double value, const std::string& fault) const {
        if (!fault.empty()) throw fail(fault);
        return value;
    }
    void append(double value, std::string_view spelled) {
        std::vector<double>& values = bins_[static_cast<std::size_t>(quantity_)];
        if (values.size() == kMaxFrequencies) throw fail("more than 4096 frequencies");
        if (++values_ > kMaxValues) throw fail("more than 67108864 values over all records");
        values.push_back(within(value, spotter::fault(quantity_, value, spelled)));
    }
    std::string time_of(const std::string& spelled) const {
        const std::optional<UtcTime> time = parse_utc_time(spelled);
        if (time) return time->text();
        throw fail("the time '" + text::printable(spelled, 30) +
                   "' is not UTC like 2018-02-14T00:27:19.000Z");
    }

    void end_spectrum() {
        const std::string fault = spotter::fault(bins_);
        if (!fault.empty()) throw fail("in the spectrum that ends here: " + fault);
        if (!spotter::has_spectrum(bins_)) return;
        if (records_.size() == kMaxRecords) throw fail("more than 100000 records");
        spotter::set_spectrum(record_, bins_);
        records_.push_back(std::move(record_));
    }

    const SpectrumSource& source_;
    Progress progress_;
    std::vector<Place> places_;  // from the outermost
    std::string key_;            // the last
    bool listed_ = false;        // the list of spectra has begun
    std::string station_;
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

/// An object with one of two keys somewhere.
bool recognises(std::string_view content) {
    if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || content[first] != '{') return false;
    const auto has_key = [&](std::string_view key) {
        return content.find("\"" + std::string(key) + "\"") != std::string_view::npos;
    };
    return has_key(kStation) || has_key(kSpectra);
}

}  // namespace

const SpectrumFormat kSpotterJson = {"Sofar Spotter as JSON", recognises, read};

}  // namespace ocean
