// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The noise of neighbouring modes at once, for the first build of a sea.
#pragma once

#include <complex>
#include <cstdint>
#include <span>

namespace ocean {

/// Writes xi[i] = gaussian_noise(seed, cascade, n + i, m) of shaders/wave/noise.glsl in double,
/// rounded to float: the same bits.
void noise_row(std::uint32_t seed, std::uint32_t cascade, int n, int m,
               std::span<std::complex<float>> xi);

}  // namespace ocean
