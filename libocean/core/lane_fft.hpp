// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Inverse transforms of many lines at once: the inner loops run across the lines, so the compiler
// vectorises them without a shuffle. Used by the cpu backend. Same contract as fft.hpp.
#pragma once

#include <vector>

namespace ocean {

/// Lines transformed together. 16 floats are one AVX-512 register or two of AVX2.
inline constexpr int kLanes = 16;

/// N x kLanes complex values as two planes; element j of line l at [j * kLanes + l].
struct LaneBlock {
    std::vector<float> re;
    std::vector<float> im;

    explicit LaneBlock(int n)
        : re(static_cast<std::size_t>(n) * kLanes), im(static_cast<std::size_t>(n) * kLanes) {}
};

/// Stockham's self-sorting radix-4 transform: no bit reversal, sequential reads and writes.
/// [Van Loan 1992] sec. 1.7. Immutable.
class LaneFft {
  public:
    explicit LaneFft(int n);
    /// data <- inverse(data), unnormalised; `work` is overwritten.
    void inverse(LaneBlock& data, LaneBlock& work) const;

  private:
    struct Twiddle {
        float re;
        float im;
    };
    int n_;
    std::vector<Twiddle> twiddle_;  // exp(+2 pi i k / N), k < N
};

}  // namespace ocean
