// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Axes of a spectrum: see spectrum_axes.hpp.
#include "spectrum_axes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bin_directions.hpp"
#include "direction_sense.hpp"
#include "names.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/density_units.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/record_rules.hpp"

namespace ocean::netcdf {
namespace {

/// ECMWF's frequencies for a file with their numbers alone: f_n = 0.03453 Hz * 1.1^(n - 1).
constexpr double kFirstFrequency = 0.03453;
constexpr double kFrequencyRatio = 1.1;
/// The relative tolerance between frequencies that a file repeats for each record.
constexpr double kSameFrequency = 1e-5;
/// Bins without a unit that span less than this are radians.
constexpr double kRadianCircle = 6.5;

/// Returns true for 1, 2, 3 ...: numbers of bins, which also stand in for a missing coordinate.
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

class AxisReader {
  public:
    AxisReader(const Content& content, const Layout& layout)
        : content_(content), layout_(layout), spectrum_(content.variables[layout.spectrum]) {}

    SpectrumAxes read() {
        read_frequencies();
        if (layout_.direction_dimension) read_directions();
        return std::move(axes_);
    }

  private:
    Fault fail(const std::string& message) const { return {spectrum_.name, message}; }
    const Variable* variable(const std::optional<std::size_t>& index) const {
        return index ? &content_.variables[*index] : nullptr;
    }
    std::size_t size(std::size_t dimension) const { return content_.dimensions[dimension].size; }
    void warn(const std::string& warning) { axes_.warnings.push_back(warning); }

    void read_frequencies() {
        const std::size_t count = size(layout_.frequency_dimension);
        if (count < 2) throw fail("has fewer than 2 frequencies");
        if (count > kMaxFrequencies) throw fail("has more than 4096 frequencies");
        const Variable* v = variable(layout_.frequency);
        axes_.frequency = v != nullptr ? frequencies_of(*v, count) : numbers_to(count);
        if (is_ecmwf(spectrum_) && are_numbers(axes_.frequency)) {
            for (double& f : axes_.frequency)
                f = kFirstFrequency * std::pow(kFrequencyRatio, f - 1.0);
        } else if (v == nullptr) {
            throw fail("has no variable with its frequencies");
        } else {
            to_hertz(*v);
        }
        axes_.frequency_order.resize(count);
        std::iota(axes_.frequency_order.begin(), axes_.frequency_order.end(), std::size_t{0});
        std::stable_sort(axes_.frequency_order.begin(), axes_.frequency_order.end(),
                         [&](auto a, auto b) { return axes_.frequency[a] < axes_.frequency[b]; });
        std::sort(axes_.frequency.begin(), axes_.frequency.end());
        if (std::adjacent_find(axes_.frequency.begin(), axes_.frequency.end()) !=
            axes_.frequency.end()) {
            throw Fault(v != nullptr ? v->name : spectrum_.name, "a frequency is there twice");
        }
    }

    /// Reads the frequencies, which a file may repeat for each record.
    std::vector<double> frequencies_of(const Variable& v, std::size_t count) const {
        if (v.dimensions.size() == 1) return v.values;
        std::vector<double> found(count, kMissing);
        const std::size_t step = stride(content_, v, layout_.frequency_dimension);
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
            // A density per frequency scales inversely to the frequency.
            const DensityUnit per =
                parse_density_unit("m2/(" + units + ")", DensityOver::frequency);
            if (!per.fault.empty()) {
                throw Fault(v.name, "units '" + text::printable(units) +
                                        "'; allowed: Hz, s-1, rad/s and the like");
            }
            for (double& f : axes_.frequency) f /= per.factor;
            axes_.angular_frequency = lower_case(units).find("rad") != std::string::npos;
        }
        for (const double f : axes_.frequency) {
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
        // A sector gets two further directions.
        if (axes_.frequency.size() * (count + 2) > kMaxDirectionalValues) {
            throw fail("more than 131072 values over frequency and direction");
        }
        const DirectionSense sense = bin_sense();
        for (double& d : degrees) d = sense.travel(d);
        axes_.directions.emplace(degrees, DirectionConvention::to_cartesian);
    }

    void to_degrees(const Variable& v, std::vector<double>& values) {
        double scale = degrees_per_unit(v);
        const auto [min, max] = std::minmax_element(values.begin(), values.end());
        if (v.attribute("units").empty() && values.size() > 3 && *max - *min < kRadianCircle) {
            scale = 180.0 / kPi;
            warn("the directions '" + text::printable(v.name) + "' have no unit and lie within " +
                 shown(*max - *min) + ": they are taken as radians");
        }
        axes_.radian_bins = scale != 1.0;
        for (double& value : values) value *= scale;
    }

    /// Returns the convention of the writer whose names the file has, for a file without words:
    /// ECMWF and WAVEWATCH III give the direction waves travel to, wavespectra's `dir` the one they
    /// come from.
    std::optional<DirectionSense> writer_sense(const Variable* direction) const {
        if (is_ecmwf(spectrum_)) return kTravellingTo;
        if (spectrum_.name != "efth" || direction == nullptr) return std::nullopt;
        if (direction->name == "dir") return kComingFrom;
        const auto is_wavewatch = [](const auto& attribute) {
            const auto& [key, text] = attribute;
            const bool names_model =
                among(lower_case(key), {"title", "source", "product_name", "product", "model"});
            const std::string told = lower_case(names_model ? text : key);
            return key == "globwave_name" || told.find("wavewatch") != std::string::npos ||
                   (names_model && told.find("ww3") != std::string::npos);
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

    const Content& content_;
    const Layout& layout_;
    const Variable& spectrum_;
    SpectrumAxes axes_;
};

}  // namespace

SpectrumAxes read_axes(const Content& content, const Layout& layout) {
    return AxisReader(content, layout).read();
}

}  // namespace ocean::netcdf
