// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Which cascades a grid has, and which wavenumbers belong to each.
#include "ocean/internal/cascades.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "ocean/internal/grid.hpp"

namespace ocean {

namespace {

bool is_prime(int n) {
    for (int d = 2; d * d <= n; ++d) {
        if (n % d == 0) return false;
    }
    return n > 1;
}

/// Returns |k|^2 in steps of the patch's lattice: a whole number below 2^53.
double square_of(const CascadeBand& band, int n, int m) {
    const auto x = static_cast<double>(std::int64_t{n} * band.divisor);
    const auto y = static_cast<double>(std::int64_t{m} * band.divisor);
    return x * x + y * y;
}

}  // namespace

bool CascadeBand::contains(int n, int m) const {
    return !is_inside(n, m) && square_of(*this, n, m) < outer * outer;
}

bool CascadeBand::is_inside(int n, int m) const {
    return square_of(*this, n, m) < inner * inner ||
           static_cast<double>(std::max(std::abs(n), std::abs(m))) * divisor < inner_side;
}

std::vector<int> cascade_divisors(const Grid& grid) {
    if (!grid.cascade_divisors.empty()) return grid.cascade_divisors;
    constexpr int kFarthest = 7;
    constexpr int kFirstModes = 8;  // a band begins that many modes from its lattice's origin
    const int apart = std::clamp(grid.resolution / 2 / kFirstModes, 2, kFarthest);
    std::vector<int> divisors = {1};
    while (static_cast<int>(divisors.size()) < grid.cascades) {
        int next = apart * divisors.back();
        while (!is_prime(next)) ++next;
        divisors.push_back(next);
    }
    return divisors;
}

std::vector<CascadeBand> cascade_bands(const Grid& grid) {
    const double half = grid.resolution / 2;
    std::vector<CascadeBand> bands;
    for (const int divisor : cascade_divisors(grid)) {
        const double inner = bands.empty() ? 0.0 : bands.back().divisor * half;
        bands.push_back({divisor, inner});
    }
    for (std::size_t c = 0; c + 1 < bands.size(); ++c) bands[c].outer = bands[c + 1].inner;
    return bands;
}

double shortest_wave(const Grid& grid) {
    return Lattice{grid.resolution, grid.patch_size / cascade_divisors(grid).back()}
        .shortest_wavelength();
}

double shortest_wave(const Grid& grid, int map_resolution) {
    return std::max(shortest_wave(grid),
                    Lattice{map_resolution, grid.patch_size}.shortest_wavelength());
}

long long complete_map_resolution(const Grid& grid) {
    const long long extent =
        static_cast<long long>(grid.resolution) * cascade_divisors(grid).back();
    long long resolution = grid.resolution;
    while (resolution < extent) resolution *= 2;
    return resolution;
}

int default_map_resolution(const Grid& grid) {
    constexpr int kLargest = 4096;
    if (grid.cascades == 1) return grid.resolution;
    const long long most = std::min<long long>(kLargest, complete_map_resolution(grid));
    return static_cast<int>(
        std::max<long long>(grid.resolution, std::min<long long>(4 * grid.resolution, most)));
}

}  // namespace ocean
