// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The settings of a quadtree of land, and the rule that keeps it closed.
#include <cmath>
#include <limits>
#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/land_quadtree.hpp"
#include "ocean/table.hpp"

namespace ocean {
namespace {

constexpr int kMaxPatch = 1024;
constexpr int kMaxLevels = 30;
constexpr double kMinMorph = 4.0;       // spacings from its start to the range
constexpr double kMaxRootsToEdge = 64;  // squares of the coarsest level up to `farthest`
[[noreturn]] void refuse(const char* parameter, double value, const char* what,
                         const std::string& allowed) {
    throw Error(
        ErrorKind::invalid_value,
        {.what = what, .parameter = parameter, .value = to_text(value), .allowed = allowed});
}

void require_within(const char* parameter, double value, double low, double high,
                    const std::string& allowed) {
    if (!(value >= low && value <= high)) refuse(parameter, value, "is out of range", allowed);
}

void validate_edge(const LandEdge& edge) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
        for (const double value : {edge.low[axis], edge.high[axis]}) {
            require_within("edge", value, -kMaxQuadtreeCoordinate, kMaxQuadtreeCoordinate,
                           "-1e8 .. 1e8 m");
        }
        if (!(edge.low[axis] < edge.high[axis])) {
            refuse("edge", edge.high[axis], "leaves no land",
                   "more than " + to_text(edge.low[axis]) + " m");
        }
    }
}

}  // namespace

double min_range(const QuadtreeSettings& settings) {
    const double share = 2.0 * settings.morph_start - 1.0;
    if (!(share > 0.0)) return std::numeric_limits<double>::infinity();
    return std::sqrt(2.0) * settings.patch / share;
}

void validate(const QuadtreeSettings& settings) {
    require_within("spacing", settings.spacing, 1e-3, 1e6, "0.001 .. 1e6 m");
    require_within("patch", settings.patch, 4, kMaxPatch, "4 .. " + std::to_string(kMaxPatch));
    if (settings.patch % 4 != 0) {
        refuse("patch", settings.patch, "does not halve into an even number", "a multiple of 4");
    }
    require_within("levels", settings.levels, 1, kMaxLevels, "1 .. " + std::to_string(kMaxLevels));
    if (!(settings.morph_start > 0.5 && settings.morph_start < 1.0)) {
        refuse("morph_start", settings.morph_start, "is out of range", "above 0.5 and below 1");
    }
    require_within("range", settings.range, 1.0, 1e6, "1 .. 1e6 spacings");
    const double least = min_range(settings);
    if (!(settings.range >= least)) {
        refuse("range", settings.range, "would open cracks between levels",
               to_text(least) + " spacings or more, sqrt(2) patch / (2 morph_start - 1)");
    }
    const double morph = settings.range * (1.0 - settings.morph_start);
    if (!(morph >= kMinMorph)) {
        refuse("morph_start", settings.morph_start, "leaves the morph too few spacings",
               "range (1 - morph_start) of " + to_text(kMinMorph) + " or more");
    }
    const double farthest =
        kMaxRootsToEdge * settings.patch * settings.spacing_of(settings.levels - 1);
    if (!(settings.farthest > 0.0 && settings.farthest <= farthest)) {
        refuse("farthest", settings.farthest, "is out of range",
               "above 0 and up to " + to_text(farthest) + " m; more with more levels");
    }
    require_within("farthest", settings.farthest, 0.0, kMaxQuadtreeCoordinate, "up to 1e8 m");
    if (settings.edge) validate_edge(*settings.edge);
}

}  // namespace ocean
