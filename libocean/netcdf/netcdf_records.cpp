// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Records of the variables of a NetCDF file: see netcdf_records.hpp.
#include "netcdf_records.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cf_units.hpp"
#include "netcdf_layout.hpp"
#include "ocean/checked_text.hpp"
#include "ocean/directional_record.hpp"
#include "ocean/grid.hpp"
#include "ocean/record_rules.hpp"

namespace ocean::netcdf {
namespace {

constexpr double kPerRadian = kPi / 180.0;  // m^2 s/rad in m^2/Hz/degree
/// ECMWF's frequencies where the file has only their numbers: f_n = 0.03453 Hz * 1.1^(n - 1).
constexpr double kFirstFrequency = 0.03453;
constexpr double kFrequencyRatio = 1.1;

/// Where a scale factor may put 360 degrees, and two digits r1 and r2.
constexpr double kMaxDirection = 360.001;
constexpr double kMaxRatio = 1.05;

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

class RecordMaker {
  public:
    explicit RecordMaker(const Content& content)
        : content_(content),
          layout_(find_layout(content)),
          spectrum_(content.variables[layout_.spectrum]) {}

    std::vector<SpectrumRecord> make() {
        if (spectrum_.values.empty()) throw fail("has no values");
        read_units();
        read_frequencies();
        if (layout_.direction_dimension) read_directions();
        if (layout_.time) read_time_units();
        std::vector<SpectrumRecord> records;
        // The point of the record among all dimensions of the content.
        std::vector<std::size_t> at(content_.dimensions.size(), 0);
        do {
            gather(at);
            if (!has_values()) continue;
            if (records.size() == kMaxRecords) throw fail("more than 100000 records");
            records.push_back(record(at));
        } while (advance(at));
        if (records.empty()) throw fail("all values are missing");
        return records;
    }

  private:
    Fault fail(const std::string& message) const { return {spectrum_.name, message}; }
    const Variable* variable(const std::optional<std::size_t>& index) const {
        return index ? &content_.variables[*index] : nullptr;
    }
    std::size_t size(std::size_t dimension) const { return content_.dimensions[dimension].size; }

    void read_units() {
        const std::string units = spectrum_.attribute("units");
        const bool directional = layout_.direction_dimension.has_value();
        const Variable* direction = variable(layout_.direction);
        using Angle = DensityUnits::Angle;
        if (is_ecmwf(spectrum_)) {
            units_.angle = Angle::radian;
            if (!directional) throw fail("has no dimension of directions");
            return;
        }
        // wavespectra's convention needs no attributes.
        if (units.empty() && directional && direction != nullptr && direction->name == "dir") {
            units_.angle = Angle::degree;
            return;
        }
        const std::optional<DensityUnits> parsed = parse_density_units(units);
        if (!parsed && !(units.empty() && !directional)) {
            throw fail("units '" + text::printable(units) +
                       "'; allowed: m2 s degree-1, m2 s rad-1, m2/Hz/deg and the like, without "
                       "directions m2 s, m2/Hz");
        }
        if (parsed) units_ = *parsed;
        if (directional != (units_.angle != Angle::none)) {
            throw fail("units '" + text::printable(units) + "' of a spectrum " +
                       (directional ? "over" : "without") + " directions");
        }
    }

    void read_frequencies() {
        const std::size_t count = size(layout_.frequency_dimension);
        if (count < 2) throw fail("has fewer than 2 frequencies");
        if (count > kMaxFrequencies) throw fail("has more than 4096 frequencies");
        const Variable* v = variable(layout_.frequency);
        frequency_ = v != nullptr ? v->values : numbers_to(count);
        if (is_ecmwf(spectrum_) && are_numbers(frequency_)) {
            for (double& f : frequency_) f = kFirstFrequency * std::pow(kFrequencyRatio, f - 1.0);
        } else if (v == nullptr) {
            throw fail("has no variable with its frequencies");
        } else {
            check_frequencies(*v);
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

    void check_frequencies(const Variable& v) const {
        const std::string units = v.attribute("units");
        for (const char* known :
             {"", "Hz", "hz", "hertz", "Hertz", "s-1", "s**-1", "s^-1", "1/s"}) {
            if (units != known) continue;
            for (const double f : frequency_) {
                if (f >= kMinFrequency && f <= kMaxFrequency) continue;
                throw Fault(v.name, "a frequency of " + shown(f) +
                                        "; allowed: " + std::string(kFrequencyRange));
            }
            return;
        }
        throw Fault(v.name, "units '" + text::printable(units) + "'; allowed: Hz, s-1");
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
        axis_.emplace(degrees, convention());
    }

    static void to_degrees(const Variable& v, std::vector<double>& values) {
        const std::string units = v.attribute("units");
        if (units.empty() || units.starts_with("deg")) return;
        if (!units.starts_with("rad")) {
            throw Fault(v.name, "units '" + text::printable(units) + "'; allowed: degree, radian");
        }
        for (double& value : values) value *= 180.0 / kPi;
    }

    DirectionConvention convention() const {
        const Variable* v = variable(layout_.direction);
        if (v != nullptr) {
            for (const char* key : {"standard_name", "long_name"}) {
                std::string words = v->attribute(key);
                std::replace(words.begin(), words.end(), ' ', '_');
                if (words.find("to_direction") != std::string::npos) {
                    return DirectionConvention::to_nautical;
                }
                if (words.find("from_direction") != std::string::npos) {
                    return DirectionConvention::from_nautical;
                }
            }
        }
        const bool travel = is_ecmwf(spectrum_) || (v != nullptr && v->name == "direction");
        return travel ? DirectionConvention::to_nautical : DirectionConvention::from_nautical;
    }

    void read_time_units() {
        const Variable& v = *variable(layout_.time);
        std::string calendar = v.attribute("calendar");
        for (char& c : calendar) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
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

    SpectrumRecord record(const std::vector<std::size_t>& at) {
        SpectrumRecord result;
        describe(result, at);
        for (double& value : gathered_) value = density(value, result);
        if (axis_) {
            using Angle = DensityUnits::Angle;
            result.frequency = frequency_;
            axis_->fill(result, gathered_, units_.angle == Angle::radian ? kPerRadian : 1.0);
        } else {
            for (std::size_t i = 0; i < frequency_.size(); ++i) {
                if (std::isnan(gathered_[i])) continue;  // as if the bin were not there
                result.frequency.push_back(frequency_[i]);
                result.density.push_back(gathered_[i]);
                if (layout_.buoy_directions) append_directions(result, at, i);
            }
            drop_unknown_moments(result);
        }
        const std::string fault = record_fault(result);
        if (!fault.empty()) throw fail(label(result) + fault);
        return result;
    }

    /// NDBC's four quantities of a bin: where waves come from, degrees clockwise from north, twice,
    /// and two ratios.
    void append_directions(SpectrumRecord& record, std::vector<std::size_t> at,
                           std::size_t bin) const {
        at[layout_.frequency_dimension] = frequency_order_[bin];
        const auto value = [&](std::size_t k, double most) {
            const Variable& v = content_.variables[(*layout_.buoy_directions)[k]];
            const double read = value_at(&v, at);
            if (std::isnan(read) || (read >= 0.0 && read <= most)) return read;
            throw Fault(v.name, label(record) + shown(read) + "; allowed: 0 .. " +
                                    std::to_string(std::lround(most)));
        };
        const auto travel = [&](std::size_t k) {
            return travel_direction(value(k, kMaxDirection), DirectionConvention::from_nautical);
        };
        const auto ratio = [&](std::size_t k) { return std::min(value(k, kMaxRatio), 1.0); };
        append_mean_and_principal(record, travel(0), travel(1), ratio(2), ratio(3));
    }

    static std::string label(const SpectrumRecord& record) {
        return "record " + record.time + (record.station.empty() ? "" : " " + record.station) +
               ": ";
    }

    double density(double value, const SpectrumRecord& record) const {
        if (is_ecmwf(spectrum_)) value = std::pow(10.0, value);
        // The offset keeps zeros finite in the file; rounding may fall below it.
        if (units_.log10) value = std::max(std::pow(10.0, value) - 1e-12, 0.0);
        if (std::isnan(value) || (value >= 0.0 && value <= 1e8)) return value;
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

    /// Numbers are names where there are no others.
    std::string station(const std::vector<std::size_t>& at) const {
        const Variable* v = variable(layout_.station);
        if (v == nullptr) return "";
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
    std::optional<DirectionAxis> axis_;
    std::vector<double> gathered_;
};

}  // namespace

std::vector<SpectrumRecord> records_from(const Content& content) {
    return RecordMaker(content).make();
}

}  // namespace ocean::netcdf
