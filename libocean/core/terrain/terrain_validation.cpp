// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules between the parameters of a terrain. After this its stages check nothing.
#include <cmath>
#include <cstddef>
#include <string>

#include "ocean/error.hpp"
#include "ocean/terrain_table.hpp"

namespace ocean {
namespace {

[[noreturn]] void refuse(const char* parameter, const ParameterValue& value, const char* what,
                         const std::string& allowed) {
    throw Error(
        ErrorKind::invalid_value,
        {.what = what, .parameter = parameter, .value = quoted_text(value), .allowed = allowed});
}

void validate_range(const Terrain& terrain) {
    const std::vector<double>& range = terrain.range;
    if (range.empty()) return;
    if (range.size() != 2 || !(range[0] < range[1])) {
        refuse("terrain.range", range, "is not a range",
               "[LOWEST, HIGHEST], two heights in metres");
    }
    if (terrain.rms) {
        refuse("terrain.range", range, "contradicts terrain.rms", "one of rms and range");
    }
    if (terrain.mean != 0.0) {
        refuse("terrain.range", range, "contradicts terrain.mean", "one of mean and range");
    }
}

void validate_band(const Terrain& terrain) {
    const double longest = terrain.longest_wavelength;
    if (longest > 0.0 && longest <= terrain.shortest_wavelength) {
        refuse("terrain.longest_wavelength", longest, "leaves no wave",
               "more than terrain.shortest_wavelength = " + to_text(terrain.shortest_wavelength) +
                   " m");
    }
}

void validate_breaks(const Terrain& terrain) {
    const auto& breaks = terrain.breaks;
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        if (breaks[i][0] < breaks[i - 1][0]) continue;
        refuse("terrain.breaks", breaks, "are not ordered",
               "pairs [WAVELENGTH, BETA] from the longest wavelength to the shortest");
    }
}

void validate_measured(const Terrain& terrain) {
    if (terrain.measured.empty() && terrain.rings == nullptr) return;
    if (!terrain.breaks.empty()) {
        refuse("terrain.breaks", terrain.breaks, "has no effect beside terrain.measured",
               "one of breaks and measured");
    }
    if (terrain.outer_scale > 0.0) {
        refuse("terrain.outer_scale", terrain.outer_scale, "has no effect beside terrain.measured",
               "one of outer_scale and measured");
    }
    if (terrain.rings == nullptr) {
        refuse("terrain.measured", terrain.measured, "has not been read", "a file of rings");
    }
}

/// Throws unless the layer repeats a whole number of times in the patch.
void validate_layer(const Terrain& terrain, std::size_t item) {
    const double period = terrain.layers[item].period;
    const double parts = terrain.patch_size / period;
    const double whole = std::round(parts);
    if (whole >= 1.0 && std::abs(parts - whole) <= 1e-6 * whole) return;
    const double fewer = std::max(1.0, std::floor(parts));
    const std::string path = "terrain.layer." + std::to_string(item) + ".period";
    refuse(path.c_str(), period, "does not fit into terrain.patch_size a whole number of times",
           to_text(terrain.patch_size) + " m divided by a whole number, such as " +
               to_text(terrain.patch_size / fewer) + " or " +
               to_text(terrain.patch_size / (fewer + 1.0)));
}

}  // namespace

void validate(const Terrain& terrain) {
    validate_range(terrain);
    validate_band(terrain);
    validate_breaks(terrain);
    validate_measured(terrain);
    for (std::size_t item = 0; item < terrain.layers.size(); ++item) validate_layer(terrain, item);
}

}  // namespace ocean
