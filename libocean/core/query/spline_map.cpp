// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spline coefficients by the transform; see spline_map.hpp.
#include "query/spline_map.hpp"

#include <cmath>
#include <cstdlib>

#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

/// B^ of a wave that fits n times into `resolution` samples.
double kernel_transform(int n, int resolution) {
    if (n == 0) return 1.0;
    const double half = kPi * n / resolution;
    const double sinc = std::sin(half) / half;
    return sinc * sinc * sinc * sinc;
}

/// 1 / B^ for each FFT index of a cascade's axis; 0 beyond the Nyquist line of a map of `band`.
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

Modes spline_modes(const Modes& modes, int band, int resolution) {
    Modes filtered = modes;
    for (CascadeModes& cascade : filtered.cascades) {
        const std::vector<double> filter = axis_filter(cascade, band, resolution);
        auto h0 = cascade.h0.begin();
        for (const double along_y : filter) {
            for (const double along_x : filter) *h0++ *= static_cast<float>(along_x * along_y);
        }
    }
    return filtered;
}

SplineMap::SplineMap(Lattice lattice, const std::array<std::span<const float>, 3>& planes,
                     ThreadPool& pool)
    : lattice_(lattice), per_metre_(lattice.resolution / lattice.period), texels_(lattice.size()) {
    const auto width = static_cast<std::size_t>(lattice.resolution);
    pool.for_each_range(lattice.resolution, [&](int first, int last) {
        const std::size_t end = static_cast<std::size_t>(last) * width;
        for (std::size_t i = static_cast<std::size_t>(first) * width; i < end; ++i) {
            texels_[i] = {{planes[0][i], planes[1][i], planes[2][i], 0.0f}};
        }
    });
}

SplineMap make_spline_map(const Modes& modes, double time, const std::array<Channel, 3>& channels,
                          int resolution, ThreadPool& pool) {
    SurfaceSettings plain;
    plain.choppiness = 1.0;
    const ChannelSet set = {channels[0], channels[1], channels[2]};
    const Surface surface = make_surface(modes, plain, time, set, Backend::cpu, pool, resolution);
    return SplineMap(
        {resolution, modes.lattice.period},
        {surface.channel(channels[0]), surface.channel(channels[1]), surface.channel(channels[2])},
        pool);
}

}  // namespace ocean
