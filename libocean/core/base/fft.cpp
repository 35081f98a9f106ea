// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The reference transform: radix-2 in the order of the textbook.
#include "ocean/internal/fft.hpp"

#include <cmath>
#include <utility>

#include "ocean/internal/grid.hpp"

namespace ocean {

template <typename Real>
Radix2Fft<Real>::Radix2Fft(int n) : n_(n) {
    int bits = 0;
    while ((1 << bits) < n) ++bits;
    reversed_.resize(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        int reversed = 0;
        for (int b = 0; b < bits; ++b) reversed |= ((i >> b) & 1) << (bits - 1 - b);
        reversed_[static_cast<std::size_t>(i)] = reversed;
    }
    for (int k = 0; k < n / 2; ++k) {
        const double angle = -kTwoPi * k / n;
        twiddle_.emplace_back(static_cast<Real>(std::cos(angle)),
                              static_cast<Real>(std::sin(angle)));
    }
}

template <typename Real>
void Radix2Fft<Real>::transform(std::complex<Real>* data, std::ptrdiff_t stride,
                                FftDirection direction) const {
    for (int i = 0; i < n_; ++i) {
        const int j = reversed_[static_cast<std::size_t>(i)];
        if (i < j) std::swap(data[i * stride], data[j * stride]);
    }
    // Butterflies of growing span: two transforms of length half become one of length 2 half.
    for (int half = 1; half < n_; half *= 2) {
        const int twiddle_step = n_ / (2 * half);
        for (int start = 0; start < n_; start += 2 * half) {
            for (int k = 0; k < half; ++k) {
                const std::complex<Real> forward =
                    twiddle_[static_cast<std::size_t>(k * twiddle_step)];
                const std::complex<Real> w =
                    direction == FftDirection::forward ? forward : std::conj(forward);
                std::complex<Real>& top = data[(start + k) * stride];
                std::complex<Real>& bottom = data[(start + k + half) * stride];
                const std::complex<Real> turned(
                    w.real() * bottom.real() - w.imag() * bottom.imag(),
                    w.real() * bottom.imag() + w.imag() * bottom.real());
                bottom = top - turned;
                top += turned;
            }
        }
    }
}

template <typename Real>
void Radix2Fft<Real>::transform_2d(std::span<std::complex<Real>> data,
                                   FftDirection direction) const {
    for (int row = 0; row < n_; ++row) {
        transform(data.data() + static_cast<std::ptrdiff_t>(row) * n_, 1, direction);
    }
    for (int column = 0; column < n_; ++column) transform(data.data() + column, n_, direction);
}

template class Radix2Fft<float>;
template class Radix2Fft<double>;

}  // namespace ocean
