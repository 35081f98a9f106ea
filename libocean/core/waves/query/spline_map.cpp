// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spline coefficients by the transform; see spline_map.hpp.
#include "waves/query/spline_map.hpp"

#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "base/prefault_pages.hpp"

namespace ocean {
namespace {

/// Returns B^ of a wave that fits n times into `resolution` samples.
double kernel_transform(int n, int resolution) {
    if (n == 0) return 1.0;
    const double half = kPi * n / resolution;
    const double sinc = std::sin(half) / half;
    return sinc * sinc * sinc * sinc;
}

/// Returns 1 / B^ for each FFT index of a cascade's axis; 0 beyond the Nyquist line of a map of
/// `band`.
std::vector<double> axis_filter(const CascadeModes& cascade, int band, int resolution) {
    const int size = cascade.lattice.resolution;
    std::vector<double> filter(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
        const int n = cascade.divisor * signed_wavenumber(i, size);
        if (std::abs(n) >= band / 2) continue;
        filter[static_cast<std::size_t>(i)] = 1.0 / kernel_transform(n, resolution);
    }
    return filter;
}

}  // namespace

ModeFactor spline_factor(const Modes& modes, int band, int resolution) {
    std::vector<std::vector<double>> filters;
    std::vector<int> sizes;
    for (const CascadeModes& cascade : modes.cascades) {
        filters.push_back(axis_filter(cascade, band, resolution));
        sizes.push_back(cascade.lattice.resolution);
    }
    return [filters = std::move(filters), sizes = std::move(sizes)](std::size_t c, int n, int m) {
        const auto along = [&](int a) {
            return filters[c][static_cast<std::size_t>(fft_index(a, sizes[c]))];
        };
        return ModeScale{static_cast<float>(along(n) * along(m)), 1.0f};
    };
}

SplineMap::SplineMap(Lattice lattice, ThreadPool& pool)
    : lattice_(lattice), per_metre_(lattice.resolution / lattice.period), texels_(lattice.size()) {
    prefault_pages(texels_, pool);
}

SplineMap::Lines::Lines(Lattice lattice, std::span<const double> x) {
    const double per_metre = lattice.resolution / lattice.period;
    for (const double place : x) {
        const double u = place * per_metre;
        const long long i = floor_index(u);
        const auto offset = static_cast<float>(u - static_cast<double>(i));
        places_.push_back({i - 1, b_spline(offset), b_spline_slopes(offset)});
    }
}

MapOutput SplineMap::output(const std::array<Quantity, kFields>& quantities) {
    MapOutput output{reinterpret_cast<float*>(texels_.data()), kFields, {}};
    for (std::size_t c = 0; c < kFields; ++c) output.component[c].quantity = quantities[c];
    return output;
}

}  // namespace ocean
