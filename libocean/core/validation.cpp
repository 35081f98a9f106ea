// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules between parameters, and features that a later version brings. After this the stages of the
// pipeline check nothing.
#include <algorithm>
#include <cmath>

#include "ocean/error.hpp"
#include "ocean/parameter_table.hpp"

namespace ocean {

void refuse_later_features(const Parameters& parameters) {
    const auto later = [](const std::string& what) {
        throw Error(ErrorKind::unsupported, what + " in a later version of libocean");
    };
    if (parameters.grid.cascades > 1) {
        later("grid.cascades = " + std::to_string(parameters.grid.cascades) +
              ": more than one cascade comes");
    }
    if (!parameters.grid.cascade_divisors.empty()) {
        later("grid.cascade_divisors: cascades come");
    }
    if (!parameters.time.take.empty()) {
        later("time.take = \"" + parameters.time.take + "\": takes come");
    }
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

/// What the stages rely on; readers of files give finer messages.
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
    throw Error(
        ErrorKind::invalid_value,
        name +
            ": a measured spectrum needs two or more ascending frequencies above 0 with a "
            "density of 0 or more each, and directions for all of them or none, as moments or "
            "as a density");
}

void validate_band(const SurfaceSettings& band) {
    if (band.longest_wavelength == 0.0 || band.longest_wavelength > band.shortest_wavelength)
        return;
    throw Error(ErrorKind::invalid_value,
                "surface.longest_wavelength = " + to_text(band.longest_wavelength) +
                    " m: must be more than surface.shortest_wavelength = " +
                    to_text(band.shortest_wavelength) + " m, or 0 for no limit");
}

}  // namespace

void validate(const Parameters& parameters) {
    refuse_later_features(parameters);
    validate_band(parameters.surface);
    for (std::size_t i = 0; i < parameters.waves.size(); ++i) {
        const WaveSystem& system = parameters.waves[i];
        const std::string name = "waves." + std::to_string(i);
        if (system.spectrum != SpectrumKind::measured) continue;
        if (!system.measured) {
            throw Error(ErrorKind::invalid_value,
                        system.file.empty()
                            ? name + ".spectrum = \"measured\": needs " + name +
                                  ".file, a file of measured spectra"
                            : name + ".file = \"" + system.file + "\": has not been read");
        }
        validate_record(*system.measured, name);
    }
}

}  // namespace ocean
