// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The wavenumber lattice of a periodic square, in FFT order, and the constants that every stage
// shares. Every index of a mode or sample follows the conventions of this header.
#pragma once

#include <cstddef>
#include <numbers>

namespace ocean {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDegree = kPi / 180.0;  // [rad]
inline constexpr double kTwoPi = 2.0 * std::numbers::pi;
inline constexpr int kMinResolution = 32;
inline constexpr int kMaxResolution = 8192;

/// N x N modes or samples on a square of side `period` [m]. Sample (i, j) lies at (i, j) * period /
/// N; mode (n, m) has k = 2 pi (n, m) / period.
struct Lattice {
    int resolution = 0;
    double period = 0.0;

    double wavenumber_step() const { return kTwoPi / period; }
    /// Returns the shortest wavelength below the Nyquist line, along an axis: period / (N/2 - 1).
    double shortest_wavelength() const { return period / (resolution / 2 - 1); }
    std::size_t size() const {
        return static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution);
    }
};

/// Returns the signed wavenumber of an FFT index: 0 .. N/2-1, -N/2 .. -1.
constexpr int signed_wavenumber(int index, int n) {
    return index < n / 2 ? index : index - n;
}
/// Returns the FFT index of a signed wavenumber; the inverse of signed_wavenumber.
constexpr int fft_index(int wavenumber, int n) {
    return wavenumber < 0 ? wavenumber + n : wavenumber;
}
/// Returns the index of the mode (n, m), signed, in an array of size x size modes.
constexpr std::size_t mode_index(int n, int m, int size) {
    return static_cast<std::size_t>(fft_index(m, size)) * static_cast<std::size_t>(size) +
           static_cast<std::size_t>(fft_index(n, size));
}

constexpr bool is_power_of_two(long long n) {
    return n > 0 && (n & (n - 1)) == 0;
}
/// Returns true for the samples that a grid or a map may have along a side.
constexpr bool is_resolution(long long n) {
    return is_power_of_two(n) && n >= kMinResolution && n <= kMaxResolution;
}
/// Throws Error invalid_value unless is_resolution(resolution).
void require_resolution(int resolution);

}  // namespace ocean
