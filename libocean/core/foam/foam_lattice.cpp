// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The lattice on which foam keeps its past, and how finer maps read it. Long waves decide where
// foam lies, so a past of hundreds of ticks is paid for on a lattice that holds those alone.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "ocean/foam.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/surface.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

FoamLattice foam_lattice(const Parameters& parameters, int map_resolution) {
    const int own = parameters.surface.foam_resolution;
    if (own == 0 || own >= map_resolution) return {map_resolution, map_resolution};
    return {own, own / 2};
}

FoamWaves foam_waves(const Modes& modes, const Parameters& parameters, int map_resolution) {
    const FoamLattice lattice = foam_lattice(parameters, map_resolution);
    FoamWaves waves{modes.gradient_covariance(map_resolution), lattice, {}, 0.0};
    waves.past = waves.map;
    if (lattice.held_by < map_resolution) {
        waves.past = modes.gradient_covariance(lattice.held_by);
        waves.past_threshold = whitecap_threshold(waves.past, parameters.surface, modes.wind_speed);
    }
    return waves;
}

void spread_foam(std::span<const float> lattice, double power, std::span<float> map,
                 ThreadPool& pool) {
    const auto side = [](std::size_t samples) {
        return static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(samples))));
    };
    const std::size_t n = side(lattice.size());
    const std::size_t factor = side(map.size()) / n;
    const auto raised = [](float x, float to) { return x > 0.0f ? std::pow(x, to) : 0.0f; };
    const auto inverse = static_cast<float>(1.0 / power);
    PageVector<float> cover(lattice.size());
    pool.for_each_item(static_cast<int>(n), [&](int row, int) {
        const std::size_t first = static_cast<std::size_t>(row) * n;
        for (std::size_t i = first; i < first + n; ++i) {
            cover[i] = raised(lattice[i], static_cast<float>(power));
        }
    });
    pool.for_each_item(static_cast<int>(n), [&](int lower, int) {
        const auto row = static_cast<std::size_t>(lower);
        const float* below = cover.data() + row * n;
        const float* above = cover.data() + (row + 1) % n * n;
        for (std::size_t part = 0; part < factor; ++part) {
            const float up = static_cast<float>(part) / static_cast<float>(factor);
            const auto at = [&](std::size_t i) { return below[i] + up * (above[i] - below[i]); };
            float* to = map.data() + (row * factor + part) * n * factor;
            float left = at(0);
            for (std::size_t i = 0; i < n; ++i) {
                const float right = at((i + 1) % n);
                if (left == 0.0f && right == 0.0f) {
                    std::fill_n(to, factor, 0.0f);
                } else {
                    for (std::size_t k = 0; k < factor; ++k) {
                        const float along = static_cast<float>(k) / static_cast<float>(factor);
                        to[k] = raised(left + along * (right - left), inverse);
                    }
                }
                to += factor;
                left = right;
            }
        }
    });
}

}  // namespace ocean
