// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Records of the variables of a NetCDF file: see netcdf_records.hpp.
#include "netcdf_records.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bin_directions.hpp"
#include "cf_units.hpp"
#include "direction_sense.hpp"
#include "names.hpp"
#include "netcdf_layout.hpp"
#include "ocean/checked_text.hpp"
#include "ocean/directional_record.hpp"
#include "ocean/grid.hpp"
#include "ocean/record_rules.hpp"
#include "ocean/text.hpp"
#include "quality_flags.hpp"

namespace ocean::netcdf {
namespace {

constexpr double kPerRadian = kPi / 180.0;  // m^2 s/rad in m^2/Hz/degree
/// Bins without a unit that lie within less are radians: their whole circle.
constexpr double kRadianCircle = 6.5;
/// ECMWF's frequencies where the file has only their numbers: f_n = 0.03453 Hz * 1.1^(n - 1).
constexpr double kFirstFrequency = 0.03453;
constexpr double kFrequencyRatio = 1.1;

/// Relative, of frequencies that a file repeats for each record.
constexpr double kSameFrequency = 1e-5;

std::string shown(double value) {
    std::string digits = std::to_string(value);
    return digits.size() > 20 ? digits.substr(0, 20) + "..." : digits;
}

/// 1, 2, 3 ..., or no coordinate at all: numbers of bins.
bool are_numbers(const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] != static_cast<double>(i + 1)) return false;
    }
    return true;
}

std::vector<double> numbers_to(std::size_t count) {
    std::vector<double> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 1.0);
    return numbers;
}

/// What the flags of one variable say in one record.
struct Verdict {
    std::string record_fault;  // if the whole record is bad
    std::vector<bool> bad;     // by frequency of the file; empty where none is
    std::size_t bad_count = 0;
};

class RecordMaker {
  public:
    explicit RecordMaker(const Content& content)
        : content_(content),
          layout_(find_layout(content)),
          spectrum_(content.variables[layout_.spectrum]),
          bins_(content, layout_) {}

    std::vector<SpectrumRecord> make() {
        if (spectrum_.values.empty()) throw fail("has no values");
        read_frequencies();
        if (layout_.direction_dimension) read_directions();
        read_units();
        if (layout_.time) read_time_units();
        for (const std::string& warning : bins_.warnings()) warn(warning);
        for (const auto& [flag, judged] : layout_.flags) {
            flags_.push_back({&content_.variables[flag], &content_.variables[judged],
                              QualityFlags(content_.variables[flag])});
        }
        std::vector<SpectrumRecord> records;
        // The point of the record among all dimensions of the content.
        std::vector<std::size_t> at(content_.dimensions.size(), 0);
        do {
            for (const auto& [place, time] : layout_.parallel_dimensions) at[place] = at[time];
            gather(at);
            if (!has_values()) continue;
            if (records.size() == kMaxRecords) throw fail("more than 100000 records");
            records.push_back(record(at));
        } while (advance(at));
        if (records.empty()) throw fail("all values are missing");
        return records;
    }

  private:
    /// A variable of flags, the one that it judges, and what its flags mean.
    struct Flags {
        const Variable* flags;
        const Variable* judged;
        QualityFlags meaning;
    };

    Fault fail(const std::string& message) const { return {spectrum_.name, message}; }
    const Variable* variable(const std::optional<std::size_t>& index) const {
        return index ? &content_.variables[*index] : nullptr;
    }
    std::size_t size(std::size_t dimension) const { return content_.dimensions[dimension].size; }
    /// Of all records.
    void warn(const std::string& warning) { warnings_.push_back(warning); }

    void read_units() {
        const std::string units = spectrum_.attribute("units");
        const bool directional = layout_.direction_dimension.has_value();
        if (is_ecmwf(spectrum_)) {
            if (!directional) throw fail("has no dimension of directions");
            units_.factor = kPerRadian;
            return;
        }
        if (units.empty()) return assume_units(directional);
        units_ = parse_density_units(
            units, directional ? DensityOver::frequency_and_direction : DensityOver::frequency);
        if (!units_.fault.empty()) throw fail(units_.fault);
        const bool angular = lower_case(units).find("rad") != std::string::npos;
        const bool cyclic = lower_case(units).find("h") != std::string::npos;  // Hz, hertz, cph
        if (directional || !angular_frequency_ || angular || cyclic) return;
        units_.factor *= 2.0 * kPi;
        warn("the density in '" + text::printable(units) +
             "' over frequencies in rad/s is taken as one per rad/s");
    }

    /// wavespectra's convention needs no attributes.
    void assume_units(bool directional) {
        const Variable* direction = variable(layout_.direction);
        units_.factor = directional && radian_bins_ ? kPerRadian : 1.0;
        if (directional && direction != nullptr && direction->name == "dir") return;
        warn(text::printable(spectrum_.name) + " has no unit: m2/Hz" +
             (!directional   ? ""
              : radian_bins_ ? "/rad"
                             : "/degree") +
             " is taken");
    }

    void read_frequencies() {
        const std::size_t count = size(layout_.frequency_dimension);
        if (count < 2) throw fail("has fewer than 2 frequencies");
        if (count > kMaxFrequencies) throw fail("has more than 4096 frequencies");
        const Variable* v = variable(layout_.frequency);
        frequency_ = v != nullptr ? frequencies_of(*v, count) : numbers_to(count);
        if (is_ecmwf(spectrum_) && are_numbers(frequency_)) {
            for (double& f : frequency_) f = kFirstFrequency * std::pow(kFrequencyRatio, f - 1.0);
        } else if (v == nullptr) {
            throw fail("has no variable with its frequencies");
        } else {
            to_hertz(*v);
        }
        frequency_order_.resize(count);
        std::iota(frequency_order_.begin(), frequency_order_.end(), std::size_t{0});
        std::stable_sort(frequency_order_.begin(), frequency_order_.end(),
                         [&](auto a, auto b) { return frequency_[a] < frequency_[b]; });
        std::sort(frequency_.begin(), frequency_.end());
        if (std::adjacent_find(frequency_.begin(), frequency_.end()) != frequency_.end()) {
            throw Fault(v != nullptr ? v->name : spectrum_.name, "a frequency is there twice");
        }
    }

    /// A file may repeat its frequencies for each record.
    std::vector<double> frequencies_of(const Variable& v, std::size_t count) const {
        if (v.dimensions.size() == 1) return v.values;
        std::vector<double> found(count, kMissing);
        const std::size_t step = stride(v, layout_.frequency_dimension);
        for (std::size_t i = 0; i < v.values.size(); ++i) {
            double& known = found[i / step % count];
            const double value = v.values[i];
            if (std::isnan(known)) known = value;
            if (std::abs(value - known) > kSameFrequency * std::abs(known)) {
                throw Fault(v.name, "the frequencies of the records differ: " + shown(known) +
                                        " and " + shown(value));
            }
        }
        return found;
    }

    void to_hertz(const Variable& v) {
        const std::string units = v.attribute("units");
        if (!units.empty()) {
            // What is per frequency shrinks by as much as the frequency grows.
            const DensityUnit per =
                parse_density_unit("m2/(" + units + ")", DensityOver::frequency);
            if (!per.fault.empty()) {
                throw Fault(v.name, "units '" + text::printable(units) +
                                        "'; allowed: Hz, s-1, rad/s and the like");
            }
            for (double& f : frequency_) f /= per.factor;
            angular_frequency_ = lower_case(units).find("rad") != std::string::npos;
        }
        for (const double f : frequency_) {
            if (f == 0.0 || (f >= kMinFrequency && f <= kMaxFrequency)) continue;
            throw Fault(v.name, "a frequency of " + shown(f) +
                                    "; allowed: " + std::string(kFrequencyRange));
        }
    }

    void read_directions() {
        const std::size_t count = size(*layout_.direction_dimension);
        const Variable* v = variable(layout_.direction);
        const std::string& name = v != nullptr ? v->name : spectrum_.name;
        std::vector<double> degrees = v != nullptr ? v->values : numbers_to(count);
        if (is_ecmwf(spectrum_) && are_numbers(degrees)) {
            if (count != 12 && count != 24 && count != 36) {
                throw Fault(name,
                            std::to_string(count) + " numbered directions; ECMWF has 12, 24 or 36");
            }
            const double step = 360.0 / static_cast<double>(count);
            for (double& d : degrees) d = step * (d - 0.5);
        } else if (v == nullptr) {
            throw fail("has no variable with its directions");
        } else {
            to_degrees(*v, degrees);
        }
        if (const std::string fault = DirectionAxis::fault(degrees); !fault.empty()) {
            throw Fault(name, fault);
        }
        // A sector gets two directions more.
        if (frequency_.size() * (count + 2) > kMaxDirectionalValues) {
            throw fail("more than 131072 values over frequency and direction");
        }
        const DirectionSense sense = bin_sense();
        for (double& d : degrees) d = sense.travel(d);
        axis_.emplace(degrees, DirectionConvention::to_cartesian);
    }

    void to_degrees(const Variable& v, std::vector<double>& values) {
        double scale = degrees_per_unit(v);
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        if (v.attribute("units").empty() && values.size() > 3 && *most - *least < kRadianCircle) {
            scale = 180.0 / kPi;
            warn("the directions '" + text::printable(v.name) + "' have no unit and lie within " +
                 shown(*most - *least) + ": they are taken as radians");
        }
        radian_bins_ = scale != 1.0;
        for (double& value : values) value *= scale;
    }

    /// What the writers mean whose names the file has, where words are silent: ECMWF and WAVEWATCH
    /// III travel to, wavespectra's `dir` comes from.
    std::optional<DirectionSense> writer_sense(const Variable* direction) const {
        if (is_ecmwf(spectrum_)) return kTravellingTo;
        if (spectrum_.name != "efth" || direction == nullptr) return std::nullopt;
        if (direction->name == "dir") return kComingFrom;
        const auto is_wavewatch = [](const auto& attribute) {
            return attribute.first == "globwave_name" ||
                   lower_case(attribute.first).find("wavewatch") != std::string::npos;
        };
        const bool wavewatch =
            std::any_of(spectrum_.attributes.begin(), spectrum_.attributes.end(), is_wavewatch) ||
            std::any_of(content_.attributes.begin(), content_.attributes.end(), is_wavewatch);
        return wavewatch ? std::optional(kTravellingTo) : std::nullopt;
    }

    DirectionSense bin_sense() {
        const Variable* v = variable(layout_.direction);
        const auto writer = writer_sense(v);
        if (v == nullptr) return writer.value_or(kComingFrom);
        const FoundSense found = direction_sense(content_, *v, spectrum_, writer);
        if (!found.warning.empty()) warn(found.warning);
        if (!found.told) warn(silent_directions(*v, found.sense));
        return found.sense;
    }

    void read_time_units() {
        const Variable& v = *variable(layout_.time);
        std::string calendar = v.attribute("calendar");
        calendar = lower_case(calendar);
        // SWAN calls the usual calendar so: its seconds are those since 1970.
        if (calendar == "julian") {
            if (!is_swan(content_, spectrum_)) {
                warn("the calendar 'julian' is taken as the usual one, as SWAN means it");
            }
            calendar.clear();
        }
        if (!calendar.empty() && calendar != "standard" && calendar != "gregorian" &&
            calendar != "proleptic_gregorian") {
            throw Fault(v.name, "calendar '" + text::printable(calendar) +
                                    "'; allowed: standard, gregorian, proleptic_gregorian");
        }
        const std::string units = v.attribute("units");
        const std::optional<TimeUnits> parsed = parse_time_units(units);
        if (!parsed) {
            throw Fault(v.name, "units '" + text::printable(units) +
                                    "'; allowed: seconds, minutes, hours or days since a date in "
                                    "UTC from 1800 on, like 1990-01-01 00:00:00");
        }
        time_units_ = *parsed;
    }

    /// Of an element, and of a step along a dimension. A variable of the content has few enough
    /// values that neither overflows.
    std::size_t offset(const Variable& v, const std::vector<std::size_t>& at) const {
        std::size_t result = 0;
        for (const std::size_t d : v.dimensions) result = result * size(d) + at[d];
        return result;
    }
    std::size_t stride(const Variable& v, std::size_t dimension) const {
        std::size_t result = 1;
        for (std::size_t k = v.dimensions.size(); v.dimensions[k - 1] != dimension; --k) {
            result *= size(v.dimensions[k - 1]);
        }
        return result;
    }
    bool advance(std::vector<std::size_t>& at) const {
        for (std::size_t k = layout_.outer_dimensions.size(); k-- > 0;) {
            const std::size_t d = layout_.outer_dimensions[k];
            if (++at[d] < size(d)) return true;
            at[d] = 0;
        }
        return false;
    }

    /// The spectrum at a point into gathered_: [frequency, ascending][direction, as in the file].
    void gather(const std::vector<std::size_t>& at) {
        const std::size_t origin = offset(spectrum_, at);
        const std::size_t row = stride(spectrum_, layout_.frequency_dimension);
        const auto& direction = layout_.direction_dimension;
        const std::size_t step = direction ? stride(spectrum_, *direction) : 0;
        const std::size_t width = direction ? size(*direction) : 1;
        gathered_.clear();
        for (const std::size_t i : frequency_order_) {
            for (std::size_t j = 0; j < width; ++j) {
                gathered_.push_back(spectrum_.values[origin + i * row + j * step]);
            }
        }
    }
    /// Without directions a missing bin is left out, and a spectrum has two at least.
    bool has_values() const {
        const auto missing = std::count_if(gathered_.begin(), gathered_.end(),
                                           [](double value) { return std::isnan(value); });
        const std::size_t present = gathered_.size() - static_cast<std::size_t>(missing);
        return present >= (axis_ ? 1u : 2u);
    }

    /// Of a record that cannot be used, time and place alone.
    SpectrumRecord record(const std::vector<std::size_t>& at) {
        SpectrumRecord result;
        try {
            describe(result, at);
            result.warnings = warnings_;
            fill(result, at);
            clean_record(result);
            const std::string fault = record_fault(result);
            if (!fault.empty()) throw fail(label(result) + fault);
        } catch (const Fault& fault) {
            SpectrumRecord bad;
            bad.station = result.station;
            bad.time = result.time;
            bad.latitude = result.latitude;
            bad.longitude = result.longitude;
            bad.depth = result.depth;
            bad.fault = fault.what();
            return bad;
        }
        if (result.warnings.size() > kMaxRecordWarnings) result.warnings.resize(kMaxRecordWarnings);
        return result;
    }

    void fill(SpectrumRecord& result, std::vector<std::size_t> at) {
        const Verdict verdict = judge(result, spectrum_, at);
        if (!verdict.record_fault.empty()) throw Fault(verdict.record_fault);
        const double scale = layout_.scale ? value_at(variable(layout_.scale), at) : 1.0;
        for (double& value : gathered_) value = density(value * scale, result);
        if (axis_) return fill_directions(result, verdict);

        std::vector<std::pair<const Variable*, Verdict>> bin_verdicts;
        for (const auto& bin : layout_.bins) {
            if (const Variable* v = variable(bin))
                bin_verdicts.emplace_back(v, judge(result, *v, at));
        }
        const auto value_of = [&](const Variable& v) {
            for (const auto& [judged, said] : bin_verdicts) {
                const bool bad = judged == &v &&
                                 (!said.record_fault.empty() ||
                                  (!said.bad.empty() && said.bad[at[layout_.frequency_dimension]]));
                if (bad) return kMissing;
            }
            return v.values[offset(v, at)];
        };
        for (std::size_t i = 0; i < frequency_.size(); ++i) {
            const std::size_t band = frequency_order_[i];
            const bool bad = !verdict.bad.empty() && verdict.bad[band];
            if (std::isnan(gathered_[i]) || bad) continue;  // as if the bin were not there
            result.frequency.push_back(frequency_[i]);
            result.density.push_back(gathered_[i] * units_.factor);
            at[layout_.frequency_dimension] = band;
            try {
                bins_.append(result, value_of);
            } catch (const Fault& fault) {
                throw Fault(label(result) + fault.what());
            }
        }
        drop_unknown_moments(result);
    }

    void fill_directions(SpectrumRecord& result, const Verdict& verdict) {
        if (verdict.bad.empty()) {
            result.frequency = frequency_;
        } else {
            const std::size_t width = gathered_.size() / frequency_.size();
            std::vector<double> good;
            for (std::size_t i = 0; i < frequency_.size(); ++i) {
                if (verdict.bad[frequency_order_[i]]) continue;
                const auto row = gathered_.begin() + static_cast<std::ptrdiff_t>(i * width);
                good.insert(good.end(), row, row + static_cast<std::ptrdiff_t>(width));
                result.frequency.push_back(frequency_[i]);
            }
            gathered_ = std::move(good);
        }
        axis_->fill(result, gathered_, units_.factor);
    }

    /// What the flags of a variable say; warns of those of the spectrum.
    Verdict judge(SpectrumRecord& result, const Variable& judged,
                  std::vector<std::size_t> at) const {
        Verdict verdict;
        for (const Flags& flags : flags_) {
            if (flags.judged != &judged) continue;
            const std::vector<std::size_t>& over = flags.flags->dimensions;
            const bool by_frequency =
                std::find(over.begin(), over.end(), layout_.frequency_dimension) != over.end();
            const std::size_t count = by_frequency ? frequency_.size() : 1;
            std::size_t bad = 0;
            std::size_t doubtful = 0;
            for (std::size_t k = 0; k < count; ++k) {
                at[layout_.frequency_dimension] = k;
                const double flag = flags.flags->values[offset(*flags.flags, at)];
                const Quality quality = flags.meaning.quality(flag);
                doubtful += quality == Quality::doubtful ? 1 : 0;
                if (quality != Quality::bad) continue;
                ++bad;
                if (!by_frequency) {
                    verdict.record_fault = flags.flags->name + ": " + label(result) +
                                           "its flag is " + shortest_text(flag) + ", bad";
                    continue;
                }
                verdict.bad.resize(count);
                verdict.bad[k] = true;
            }
            if (&judged != &spectrum_) continue;
            const std::string name = text::printable(flags.flags->name);
            const std::string bands =
                by_frequency ? " of " + std::to_string(count) + " frequencies" : "";
            if (by_frequency && bad > 0) {
                result.warnings.push_back(std::to_string(bad) + bands + " are flagged as bad by " +
                                          name + ": they are left out");
            }
            if (by_frequency && doubtful > 0) {
                result.warnings.push_back(std::to_string(doubtful) + bands +
                                          " are flagged as doubtful by " + name +
                                          ": they are taken as they are");
            } else if (doubtful > 0) {
                result.warnings.push_back("the record is flagged as doubtful by " + name +
                                          ": it is taken as it is");
            }
        }
        return verdict;
    }

    static std::string label(const SpectrumRecord& record) {
        return "record " + record.time + (record.station.empty() ? "" : " " + record.station) +
               ": ";
    }

    double density(double value, const SpectrumRecord& record) const {
        if (is_ecmwf(spectrum_)) value = std::pow(10.0, value);
        // The offset keeps zeros finite in the file; rounding may fall below it.
        if (units_.log10) value = std::max(std::pow(10.0, value) - 1e-12, 0.0);
        if (std::isnan(value) || std::abs(value) <= 1e8) return value;
        throw fail(label(record) + "a density of " + shown(value) +
                   "; allowed: 0 .. 1e6 m^2/Hz/degree");
    }

    double value_at(const Variable* v, const std::vector<std::size_t>& at) const {
        return v == nullptr ? kMissing : v->values[offset(*v, at)];
    }

    void describe(SpectrumRecord& record, const std::vector<std::size_t>& at) const {
        record.station = station(at);
        if (const Variable* v = variable(layout_.time)) {
            const std::optional<UtcTime> time = time_at(time_units_, value_at(v, at));
            if (!time) throw Fault(v->name, shown(value_at(v, at)) + " is no time in 1800 .. 2999");
            record.time = time->text();
        }
        record.latitude = within(layout_.latitude, at, -90.0, 90.0);
        record.longitude = within(layout_.longitude, at, -180.0, 360.0);
        record.depth = within(layout_.depth, at, -12000.0, 12000.0);
        if (record.depth < 0.01) record.depth = kMissing;  // dry, or a height
    }

    double within(const std::optional<std::size_t>& index, const std::vector<std::size_t>& at,
                  double low, double high) const {
        const Variable* v = variable(index);
        const double value = value_at(v, at);
        if (std::isnan(value) || (value >= low && value <= high)) return value;
        throw Fault(v->name, shown(value) + " is not within " + std::to_string(std::lround(low)) +
                                 " .. " + std::to_string(std::lround(high)));
    }

    /// The station of all records, as attributes of the file have it.
    std::string file_station() const {
        for (const char* key : {"station", "platform_code", "wmo_platform_code", "site_code",
                                "station_id", "cdip_station_id", "station_name", "wmo_id"}) {
            const auto found = content_.attributes.find(key);
            if (found != content_.attributes.end()) return text::printable(found->second);
        }
        return "";
    }

    /// Numbers are names where there are no others.
    std::string station(const std::vector<std::size_t>& at) const {
        const Variable* v = variable(layout_.station);
        if (v == nullptr) return file_station();
        if (v->is_text) return text::printable(v->texts[offset(*v, at)]);
        const double number = value_at(v, at);
        const bool whole = std::abs(number) < 1e9 && number == std::floor(number);
        return whole ? std::to_string(std::lround(number)) : "";
    }

    const Content& content_;
    const Layout layout_;
    const Variable& spectrum_;
    DensityUnits units_;
    TimeUnits time_units_;
    std::vector<double> frequency_;             // ascending
    std::vector<std::size_t> frequency_order_;  // of the file, in that order
    bool angular_frequency_ = false;
    std::optional<DirectionAxis> axis_;
    bool radian_bins_ = false;
    BinDirections bins_;
    std::vector<Flags> flags_;
    std::vector<std::string> warnings_;
    std::vector<double> gathered_;
};

}  // namespace

std::vector<SpectrumRecord> records_from(const Content& content) {
    return RecordMaker(content).make();
}

}  // namespace ocean::netcdf
