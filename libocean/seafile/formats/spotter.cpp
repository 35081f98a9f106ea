// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From the values of a Spotter to a record: see spotter.hpp.
#include "spotter.hpp"

#include <cmath>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/directional_record.hpp"
#include "spectrum_format.hpp"

namespace ocean::spotter {
namespace {

struct Limits {
    std::string_view what;
    double low;
    double high;
    std::string_view allowed;
};
/// Six digits may round a moment up to here.
constexpr double kMaxMoment = 1.00001;
constexpr Limits kMoment = {"a moment", -kMaxMoment, kMaxMoment, "-1 .. 1"};
/// By quantity.
constexpr std::array<Limits, kQuantities> kLimits = {{
    {"a frequency", 0.0, kMaxFrequency, kFrequencyRange},
    {"a density", -1e6, 1e6, "0 .. 1e6 m^2/Hz"},
    kMoment,
    kMoment,
    kMoment,
    kMoment,
    {"a direction", -360.0, 720.0, "-360 .. 720 degrees"},
    {"a spread", 0.0, 180.0, "0 .. 180 degrees"},
}};

std::string fault_within(const Limits& limits, double value, std::string_view spelled) {
    if (std::isnan(value) || (value >= limits.low && value <= limits.high)) return "";
    return std::string(limits.what) + " of " + text::printable(spelled, 20) +
           "; allowed: " + std::string(limits.allowed);
}

const std::vector<double>& of(const Bins& bins, Quantity quantity) {
    return bins[static_cast<std::size_t>(quantity)];
}
double at(const Bins& bins, Quantity quantity, std::size_t i) {
    return of(bins, quantity)[i];
}
bool has_all(const Bins& bins, std::initializer_list<Quantity> quantities) {
    for (const Quantity quantity : quantities) {
        if (of(bins, quantity).empty()) return false;
    }
    return true;
}

bool is_known(const Bins& bins, std::size_t i) {
    return !std::isnan(at(bins, Quantity::frequency, i) + at(bins, Quantity::density, i));
}

}  // namespace

std::string fault(Quantity quantity, double value, std::string_view spelled) {
    return fault_within(kLimits[static_cast<std::size_t>(quantity)], value, spelled);
}

std::string latitude_fault(double value, std::string_view spelled) {
    return fault_within({"a latitude", -90.0, 90.0, "-90 .. 90"}, value, spelled);
}

std::string longitude_fault(double value, std::string_view spelled) {
    return fault_within({"a longitude", -180.0, 360.0, "-180 .. 360"}, value, spelled);
}

std::string fault(const Bins& bins) {
    for (const Quantity needed : {Quantity::frequency, Quantity::density}) {
        if (!of(bins, needed).empty()) continue;
        return "a spectrum without " + std::string(kNames[static_cast<std::size_t>(needed)]);
    }
    const std::size_t count = of(bins, Quantity::frequency).size();
    if (count > kMaxFrequencies) return "more than 4096 frequencies";
    for (std::size_t q = 0; q < kQuantities; ++q) {
        if (bins[q].empty() || bins[q].size() == count) continue;
        return std::to_string(bins[q].size()) + " values of " + std::string(kNames[q]) + " for " +
               std::to_string(count) + " frequencies";
    }
    double below = -1.0;
    for (std::size_t i = 0; i < count; ++i) {
        if (!is_known(bins, i)) continue;
        if (!(at(bins, Quantity::frequency, i) > below)) {
            return "the frequencies do not ascend at bin " + std::to_string(i + 1);
        }
        below = at(bins, Quantity::frequency, i);
    }
    return "";
}

bool has_spectrum(const Bins& bins) {
    std::size_t known = 0;
    for (std::size_t i = 0; i < of(bins, Quantity::frequency).size(); ++i) {
        known += is_known(bins, i) ? 1 : 0;
    }
    return known >= 2;
}

void set_spectrum(SpectrumRecord& record, const Bins& bins) {
    const bool moments = has_all(bins, {Quantity::a1, Quantity::b1, Quantity::a2, Quantity::b2});
    const bool mean = has_all(bins, {Quantity::direction, Quantity::spread});
    for (std::size_t i = 0; i < of(bins, Quantity::frequency).size(); ++i) {
        if (!is_known(bins, i)) continue;
        record.frequency.push_back(at(bins, Quantity::frequency, i));
        record.density.push_back(at(bins, Quantity::density, i));
        if (moments) {
            append_moments(record, {at(bins, Quantity::a1, i), at(bins, Quantity::b1, i),
                                    at(bins, Quantity::a2, i), at(bins, Quantity::b2, i)});
        } else if (mean) {
            append_mean_and_spread(record,
                                   travel_direction(at(bins, Quantity::direction, i),
                                                    DirectionConvention::from_nautical),
                                   at(bins, Quantity::spread, i));
        }
    }
    drop_unknown_moments(record);
}

}  // namespace ocean::spotter
