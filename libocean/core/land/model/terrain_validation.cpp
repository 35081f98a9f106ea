// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules between the parameters of a terrain. Later stages rely on them and check nothing.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

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

void validate_range(const TerrainModel& terrain) {
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

void validate_band(const TerrainModel& terrain) {
    const double longest = terrain.longest_wavelength;
    if (longest > 0.0 && longest <= terrain.shortest_wavelength) {
        refuse("terrain.longest_wavelength", longest, "leaves no wave",
               "more than terrain.shortest_wavelength = " + to_text(terrain.shortest_wavelength) +
                   " m");
    }
}

void validate_breaks(const TerrainModel& terrain) {
    const auto& breaks = terrain.breaks;
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        if (breaks[i][0] < breaks[i - 1][0]) continue;
        refuse("terrain.breaks", breaks, "are not ordered",
               "pairs [WAVELENGTH, BETA] from the longest wavelength to the shortest");
    }
}

void validate_measured(const TerrainModel& terrain) {
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
void validate_layer(const TerrainModel& terrain, std::size_t item) {
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

void validate_pair(const char* parameter, const std::vector<double>& pair) {
    if (pair.empty() || pair.size() == 2) return;
    refuse(parameter, pair, "does not have two numbers", "[EAST, NORTH] in metres");
}

/// Throws if a parameter has a value that only a placed land uses.
void require_placed(const TerrainModel& terrain) {
    const auto require = [](bool unused, const char* parameter, const ParameterValue& value) {
        if (unused) return;
        refuse(parameter, value, "needs a land that exists once", "terrain.kind = \"placed\"");
    };
    require(terrain.origin.empty(), "terrain.origin", terrain.origin);
    require(terrain.size.empty(), "terrain.size", terrain.size);
    require(terrain.island == 0.0, "terrain.island", terrain.island);
    require(terrain.base.empty() && terrain.base_model == nullptr, "terrain.base", terrain.base);
    require(terrain.detail_wavelength.value_or(0.0) == 0.0, "terrain.detail_wavelength",
            terrain.detail_wavelength.value_or(0.0));
    require(!terrain.has_streams(), "terrain.stream.slope", terrain.stream.slope);
    require(!terrain.has_coast(), "terrain.coast.slope", terrain.coast.beach_slope);
}

void validate_base(const TerrainModel& terrain) {
    if (terrain.base.empty() && terrain.base_model == nullptr) {
        if (!terrain.base_error) return;
        refuse("terrain.base_error", *terrain.base_error, "has no effect without terrain.base",
               "a base, or no base_error");
    }
    if (terrain.base_model == nullptr) {
        refuse("terrain.base", terrain.base, "has not been read", "an elevation model");
    }
    const auto contradicts = [](bool unused, const char* parameter, const ParameterValue& value) {
        if (unused) return;
        refuse(parameter, value, "contradicts terrain.base, whose heights are the land",
               "one of them");
    };
    contradicts(terrain.size.empty(), "terrain.size", terrain.size);
    contradicts(!terrain.rms, "terrain.rms", terrain.rms.value_or(0.0));
    contradicts(terrain.measured.empty(), "terrain.measured", terrain.measured);
    contradicts(terrain.breaks.empty(), "terrain.breaks", terrain.breaks);
    contradicts(terrain.layers.empty(), "terrain.layer",
                static_cast<std::int64_t>(terrain.layers.size()));
}

void validate_placed(const TerrainModel& terrain) {
    if (!terrain.is_placed()) return require_placed(terrain);
    validate_pair("terrain.origin", terrain.origin);
    validate_pair("terrain.size", terrain.size);
    for (const double side : terrain.size) {
        if (side <= terrain.patch_size) continue;
        refuse("terrain.size", terrain.size, "is larger than the patch after which waves repeat",
               "at most terrain.patch_size = " + to_text(terrain.patch_size) + " m");
    }
    if (terrain.has_streams() && terrain.has_gullies()) {
        refuse("terrain.gullies.depth", terrain.gullies.depth,
               "contradicts terrain.stream, which cuts valleys of its own", "one of them");
    }
}

void validate_gullies(const TerrainModel& terrain) {
    if (!terrain.has_gullies() || terrain.is_placed()) return;
    const double most = 0.25 * terrain.patch_size;
    if (terrain.gullies.longest <= most) return;
    refuse("terrain.gullies.longest", terrain.gullies.longest, "is too long for the tile",
           "at most a quarter of terrain.patch_size, " + to_text(most) + " m");
}

/// Throws for a range of a shaped land: only waves alone can be scaled to a range.
void validate_shaped_range(const TerrainModel& terrain) {
    if (terrain.range.empty() || !terrain.is_shaped()) return;
    refuse("terrain.range", terrain.range,
           "is for a tile without gullies: erosion does not scale with the height", "rms and mean");
}

}  // namespace

void validate(const TerrainModel& terrain) {
    validate_placed(terrain);
    validate_base(terrain);
    validate_gullies(terrain);
    validate_shaped_range(terrain);
    validate_range(terrain);
    validate_band(terrain);
    validate_breaks(terrain);
    validate_measured(terrain);
    for (std::size_t item = 0; item < terrain.layers.size(); ++item) validate_layer(terrain, item);
}

}  // namespace ocean
