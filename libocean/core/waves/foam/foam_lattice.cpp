// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The lattice on which foam keeps its past, and how finer maps read it. Long waves decide where
// foam lies, so that a past of hundreds of ticks is followed on a lattice of these waves alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "field/cubic.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/surface.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/foam/whitecap_threshold.hpp"

namespace ocean {

FoamLattice foam_lattice(const Parameters& parameters, int map_resolution) {
    const int given = parameters.surface.foam_resolution;
    const int unset = parameters.grid.cascades > 1 ? parameters.grid.resolution : map_resolution;
    const int own = given > 0 ? given : unset;
    if (own >= map_resolution) return {map_resolution, map_resolution};
    return {own, own / 2};
}

ShownFoam foam_of_map(const Parameters& parameters, int map_resolution) {
    return {foam_lattice(parameters, map_resolution), map_resolution};
}

ShownFoam foam_of_lattice(const FoamLattice& lattice) {
    return {lattice, lattice.held_by};
}

SurfaceSettings lattice_settings(const Modes& modes, const Parameters& parameters,
                                 const FoamLattice& lattice) {
    const SurfaceSettings& given = parameters.surface;
    SurfaceSettings settings = with_threshold(given, modes, lattice.held_by);
    if (lattice.is_spread() && given.foam_coverage == FoamCoverage::threshold) {
        const int map = default_map_resolution(parameters.grid);
        const double wanted = mean_whitecap(modes.gradient_covariance(map), given.choppiness,
                                            given.foam_threshold, given.foam_width);
        settings.foam_threshold =
            threshold_of_mean(modes.gradient_covariance(lattice.held_by), settings, wanted,
                              std::max(1.0, given.foam_threshold));
    }
    return settings;
}

FoamWhitecaps foam_whitecaps(const Modes& modes, const ShownFoam& foam, const SurfaceSettings& past,
                             const SurfaceSettings& shown) {
    const auto whitecaps = [&](const SurfaceSettings& settings, int held_by) {
        return Whitecaps{held_by, modes.gradient_covariance(held_by), settings.foam_threshold};
    };
    return {whitecaps(past, foam.past.held_by), whitecaps(shown, foam.whitecaps_held_by)};
}

namespace {

float raised(float x, float to) {
    return x > 0.0f ? std::pow(x, to) : 0.0f;
}

}  // namespace

void spread_foam(std::span<const float> lattice, double power, std::span<float> map,
                 ThreadPool& pool) {
    const auto side = [](std::size_t samples) {
        return static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(samples))));
    };
    const std::size_t n = side(lattice.size());
    const std::size_t factor = side(map.size()) / n;
    std::vector<std::array<float, 4>> weights;
    for (std::size_t k = 0; k < factor; ++k) {
        weights.push_back(catmull_rom(static_cast<float>(k) / static_cast<float>(factor)));
    }
    PageVector<float> cover(lattice.size());
    pool.for_each_item(static_cast<int>(n), [&](int row, int) {
        const std::size_t first = static_cast<std::size_t>(row) * n;
        for (std::size_t i = first; i < first + n; ++i) {
            cover[i] = raised(lattice[i], static_cast<float>(power));
        }
    });
    const auto inverse = static_cast<float>(1.0 / power);
    pool.for_each_item(static_cast<int>(n), [&](int item, int) {
        const auto row = static_cast<std::size_t>(item);
        std::array<const float*, 4> rows;
        for (std::size_t j = 0; j < 4; ++j) rows[j] = cover.data() + (row + n - 1 + j) % n * n;
        std::vector<float> across(n + 3);  // from the sample before the first
        for (std::size_t part = 0; part < factor; ++part) {
            const std::array<float, 4>& w = weights[part];
            for (std::size_t i = 0; i < n; ++i) {
                across[i + 1] =
                    w[0] * rows[0][i] + w[1] * rows[1][i] + w[2] * rows[2][i] + w[3] * rows[3][i];
            }
            across[0] = across[n];
            across[n + 1] = across[1];
            across[n + 2] = across[2];
            float* to = map.data() + (row * factor + part) * n * factor;
            for (std::size_t i = 0; i < n; ++i) {
                const float* s = across.data() + i;
                for (const std::array<float, 4>& u : weights) {
                    const float between = u[0] * s[0] + u[1] * s[1] + u[2] * s[2] + u[3] * s[3];
                    *to++ = raised(std::clamp(between, 0.0f, 1.0f), inverse);
                }
            }
        }
    });
}

}  // namespace ocean
