// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// shaders/wave/noise.glsl in loops across modes that the compiler turns into vectors: each of its
// branches becomes a choice between two values, and whole numbers become doubles by their bits,
// because SSE2 can do no more. All operations are the formula's, so that the bits are equal; proved
// by Noise.ARowHasTheBitsOfTheFormula.
#include "base/noise_row.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "wave/wave.hpp"

namespace ocean {

namespace {

namespace formula = wave::double_precision;

constexpr std::size_t kLanes = 64;
using Words = std::array<std::uint32_t, kLanes>;
using Reals = std::array<double, kLanes>;

/// Computes the first two words of philox_4x32.
void philox(std::uint32_t seed, std::uint32_t cascade, int n, int m, Words& a, Words& b) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        std::uint32_t c0 = static_cast<std::uint32_t>(n) + static_cast<std::uint32_t>(i);
        std::uint32_t c1 = static_cast<std::uint32_t>(m);
        std::uint32_t c2 = cascade;
        std::uint32_t c3 = 0;
        std::uint32_t key0 = seed;
        std::uint32_t key1 = 0x6F636561u;
        for (int round = 0; round < 10; ++round) {
            const std::uint64_t x = std::uint64_t{0xD2511F53u} * c0;
            const std::uint64_t y = std::uint64_t{0xCD9E8D57u} * c2;
            c0 = static_cast<std::uint32_t>(y >> 32) ^ c1 ^ key0;
            c1 = static_cast<std::uint32_t>(y);
            c2 = static_cast<std::uint32_t>(x >> 32) ^ c3 ^ key1;
            c3 = static_cast<std::uint32_t>(x);
            key0 += 0x9E3779B9u;
            key1 += 0xBB67AE85u;
        }
        a[i] = c0;
        b[i] = c1;
    }
}

/// Returns x as a double, exactly: the bits of 2^52 + x are the bits of 2^52 plus x.
double real_of(std::uint64_t x) {
    constexpr double kTwo52 = 4503599627370496.0;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(kTwo52) | x) - kTwo52;
}

/// Computes sqrt(2 minus_log_uniform(x)).
void radius_of(const Words& words, Reals& radius) {
    constexpr std::uint64_t kMantissa = (std::uint64_t{1} << 52) - 1;
    constexpr std::uint64_t kOne = std::uint64_t{1023} << 52;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double t = real_of(words[i]) + 0.5;
        const double gap = (real_of(0xFFFFFFFFu - words[i]) + 0.5) * 2.3283064365386963e-10;
        // These lines stand for findMSB and ldexp: the exponent of t, and t with the exponent of 1.
        const auto bits = std::bit_cast<std::uint64_t>(t);
        const double exponent = real_of(bits >> 52) - 1023.0;
        const double unit = std::bit_cast<double>((bits & kMantissa) | kOne);
        const bool upper = unit > 1.4142135623730951;
        const double mantissa = upper ? 0.5 * unit : unit;
        const double whole = 32.0 - (upper ? exponent + 1.0 : exponent);

        const bool near_one = t >= 3037000500.5;
        const double above = near_one ? gap : mantissa - 1.0;
        const double below = near_one ? 2.0 - gap : mantissa + 1.0;
        const double log = formula::two_artanh(above / below);
        radius[i] = std::sqrt(2.0 * (near_one ? log : whole * 0.6931471805599453 - log));
    }
}

/// Computes radius times the cosine and sine of sin_cos_turns(x / 2^32).
void turned(const Reals& radius, const Words& words, Reals& re, Reals& im) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double turns = real_of(words[i]) * 2.3283064365386963e-10;
        const auto quarter = static_cast<double>(static_cast<std::int32_t>(4.0 * turns + 0.5));
        const double x = (turns - 0.25 * quarter) * 6.283185307179586;
        const double q = x * x;
        double s = -1.0 / 1307674368000.0;
        s = s * q + 1.0 / 6227020800.0;
        s = s * q - 1.0 / 39916800.0;
        s = s * q + 1.0 / 362880.0;
        s = s * q - 1.0 / 5040.0;
        s = s * q + 1.0 / 120.0;
        s = s * q - 1.0 / 6.0;
        s = x + x * q * s;
        double c = 1.0 / 20922789888000.0;
        c = c * q - 1.0 / 87178291200.0;
        c = c * q + 1.0 / 479001600.0;
        c = c * q - 1.0 / 3628800.0;
        c = c * q + 1.0 / 40320.0;
        c = c * q - 1.0 / 720.0;
        c = c * q + 1.0 / 24.0;
        c = c * q - 0.5;
        c = c * q + 1.0;
        // Quarters are 0 .. 4. This form avoids the branches of ||.
        const bool swapped = std::abs(quarter - 2.0) == 1.0;
        const double cosine = swapped ? s : c;
        const double sine = swapped ? c : s;
        const bool left = std::abs(quarter - 1.5) < 1.0;
        const bool lower = std::abs(quarter - 2.5) < 1.0;
        re[i] = radius[i] * (left ? -cosine : cosine);
        im[i] = radius[i] * (lower ? -sine : sine);
    }
}

}  // namespace

void noise_row(std::uint32_t seed, std::uint32_t cascade, int n, int m,
               std::span<std::complex<float>> xi) {
    Words a, b;
    Reals radius, re, im;
    for (std::size_t done = 0; done < xi.size(); done += kLanes) {
        philox(seed, cascade, n + static_cast<int>(done), m, a, b);
        radius_of(a, radius);
        turned(radius, b, re, im);
        const std::size_t count = std::min(kLanes, xi.size() - done);
        for (std::size_t i = 0; i < count; ++i) {
            xi[done + i] = {static_cast<float>(re[i]), static_cast<float>(im[i])};
        }
    }
}

}  // namespace ocean
