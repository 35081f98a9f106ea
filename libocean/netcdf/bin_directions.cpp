// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Directions for each frequency: see bin_directions.hpp.
#include "bin_directions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "names.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/directional_record.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/record_rules.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::netcdf {
namespace {

/// The plain names of each quantity, separated by blanks.
constexpr std::array<std::string_view, kBinQuantities> kNames = {{
    " a1 wavea1 wavea1value a1value ",
    " b1 waveb1 waveb1value b1value ",
    " a2 wavea2 wavea2value a2value ",
    " b2 waveb2 waveb2value b2value ",
    " meanwavedir meanwavedirection alpha1 wavealpha1 swdir swdir1 wavemeandirection meandirection "
    "meandir th1m th1 theta1 theta1d dir1 mwd dm mdir vmdr direction dir wavedirection wavedir ",
    " principalwavedir principalwavedirection alpha2 wavealpha2 swdir2 waveprincipaldirection "
    "principaldirection principaldir th2m th2 theta2 dir2 ",
    " wavespectrumr1 r1 waver1 swr1 ",
    " wavespectrumr2 r2 waver2 swr2 ",
    " sth1m sth1 stheta1 spread1 spread1d spread wavespread directionalspread "
    "directionalspreading dirspread meandirectionalspread wavespreading dspr sprd ",
    " sth2m sth2 stheta2 spread2 principaldirectionalspread ",
}};

/// The max of a ratio or a moment that is rounded to two digits.
constexpr double kMaxRatio = 1.05;
/// The spread of cos^2, the default spreading: r1 = 8 / (3 pi).
const double kAssumedSpread = std::sqrt(2.0 * (1.0 - 8.0 / (3.0 * kPi))) / kDegree;
/// The value of a missing direction in tables, even without such an attribute.
constexpr double kNoDirection = 990.0;

double highest(const Variable& v) {
    double max = 0.0;
    for (const double value : v.values) {
        if (std::isfinite(value)) max = std::max(max, std::abs(value));
    }
    return max;
}

bool is_missing(double value) {
    return std::isnan(value) || (std::abs(value) >= kNoDirection && std::isfinite(value));
}

std::string quoted(const Variable& v) {
    return "'" + text::printable(v.name) + "'";
}

}  // namespace

int bin_rank(BinQuantity quantity, const std::string& name, const std::string& standard_name) {
    if (lists(kNames[quantity], plain_name(name))) return 2;
    for (const std::string_view names : kNames) {
        if (lists(names, plain_name(name))) return 0;
    }
    const bool standard =
        (quantity == kMean && among(standard_name, {"sea_surface_wave_from_direction",
                                                    "sea_surface_wave_to_direction"})) ||
        (quantity == kSpread && standard_name == "sea_surface_wave_directional_spread");
    return standard ? 1 : 0;
}

bool is_known_to_come_from(const std::string& name) {
    return lists(
        " meanwavedir alpha1 wavealpha1 swdir swdir1 wavemeandirection th1m theta1 mwd vmdr "
        "principalwavedir alpha2 wavealpha2 swdir2 th2m theta2 ",
        plain_name(name));
}

double degrees_per_unit(const Variable& variable) {
    const std::string units = lower_case(variable.attribute("units"));
    if (units.empty() || units.starts_with("deg") || units.starts_with("\u00b0")) return 1.0;
    if (units.starts_with("rad")) return 180.0 / kPi;
    throw Fault(variable.name, "units '" + text::printable(variable.attribute("units")) +
                                   "'; allowed: degree, radian");
}

BinDirections::BinDirections(const Content& content, const Layout& layout) {
    for (std::size_t q = 0; q < kBinQuantities; ++q) {
        if (layout.bins[q]) variable_[q] = &content.variables[*layout.bins[q]];
    }
    if (has({kA1, kB1, kA2, kB2})) {
        source_ = Source::moments;
    } else if (has({kMean, kPrincipal, kR1, kR2})) {
        source_ = Source::directions_and_ratios;
    } else if (has({kMean, kPrincipal, kSpread, kPrincipalSpread})) {
        source_ = Source::directions_and_spreads;
    } else if (has({kA1, kB1})) {
        source_ = Source::first_moment;
    } else if (has({kMean, kR1})) {
        source_ = Source::direction_and_ratio;
    } else if (has({kMean, kSpread})) {
        source_ = Source::direction_and_spread;
    } else if (has({kMean})) {
        source_ = Source::direction;
        warnings_.push_back(quoted(*variable_[kMean]) +
                            " has a direction for each frequency, and nothing says how far they "
                            "spread: " +
                            fixed_text(kAssumedSpread, 1) + " degrees are taken, as cos^2 spreads");
    } else {
        return;
    }
    find_units();
    const Variable& spectrum = content.variables[layout.spectrum];
    if (variable_[kMean] != nullptr) find_direction_sense(content, spectrum);
    if (source_ == Source::moments || source_ == Source::first_moment) {
        find_moment_sense(content, spectrum);
    }
}

bool BinDirections::has(std::initializer_list<BinQuantity> quantities) const {
    return std::all_of(quantities.begin(), quantities.end(),
                       [&](BinQuantity q) { return variable_[q] != nullptr; });
}

void BinDirections::find_units() {
    for (const BinQuantity q : {kMean, kPrincipal, kSpread, kPrincipalSpread}) {
        if (variable_[q] == nullptr) continue;
        const std::string units = variable_[q]->attribute("units");
        const bool power = (q == kSpread || q == kPrincipalSpread) && units == "1";
        scale_[q] = power ? 0.0 : degrees_per_unit(*variable_[q]);
    }
    for (const BinQuantity q : {kA1, kB1, kA2, kB2, kR1, kR2}) {
        if (variable_[q] == nullptr) continue;
        const Variable& v = *variable_[q];
        const std::string units = lower_case(v.attribute("units"));
        const bool percent = units == "%" || units.starts_with("percent") || units == "per cent";
        scale_[q] = percent ? 0.01 : 1.0;
        const bool ratio = q == kR1 || q == kR2;
        if (percent || !ratio || highest(v) <= kMaxRatio || highest(v) > 100.0) continue;
        scale_[q] = 0.01;
        warnings_.push_back(quoted(v) + " reaches " + shortest_text(highest(v)) +
                            ": it is taken as per cent");
    }
}

void BinDirections::find_direction_sense(const Content& content, const Variable& spectrum) {
    const Variable& mean = *variable_[kMean];
    const auto writer =
        is_known_to_come_from(mean.name) ? std::optional(kComingFrom) : std::nullopt;
    const FoundSense found = direction_sense(content, mean, spectrum, writer);
    direction_sense_ = found.sense;
    if (!found.warning.empty()) warnings_.push_back(found.warning);
    if (found.told || source_ == Source::moments || source_ == Source::first_moment) return;
    warnings_.push_back(silent_directions(mean, found.sense));
}

/// Finds the convention of the moments. CDIP's moments belong to the direction waves come from,
/// with a1 to the north and b1 to the east; Spotter's to the travel direction, with a1 to the east
/// and b1 to the north.
void BinDirections::find_moment_sense(const Content& content, const Variable& spectrum) {
    const Variable& a1 = *variable_[kA1];
    const bool cdip = plain_name(a1.name) == "wavea1value";
    const FoundSense found =
        direction_sense(content, a1, spectrum, cdip ? std::optional(kComingFrom) : std::nullopt);
    moment_sense_ = found.sense;
    if (!found.warning.empty()) warnings_.push_back(found.warning);
    const std::string name = lower_case(a1.attribute("long_name"));
    const bool to_north = name.find("north") != std::string::npos;
    const bool to_east = name.find("east") != std::string::npos;
    if (to_north != to_east) {  // the axis of a1
        moment_sense_.from_east = moment_sense_.counter_clockwise = to_east;
    } else if (!moment_sense_.from) {
        moment_sense_ = kTravellingToFromEast;
    }
    if (found.told) return;
    const std::string without = "nothing in the file says how " + quoted(a1) + " is measured: ";
    const bool asked = variable_[kMean] != nullptr;
    if (asked && mean_follows(kComingFrom) && !mean_follows(kTravellingToFromEast)) {
        moment_sense_ = kComingFrom;
    } else {
        moment_sense_ = kTravellingToFromEast;
        if (asked && mean_follows(kTravellingToFromEast)) return;
    }
    warnings_.push_back(without + moment_sense_.text() + ", is taken" +
                        (moment_sense_.from ? ", as " + quoted(*variable_[kMean]) + " has it"
                                            : ", as Spotter buoys have it"));
}

/// Returns true if the mean directions, where the file has them beside first moments, agree with
/// moments of the convention `moments`.
bool BinDirections::mean_follows(const DirectionSense& moments) const {
    const Variable& a1 = *variable_[kA1];
    const Variable& b1 = *variable_[kB1];
    const Variable& mean = *variable_[kMean];
    if (a1.dimensions != mean.dimensions || b1.dimensions != mean.dimensions) return false;
    std::complex<double> agreement = 0.0;
    for (std::size_t i = 0; i < mean.values.size(); ++i) {
        const std::complex<double> first(a1.values[i], b1.values[i]);
        const double angle = direction_sense_.travel(mean.values[i] * scale_[kMean]) * kDegree;
        const std::complex<double> product =
            moments.travel_moment(first, 1) * std::polar(1.0, -angle);
        if (std::isfinite(std::abs(product))) agreement += product;
    }
    return agreement.real() > std::abs(agreement.imag());
}

double BinDirections::direction(BinQuantity quantity, const ValueOf& value_of) const {
    const Variable& v = *variable_[quantity];
    const double degrees = value_of(v) * scale_[quantity];
    if (is_missing(degrees)) return kMissing;
    if (degrees >= -360.001 && degrees <= 720.001) return direction_sense_.travel(degrees);
    throw Fault(v.name,
                "a direction of " + shortest_text(degrees) + " degrees; allowed: -360 .. 720");
}

double BinDirections::ratio(BinQuantity quantity, const ValueOf& value_of) const {
    const Variable& v = *variable_[quantity];
    const double read = value_of(v);
    const double ratio = read * scale_[quantity];
    if (is_missing(read)) return kMissing;
    if (ratio >= 0.0 && ratio <= kMaxRatio) return std::min(ratio, 1.0);
    throw Fault(v.name, shortest_text(read) + "; allowed: 0 .. 1, or 0 .. 100 per cent");
}

/// Returns the ratio of a spread s [rad]: r1 = 1 - s^2 / 2, r2 = 1 - 2 s^2 [Kuik 1988]. If the file
/// has the power s of cos^2s of half the angle instead: r1 = s / (s + 1) [Longuet-Higgins 1963].
double BinDirections::spread_ratio(BinQuantity quantity, const ValueOf& value_of) const {
    const Variable& v = *variable_[quantity];
    const double read = value_of(v);
    if (is_missing(read)) return kMissing;
    const bool power = scale_[quantity] == 0.0;
    const double degrees = read * scale_[quantity];
    if (read < 0.0 || degrees > 180.0) {
        throw Fault(v.name, "a spread of " + shortest_text(power ? read : degrees) +
                                "; allowed: 0 .. 180 degrees");
    }
    const bool second = quantity == kPrincipalSpread;
    if (power) return second ? kMissing : read / (read + 1.0);
    const double sigma = degrees * kDegree;
    return std::max(1.0 - (second ? 2.0 : 0.5) * sigma * sigma, 0.0);
}

std::complex<double> BinDirections::moment(BinQuantity a, BinQuantity b,
                                           const ValueOf& value_of) const {
    const std::complex<double> z(value_of(*variable_[a]) * scale_[a],
                                 value_of(*variable_[b]) * scale_[b]);
    const double length = std::abs(z);
    if (is_missing(100.0 * length)) return {kMissing, kMissing};
    if (length <= kMaxRatio) {
        return moment_sense_.travel_moment(length > 1.0 ? z / length : z, a == kA1 ? 1 : 2);
    }
    throw Fault(variable_[a]->name,
                "a moment of length " + shortest_text(length) + "; allowed: 0 .. 1");
}

void BinDirections::append(SpectrumRecord& record, const ValueOf& value_of) const {
    /// Returns the spread of a ratio, the inverse of spread_ratio.
    const auto spread = [](double r1) { return std::sqrt(2.0 * (1.0 - r1)) / kDegree; };
    switch (source_) {
        case Source::none:
            return;
        case Source::moments: {
            const std::complex<double> first = moment(kA1, kB1, value_of);
            const std::complex<double> second = moment(kA2, kB2, value_of);
            append_moments(record, {first.real(), first.imag(), second.real(), second.imag()});
            return;
        }
        case Source::directions_and_ratios:
            append_mean_and_principal(record, direction(kMean, value_of),
                                      direction(kPrincipal, value_of), ratio(kR1, value_of),
                                      ratio(kR2, value_of));
            return;
        case Source::directions_and_spreads:
            append_mean_and_principal(
                record, direction(kMean, value_of), direction(kPrincipal, value_of),
                spread_ratio(kSpread, value_of), spread_ratio(kPrincipalSpread, value_of));
            return;
        case Source::first_moment: {
            const std::complex<double> first = moment(kA1, kB1, value_of);
            append_mean_and_spread(record, std::arg(first) / kDegree, spread(std::abs(first)));
            return;
        }
        case Source::direction_and_ratio:
            append_mean_and_spread(record, direction(kMean, value_of),
                                   spread(ratio(kR1, value_of)));
            return;
        case Source::direction_and_spread:
            append_mean_and_spread(record, direction(kMean, value_of),
                                   spread(spread_ratio(kSpread, value_of)));
            return;
        case Source::direction:
            append_mean_and_spread(record, direction(kMean, value_of), kAssumedSpread);
            return;
    }
}

}  // namespace ocean::netcdf
