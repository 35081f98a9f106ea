// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules between parameters. Later stages of the pipeline rely on them and check nothing.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ocean/error.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/sea_bed.hpp"

namespace ocean {

void require_time(double time) {
    if (std::abs(time) <= kLatestTime) return;
    throw Error(ErrorKind::invalid_value,
                {.parameter = "time", .value = to_text(time) + " s", .allowed = "-1e9 .. 1e9"});
}

namespace {

bool good_directions(const SpectrumRecord& record) {
    const std::vector<double>& d = record.direction;
    if (d.empty()) return record.directional_density.empty();
    const bool fits = d.size() >= 3 && !record.has_moments() &&
                      record.directional_density.size() == d.size() * record.frequency.size();
    const auto unordered = [](double a, double b) { return !(a < b); };
    return fits && d.front() >= 0.0 && d.back() < 360.0 &&
           std::adjacent_find(d.begin(), d.end(), unordered) == d.end() &&
           std::all_of(record.directional_density.begin(), record.directional_density.end(),
                       [](double s) { return s >= 0.0 && std::isfinite(s); });
}

/// Checks the rules on which the stages rely; readers of files give finer messages.
void validate_record(const SpectrumRecord& record, const std::string& name) {
    const std::size_t n = record.frequency.size();
    const auto fits = [&](const std::vector<double>& moment) {
        return moment.size() == (record.has_moments() ? n : 0);
    };
    bool good = n >= 2 && record.density.size() == n && fits(record.a1) && fits(record.b1) &&
                fits(record.a2) && fits(record.b2) && good_directions(record);
    for (std::size_t i = 0; good && i < n; ++i) {
        const double below = i > 0 ? record.frequency[i - 1] : 0.0;
        good = record.frequency[i] > below && std::isfinite(record.frequency[i]) &&
               record.density[i] >= 0.0 && std::isfinite(record.density[i]);
    }
    if (good) return;
    throw Error(ErrorKind::invalid_value,
                {.what = "a measured spectrum needs two or more ascending frequencies above 0 with "
                         "a density of 0 or more each, and directions for all of them or none, as "
                         "moments or as a density",
                 .parameter = name});
}

void validate_band(const SurfaceSettings& band) {
    if (band.longest_wavelength == 0.0 || band.longest_wavelength > band.shortest_wavelength)
        return;
    throw Error(ErrorKind::invalid_value,
                {.what = "must be more than surface.shortest_wavelength = " +
                         to_text(band.shortest_wavelength) + " m, or 0 for no limit",
                 .parameter = "surface.longest_wavelength",
                 .value = to_text(band.longest_wavelength) + " m"});
}

void validate_cascades(const Grid& grid) {
    if (grid.cascade_divisors.empty()) return;
    const auto refuse = [&](const std::string& reason) {
        const std::vector<std::int64_t> given(grid.cascade_divisors.begin(),
                                              grid.cascade_divisors.end());
        throw Error(
            ErrorKind::invalid_value,
            {.what = reason, .parameter = "grid.cascade_divisors", .value = to_text(given)});
    };
    if (static_cast<int>(grid.cascade_divisors.size()) != grid.cascades) {
        refuse("must have " + std::to_string(grid.cascades) +
               " numbers, one for each of grid.cascades, or none to have them chosen");
    }
    if (grid.cascade_divisors.front() != 1) refuse("must begin with 1, the patch itself");
    // A band must begin a few modes from its lattice's origin; otherwise it has hardly any
    // directions.
    const int farthest = grid.resolution / 8;
    for (std::size_t c = 1; c < grid.cascade_divisors.size(); ++c) {
        const long long last = grid.cascade_divisors[c - 1];
        const int next = grid.cascade_divisors[c];
        if (next <= last) refuse("must ascend");
        if (next > last * farthest) {
            refuse(std::to_string(next) + " is too far above " + std::to_string(last) +
                   "; allowed: at most grid.resolution / 8 = " + std::to_string(farthest) +
                   " times the one before");
        }
    }
}

/// Returns the distance of two places or times that repeat after a period; 0 = they do not repeat.
double distance(double a, double b, double period) {
    const double apart = std::abs(a - b);
    return period > 0.0 ? std::abs(std::remainder(apart, period)) : apart;
}

/// Returns true if two crests lie at one place and time, to a thousandth of a metre and a second.
bool coincide(const Crest& a, const Crest& b, const Parameters& parameters) {
    constexpr double kSame = 1e-3;
    const double period = parameters.grid.patch_size;
    return distance(a.x, b.x, period) < kSame && distance(a.y, b.y, period) < kSame &&
           distance(a.time, b.time, parameters.time.loop_period) < kSame;
}

/// Throws unless the height of a crest can be that of any sea.
void validate_height(const WaveHeight& height, const std::string& name) {
    const bool is_low = !height.is_relative || std::abs(height.value) <= kMaxCrestHeight;
    if (is_low && height.value != 0.0 && std::isfinite(height.value)) return;
    throw Error(
        ErrorKind::invalid_value,
        {.what = height.value == 0.0 ? "is neither a crest, above 0, nor a trough, below 0"
                                     : "is higher than waves get: one crest in 10^14 exceeds 2 Hs",
         .parameter = name + ".height",
         .value = height.is_relative ? quoted_text(to_text(height)) : to_text(height) + " m",
         .allowed = "-2 Hs .. 2 Hs"});
}

/// Checks the rules of the crests that need no spectrum.
void validate_crests(const Parameters& parameters) {
    const std::vector<Crest>& crests = parameters.crests;
    if (crests.empty()) return;
    if (crests.size() > kMaxCrests) {
        throw Error(ErrorKind::invalid_value, {.what = std::to_string(crests.size()) + " crests",
                                               .parameter = "crests",
                                               .allowed = "1 .. " + std::to_string(kMaxCrests)});
    }
    if (parameters.water.bed != nullptr) {
        throw Error(ErrorKind::unsupported,
                    {.what = "a sea with a bed has no crests on cue: the bed turns, slows and "
                             "breaks the waves after they are made",
                     .parameter = "water.seabed",
                     .value = "\"" + parameters.water.seabed + "\"",
                     .allowed = "none with [[crests]]"});
    }
    for (std::size_t i = 0; i < crests.size(); ++i) {
        const Crest& crest = crests[i];
        const std::string name = "crests." + std::to_string(i);
        validate_height(crest.height, name);
        for (const double value : {crest.time, crest.x, crest.y, crest.direction.value_or(0.0)}) {
            if (std::isfinite(value)) continue;
            throw Error(
                ErrorKind::invalid_value,
                {.what = "has a time, place or direction that is no number", .parameter = name});
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (!coincide(crest, crests[j], parameters)) continue;
            throw Error(ErrorKind::invalid_value,
                        {.what = "lies at the place and time of crests." + std::to_string(j) +
                                 ", where the water has one height; places repeat after "
                                 "grid.patch_size, times after time.loop_period",
                         .parameter = name});
        }
    }
}

/// Throws unless bound waves are known for this sea: the fit of their kernels is one of deep water.
void validate_second_order(const Parameters& parameters) {
    if (!parameters.surface.second_order) return;
    const auto refuse = [](std::string what, std::string parameter, std::string value,
                           std::string allowed) {
        throw Error(ErrorKind::unsupported, {.what = std::move(what),
                                             .parameter = std::move(parameter),
                                             .value = std::move(value),
                                             .allowed = std::move(allowed)});
    };
    const Water& water = parameters.water;
    if (water.bed != nullptr) {
        refuse("a bed turns, slows and breaks the waves, for which second order is not known",
               "water.seabed", quoted_text(water.seabed), "none with surface.second_order = true");
    }
    if (!std::isinf(water.depth)) {
        refuse("second order is known for deep water alone", "water.depth",
               to_text(water.depth) + " m", "inf with surface.second_order = true");
    }
    if (!parameters.crests.empty()) {
        refuse("a crest on cue has the height of linear waves, and second order would raise it",
               "surface.second_order", "true", "false with [[crests]]");
    }
}

}  // namespace

void validate(const Parameters& parameters) {
    validate_bed(parameters.water);
    validate_band(parameters.surface);
    validate_cascades(parameters.grid);
    validate_hulls(parameters);
    validate_second_order(parameters);
    for (std::size_t i = 0; i < parameters.waves.size(); ++i) {
        const WaveSystem& system = parameters.waves[i];
        const std::string name = "waves." + std::to_string(i);
        if (system.spectrum != SpectrumKind::measured) continue;
        if (!system.measured) {
            if (!system.file.empty()) {
                throw Error(ErrorKind::invalid_value, {.what = "has not been read",
                                                       .parameter = name + ".file",
                                                       .value = "\"" + system.file + "\""});
            }
            throw Error(ErrorKind::invalid_value,
                        {.what = "needs " + name + ".file, a file of measured spectra",
                         .parameter = name + ".spectrum",
                         .value = "\"measured\""});
        }
        validate_record(*system.measured, name);
    }
    validate_crests(parameters);
}

}  // namespace ocean
