// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The modes as the rivals read them, row by row in FFT order, and the loops that make spectra from
// them at one time. As strong as we can make them: what a mode keeps over time is computed before,
// sine and cosine are a polynomial in turns, and the compiler vectorises all of it.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "base/simd/simd_level.hpp"
#include "huge_array.hpp"
#include "ocean/internal/modes.hpp"

namespace ocean::bench {

/// Returns the FFT index of -k, at which h0(-k) is read from the same array.
constexpr int mirror_index(int index, int n) {
    return index == 0 ? 0 : n - index;
}

/// One row of modes. h(k, t) = p cos + q sin of 2 pi rate tau, with p = h0(k) + conj(h0(-k)) and
/// q = i (conj(h0(-k)) - h0(k)).
struct SpectralRow {
    const float* p_re;
    const float* p_im;
    const float* q_re;
    const float* q_im;
    const float* rate_high;  // turns per tau
    const float* rate_low;
    const float* displacement;
    const float* kx;
    float ky;
    float tau_high;
    float tau_low;
    int count;
};

/// Writes one row of spectra, complex interleaved, one after `plane` floats of the other.
using SpectralLoop = void (*)(const SpectralRow& row, float* spectra, std::ptrdiff_t plane);
struct SpectralLoops {
    SpectralLoop planes5;  // height, displacement, slope
    SpectralLoop planes8;  // and gradients xx, yy, xy
    SpectralLoop pairs3;   // (height, 0), (displacement), (slope)
    SpectralLoop pairs4;   // (height, gradient xy), (displacement), (slope), (gradient xx, yy)
};
/// Compiled for that instruction set: avx2 or avx512.
const SpectralLoops& spectral_loops(SimdLevel level);

class RivalModes {
  public:
    /// columns: resolution / 2 + 1 for real transforms, resolution for complex ones.
    RivalModes(const Modes& modes, int columns);

    int rows() const { return static_cast<int>(ky_.size()); }
    SpectralRow row(int j, double tau) const;

  private:
    std::size_t columns_;
    HugeArray<float> p_re_, p_im_, q_re_, q_im_, rate_high_, rate_low_, displacement_;
    std::vector<float> kx_, ky_;
};

/// A sea of the benchmark: the default one, a wind sea of U10 = 10 m/s, half a metre a sample; on
/// water of the physics that all subjects have, which is 200 m deep and without surface tension.
struct Sea {
    Sea(int resolution, ThreadPool& pool);

    Parameters parameters;
    Modes modes;
};

struct RivalSea {
    explicit RivalSea(const Modes& modes)
        : half(modes, modes.lattice.resolution / 2 + 1), full(modes, modes.lattice.resolution) {}

    RivalModes half;  // for real transforms
    RivalModes full;
};

}  // namespace ocean::bench
