// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The Fourier transform by its defining sum: the reference for all others.
#pragma once

#include <cstddef>

#include "ocean/internal/fft.hpp"
#include "ocean/internal/grid.hpp"
#include "testing.hpp"

namespace ocean::test {

/// Returns the transform of any number N of values, in double: N^2 operations.
inline std::vector<std::complex<double>> direct_dft(std::span<const std::complex<double>> data,
                                                    FftDirection direction) {
    const std::size_t n = data.size();
    const double sign = direction == FftDirection::forward ? -1.0 : 1.0;
    std::vector<std::complex<double>> root(n);
    for (std::size_t i = 0; i < n; ++i) {
        root[i] = std::polar(1.0, sign * kTwoPi * static_cast<double>(i) / static_cast<double>(n));
    }
    std::vector<std::complex<double>> result(n);
    for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t j = 0; j < n; ++j) result[k] += data[j] * root[j * k % n];
    }
    return result;
}

}  // namespace ocean::test
