// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads of the signals: cubic B-splines of four by four complex coefficients, turned by the
// carrier. Loops over a block of places compute the parts that all places have in common; the sum
// of coefficients takes four floats, two columns, at a time. The build compiles it once for each
// instruction set (core/CMakeLists.txt).
#pragma once

#include "base/simd/simd.hpp"
#include "coast/loops/signal_task.hpp"
#include "field/cubic.hpp"

namespace ocean::OCEAN_KERNEL {

constexpr std::size_t kPlaces = 64;            // of a block
constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to a whole number
constexpr double kSignalPi = 3.141592653589793;

using FourFloats = float __attribute__((vector_size(16)));

OCEAN_INLINE FourFloats load_four(const float* from) {
    FourFloats four;
    __builtin_memcpy(&four, from, sizeof(four));
    return four;
}

/// Returns the coefficients of t^n in the weights of the B-spline, times a factor.
template <int n>
OCEAN_INLINE FourFloats b_spline_power(float factor = 1.0f) {
    return FourFloats{kBSpline[n][0], kBSpline[n][1], kBSpline[n][2], kBSpline[n][3]} * factor;
}
/// Returns the weights of the four coefficients beside a place at t in its cell, 0 .. 1.
OCEAN_INLINE FourFloats spline_weights(float t) {
    return ((b_spline_power<3>() * t + b_spline_power<2>()) * t + b_spline_power<1>()) * t +
           b_spline_power<0>();
}
/// Returns the derivatives of the weights by t.
OCEAN_INLINE FourFloats spline_slopes(float t) {
    return (b_spline_power<3>(3.0f) * t + b_spline_power<2>(2.0f)) * t + b_spline_power<1>();
}

/// Four complex numbers, two to a register.
struct FourColumns {
    FourFloats low;
    FourFloats high;

    OCEAN_INLINE void add(float weight, const float* coefficients) {
        low += weight * load_four(coefficients);
        high += weight * load_four(coefficients + 4);
    }
    /// Writes the sum of the columns by their weights.
    OCEAN_INLINE void weigh(FourFloats weights, float& re, float& im) const {
        const FourFloats low_weights = __builtin_shufflevector(weights, weights, 0, 0, 1, 1);
        const FourFloats high_weights = __builtin_shufflevector(weights, weights, 2, 2, 3, 3);
        const FourFloats sum = low * low_weights + high * high_weights;
        re = sum[0] + sum[2];
        im = sum[1] + sum[3];
    }
};

/// A complex number for each place of a block.
struct PlaceNumbers {
    float re[kPlaces];
    float im[kPlaces];
};

/// A block of places: their cells, the carrier, and the demodulated signal.
struct SignalBlock {
    std::size_t count;
    std::uint32_t column[kPlaces];
    std::uint32_t row[kPlaces];
    float x[kPlaces];  // in the cell, 0 .. 1
    float y[kPlaces];
    float cosine[kPlaces];  // of the carrier
    float sine[kPlaces];
    PlaceNumbers value;
    PlaceNumbers by_x;  // per cell, then [1/m]
    PlaceNumbers by_y;
    PlaceNumbers rate;
};

/// Finds the cells of places along one axis. A place between two cells may be found in either.
OCEAN_INLINE void find_cells(const double* places, std::size_t n, double cells_per_metre,
                             std::uint32_t mask, std::uint32_t* cell, float* within) {
    for (std::size_t l = 0; l < n; ++l) {
        const double place = places[l] * cells_per_metre;
        const double shifted = (place - 0.5) + kRound;
        cell[l] = static_cast<std::uint32_t>(__builtin_bit_cast(std::uint64_t, shifted)) & mask;
        within[l] = static_cast<float>(place - (shifted - kRound));
    }
}

/// Writes e^(i pi h) of half turns h = a x + b y: reduced to |f| <= 1/2 in double, then the Taylor
/// series to f^13 and f^12, whose truncation is below 1e-8.
OCEAN_INLINE void find_carrier(const double* x, const double* y, std::size_t n, double a, double b,
                               float* cosine, float* sine) {
    float fraction[kPlaces];
    float sign[kPlaces];
    for (std::size_t l = 0; l < n; ++l) {
        const double half_turns = a * x[l] + b * y[l];
        const double whole = (half_turns + kRound) - kRound;
        const double odd = whole - 2.0 * ((0.5 * whole + kRound) - kRound);
        fraction[l] = static_cast<float>(half_turns - whole);
        sign[l] = static_cast<float>(1.0 - 2.0 * odd * odd);
    }
    for (std::size_t l = 0; l < n; ++l) {
        const float angle = fraction[l] * static_cast<float>(kSignalPi);
        const float q = angle * angle;
        float s = 1.0f / 6227020800.0f;
        s = s * q - 1.0f / 39916800.0f;
        s = s * q + 1.0f / 362880.0f;
        s = s * q - 1.0f / 5040.0f;
        s = s * q + 1.0f / 120.0f;
        s = s * q - 1.0f / 6.0f;
        float c = 1.0f / 479001600.0f;
        c = c * q - 1.0f / 3628800.0f;
        c = c * q + 1.0f / 40320.0f;
        c = c * q - 1.0f / 720.0f;
        c = c * q + 1.0f / 24.0f;
        c = c * q - 0.5f;
        sine[l] = sign[l] * (angle + angle * q * s);
        cosine[l] = sign[l] * (1.0f + q * c);
    }
}

/// Writes the sum of the coefficients beside each place, and with kGradient its derivatives.
template <bool kGradient>
OCEAN_INLINE void read_map(const SignalMap& map, std::uint32_t row_mask, SignalBlock& block,
                           PlaceNumbers& value) {
    for (std::size_t l = 0; l < block.count; ++l) {
        const FourFloats across = spline_weights(block.y[l]);
        const FourFloats across_slopes = spline_slopes(block.y[l]);
        FourColumns sum{};
        FourColumns slope{};
        for (std::uint32_t j = 0; j < 4; ++j) {
            const float* const at =
                map.values +
                2 * (((block.row[l] + j - 1) & row_mask) * map.pitch + block.column[l]);
            sum.add(across[j], at);
            if constexpr (kGradient) slope.add(across_slopes[j], at);
        }
        const FourFloats along = spline_weights(block.x[l]);
        sum.weigh(along, value.re[l], value.im[l]);
        if constexpr (kGradient) {
            sum.weigh(spline_slopes(block.x[l]), block.by_x.re[l], block.by_x.im[l]);
            slope.weigh(along, block.by_y.re[l], block.by_y.im[l]);
        }
    }
}

/// grad (g e^(i K.x)) = (grad g + i K g) e^(i K.x)
OCEAN_INLINE void end_gradient(const SignalTask& task, SignalBlock& block) {
    const auto cells_x = static_cast<float>(task.cells_per_metre[0]);
    const auto cells_y = static_cast<float>(task.cells_per_metre[1]);
    const auto k_x = static_cast<float>(kSignalPi * task.half_turns[0]);
    const auto k_y = static_cast<float>(kSignalPi * task.half_turns[1]);
    const PlaceNumbers& value = block.value;
    for (std::size_t l = 0; l < block.count; ++l) {
        block.by_x.re[l] = cells_x * block.by_x.re[l] - k_x * value.im[l];
        block.by_x.im[l] = cells_x * block.by_x.im[l] + k_x * value.re[l];
        block.by_y.re[l] = cells_y * block.by_y.re[l] - k_y * value.im[l];
        block.by_y.im[l] = cells_y * block.by_y.im[l] + k_y * value.re[l];
    }
}

/// Writes the numbers times the carrier from `first` on; skips nullptr.
OCEAN_INLINE void turn(const SignalBlock& block, const PlaceNumbers& of, float* out_re,
                       float* out_im, std::size_t first) {
    if (out_re != nullptr) {
        for (std::size_t l = 0; l < block.count; ++l) {
            out_re[first + l] = of.re[l] * block.cosine[l] - of.im[l] * block.sine[l];
        }
    }
    if (out_im != nullptr) {
        for (std::size_t l = 0; l < block.count; ++l) {
            out_im[first + l] = of.re[l] * block.sine[l] + of.im[l] * block.cosine[l];
        }
    }
}

static void run_signal_loop(const SignalTask& task) {
    const SignalOutputs& out = task.out;
    const bool gradient =
        out.re_x != nullptr || out.im_x != nullptr || out.re_y != nullptr || out.im_y != nullptr;
    const bool value = out.re != nullptr || out.im != nullptr;
    const bool rate = out.re_t != nullptr || out.im_t != nullptr;
    SignalBlock block;
    for (std::size_t first = 0; first < task.count; first += kPlaces) {
        const double* const x = task.x + first;
        const double* const y = task.y + first;
        const std::size_t count = task.count - first < kPlaces ? task.count - first : kPlaces;
        block.count = count;
        find_carrier(x, y, count, task.half_turns[0], task.half_turns[1], block.cosine, block.sine);
        find_cells(x, count, task.cells_per_metre[0], task.mask[0], block.column, block.x);
        find_cells(y, count, task.cells_per_metre[1], task.mask[1], block.row, block.y);
        if (gradient) {
            read_map<true>(task.value, task.mask[1], block, block.value);
            end_gradient(task, block);
            turn(block, block.by_x, out.re_x, out.im_x, first);
            turn(block, block.by_y, out.re_y, out.im_y, first);
        } else if (value) {
            read_map<false>(task.value, task.mask[1], block, block.value);
        }
        if (value) turn(block, block.value, out.re, out.im, first);
        if (!rate) continue;
        read_map<false>(task.rate, task.mask[1], block, block.rate);
        turn(block, block.rate, out.re_t, out.im_t, first);
    }
}

extern const SignalLoop kSignalLoop;
constexpr SignalLoop kSignalLoop = run_signal_loop;

}  // namespace ocean::OCEAN_KERNEL
