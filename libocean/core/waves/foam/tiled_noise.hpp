// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Gaussian noise of a band of wavenumbers on a periodic square: patches of foam, streaks, and the
// bending of the walls of cells.
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

namespace ocean {

/// The band, with wavenumbers in cycles per period. Amplitudes fall as k^(-falloff / 4), with k =
/// |(stretch n, m)| of the mode (n, m): patches are `stretch` times as long along x as along y.
struct NoiseBand {
    double lowest, highest;
    int falloff;
    double stretch = 1.0;
};

/// Two independent fields of variance 1, as real and imaginary part.
class TiledNoise {
  public:
    /// Draws the noise for rows of `size` samples, without modes beyond a third of `size`, which
    /// such rows could not show. The other modes do not depend on the size; `field` and `seed`
    /// select the draws.
    TiledNoise(std::uint32_t seed, std::uint32_t field, const NoiseBand& band, int size);
    /// Writes the samples at y = v periods, x = (i + 1/2) / values.size() periods.
    void row(double v, std::span<std::complex<float>> values) const;

  private:
    int side_;  // side of the interpolated grid
    std::vector<std::complex<float>> grid_;
};

}  // namespace ocean
