// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The contract of libocean's Fourier transforms, and the reference implementation. For complex x of
// length N, a power of two: forward X_k = sum_j x_j exp(-2 pi i j k / N), inverse x_j = sum_k X_k
// exp(+2 pi i j k / N). Both are unnormalised, so that inverse(forward(x)) = N x; both work in
// place, in natural order.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace ocean {

enum class FftDirection { forward, inverse };

/// Cooley and Tukey's radix-2 decimation in time with bit reversal and precomputed roots of unity.
/// Written to be read; the fast transform is part of the backend `cpu`. Immutable: any thread may
/// use it.
template <typename Real>
class Radix2Fft {
  public:
    /// Computes the tables for N = n, a power of two, 2 .. 2^20.
    explicit Radix2Fft(int n);
    int size() const { return n_; }
    /// Transforms N values that lie `stride` apart, in place.
    void transform(std::complex<Real>* data, std::ptrdiff_t stride, FftDirection direction) const;
    /// Transforms an N x N row-major array in place: along every row, then along every column.
    void transform_2d(std::span<std::complex<Real>> data, FftDirection direction) const;

  private:
    int n_;
    std::vector<int> reversed_;
    std::vector<std::complex<Real>> twiddle_;  // exp(-2 pi i k / N), k < N/2
};

extern template class Radix2Fft<float>;
extern template class Radix2Fft<double>;

}  // namespace ocean
