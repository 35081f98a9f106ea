// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The classic way to a fractional surface; see terrain_stages.hpp.
#include "ocean/internal/terrain_stages.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>

#include "ocean/internal/fft.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/terrain_law.hpp"
#include "ocean/internal/terrain_modes.hpp"

namespace ocean {
namespace {

using ComplexPlane = std::vector<std::complex<double>>;

/// Returns the whole plane of waves from its half: g(-n, -m) = conj g(n, m).
ComplexPlane mirrored(const TerrainNoise& noise) {
    const int size = noise.resolution();
    ComplexPlane plane(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (int m = 1 - size / 2; m < size / 2; ++m) {
        const auto row = noise.row(m);
        for (int n = 0; n < size / 2; ++n) {
            if (n == 0 && m <= 0) continue;
            const std::complex<double> g = row[static_cast<std::size_t>(n)];
            plane[mode_index(n, m, size)] = g;
            plane[mode_index(-n, -m, size)] = std::conj(g);
        }
    }
    return plane;
}

/// Returns magnitudes with k = 0 in the middle.
std::vector<float> centred_magnitudes(const ComplexPlane& plane, int size, double factor) {
    std::vector<float> centred(plane.size());
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
            const std::size_t from = mode_index(i - size / 2, j - size / 2, size);
            const std::size_t to = static_cast<std::size_t>(j) * static_cast<std::size_t>(size) +
                                   static_cast<std::size_t>(i);
            centred[to] = static_cast<float>(factor * std::abs(plane[from]));
        }
    }
    return centred;
}

std::vector<float> real_parts(const ComplexPlane& plane, double factor, double added) {
    std::vector<float> result;
    result.reserve(plane.size());
    for (const std::complex<double>& value : plane) {
        result.push_back(static_cast<float>(factor * value.real() + added));
    }
    return result;
}

/// Returns the filter of each wave, gain sqrt(S) dk [m], in FFT order; 0 where there is no wave.
ComplexPlane filter_plane(const TerrainModel& terrain, double gain) {
    const int size = terrain.resolution;
    const double dk = kTwoPi / terrain.patch_size;
    const TerrainAmplitudes amplitude(TerrainLaw(terrain), dk, dk * size);
    ComplexPlane plane(lattice_of(terrain).size());
    for (int m = 1 - size / 2; m < size / 2; ++m) {
        for (int n = 1 - size / 2; n < size / 2; ++n) {
            plane[mode_index(n, m, size)] = gain * dk * amplitude(n * dk, m * dk);
        }
    }
    return plane;
}

}  // namespace

TerrainStages terrain_stages(Terrain& land) {
    const TerrainModel& terrain = land.model();
    const int size = terrain.resolution;
    constexpr std::uint64_t kBytesPerSample = 2 * sizeof(std::complex<double>) + 5 * sizeof(float);
    require_memory(lattice_of(terrain).size() * kBytesPerSample, "the stages of the terrain");
    const Radix2Fft<double> fft(size);
    const double per_side = 1.0 / size;

    TerrainStages stages;
    stages.resolution = size;
    ComplexPlane waves = mirrored(TerrainNoise(terrain, land.pool()));
    fft.transform_2d(waves, FftDirection::inverse);
    // The mean of |g|^2 is 2, and N^2 waves add up.
    const double unit = per_side / std::sqrt(2.0);
    stages.noise = real_parts(waves, unit, 0.0);
    for (std::size_t i = 0; i < waves.size(); ++i) waves[i] = unit * waves[i].real();

    fft.transform_2d(waves, FftDirection::forward);
    stages.transform = centred_magnitudes(waves, size, per_side);

    const ComplexPlane filter = filter_plane(terrain, land.scale().gain);
    stages.filter = centred_magnitudes(filter, size, 1.0);
    for (std::size_t i = 0; i < waves.size(); ++i) waves[i] *= per_side * filter[i].real();
    stages.filtered = centred_magnitudes(waves, size, 1.0);

    fft.transform_2d(waves, FftDirection::inverse);
    stages.height = real_parts(waves, 1.0, land.offset());
    return stages;
}

const std::vector<float>& plane_of(const TerrainStages& stages, TerrainStep step) {
    switch (step) {
        case TerrainStep::noise:
            return stages.noise;
        case TerrainStep::transform:
            return stages.transform;
        case TerrainStep::filter:
            return stages.filter;
        case TerrainStep::filtered:
            return stages.filtered;
        case TerrainStep::height:
            break;
    }
    return stages.height;
}

}  // namespace ocean
