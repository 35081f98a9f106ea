// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads of the signals: cubic B-splines of four by four complex coefficients, turned by the
// carrier. What every place needs alike is computed in loops over a block of places, the sum of
// coefficients four floats, two columns, at a time.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "ocean/error.hpp"
#include "shore/band_signals.hpp"

namespace ocean {

namespace {

constexpr std::size_t kPlaces = 64;            // of a block
constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: a sum with it is rounded to whole

FourFloats load_four(const float* from) {
    FourFloats four;
    std::memcpy(&four, from, sizeof(four));
    return four;
}

/// Returns the weights of the four coefficients beside a place at t in its cell, 0 .. 1: the kernel
/// of the cubic B-spline [Unser 1999] as polynomials of t.
FourFloats spline_weights(float t) {
    constexpr float kSixth = 1.0f / 6.0f;
    const FourFloats c0 = {kSixth, 4.0f * kSixth, kSixth, 0.0f};
    const FourFloats c1 = {-0.5f, 0.0f, 0.5f, 0.0f};
    const FourFloats c2 = {0.5f, -1.0f, 0.5f, 0.0f};
    const FourFloats c3 = {-kSixth, 0.5f, -0.5f, kSixth};
    return ((c3 * t + c2) * t + c1) * t + c0;
}
/// Returns their derivatives.
FourFloats spline_slopes(float t) {
    const FourFloats c1 = {-0.5f, 0.0f, 0.5f, 0.0f};
    const FourFloats c2 = {1.0f, -2.0f, 1.0f, 0.0f};
    const FourFloats c3 = {-0.5f, 1.5f, -1.5f, 0.5f};
    return (c3 * t + c2) * t + c1;
}

/// Four complex numbers, two to a register.
struct FourColumns {
    FourFloats low{};
    FourFloats high{};

    void add(float weight, const float* coefficients) {
        low += weight * load_four(coefficients);
        high += weight * load_four(coefficients + 4);
    }
    /// Writes the sum of the columns by their weights.
    void weigh(FourFloats weights, float& re, float& im) const {
        const FourFloats low_weights = __builtin_shufflevector(weights, weights, 0, 0, 1, 1);
        const FourFloats high_weights = __builtin_shufflevector(weights, weights, 2, 2, 3, 3);
        const FourFloats sum = low * low_weights + high * high_weights;
        re = sum[0] + sum[2];
        im = sum[1] + sum[3];
    }
};

/// The carriers of a block of places.
struct Carrier {
    const float* cosine;
    const float* sine;
    std::size_t count;

    /// Writes (re + i im) (cosine + i sine); skips nullptr.
    void turn(const float* re, const float* im, float* out_re, float* out_im) const {
        if (out_re != nullptr) {
            for (std::size_t l = 0; l < count; ++l) out_re[l] = re[l] * cosine[l] - im[l] * sine[l];
        }
        if (out_im != nullptr) {
            for (std::size_t l = 0; l < count; ++l) out_im[l] = re[l] * sine[l] + im[l] * cosine[l];
        }
    }
};

float* offset(float* values, std::size_t first) {
    return values == nullptr ? nullptr : values + first;
}

}  // namespace

/// Holds the weights that a block of places shares, and the demodulated signal there.
struct BandSignals::Block {
    std::uint32_t column[kPlaces];
    std::uint32_t row[kPlaces];
    float x[kPlaces];  // in the cell, 0 .. 1
    float y[kPlaces];
    float cosine[kPlaces];  // of the carrier
    float sine[kPlaces];
    float re[kPlaces];
    float im[kPlaces];
    float re_x[kPlaces];  // per cell
    float im_x[kPlaces];
    float re_y[kPlaces];
    float im_y[kPlaces];
};

namespace {

/// Finds the cells of places along one axis. A place between two cells may be found in either.
void find_cells(const double* places, std::size_t n, double cells_per_metre, std::uint32_t mask,
                std::uint32_t* cell, float* within) {
    for (std::size_t l = 0; l < n; ++l) {
        const double place = places[l] * cells_per_metre;
        const double shifted = (place - 0.5) + kRound;
        cell[l] = static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(shifted)) & mask;
        within[l] = static_cast<float>(place - (shifted - kRound));
    }
}

/// Writes e^(i pi h) of half turns h = a x + b y: reduced to |f| <= 1/2 in double, then the Taylor
/// series to f^13 and f^12, whose truncation is below 1e-8.
void find_carrier(const double* x, const double* y, std::size_t n, double a, double b,
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
        const float angle = fraction[l] * static_cast<float>(kPi);
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

}  // namespace

template <bool kGradient>
void BandSignals::read_block(const Pair& pair, const SplineRows& map, const double* x,
                             const double* y, std::size_t n, Block& block) {
    const auto row_mask = static_cast<std::uint32_t>(pair.side[1] - 1);
    const float* const values = map.values.data();
    find_cells(x, n, pair.side[0] / pair.lattice.period,
               static_cast<std::uint32_t>(pair.side[0] - 1), block.column, block.x);
    find_cells(y, n, pair.side[1] / pair.lattice.period, row_mask, block.row, block.y);
    for (std::size_t l = 0; l < n; ++l) {
        const FourFloats across = spline_weights(block.y[l]);
        const FourFloats across_slopes = spline_slopes(block.y[l]);
        FourColumns sum;
        FourColumns slope;
        for (std::uint32_t j = 0; j < 4; ++j) {
            const float* const at =
                values + 2 * (((block.row[l] + j - 1) & row_mask) * map.pitch + block.column[l]);
            sum.add(across[j], at);
            if constexpr (kGradient) slope.add(across_slopes[j], at);
        }
        const FourFloats along = spline_weights(block.x[l]);
        sum.weigh(along, block.re[l], block.im[l]);
        if constexpr (kGradient) {
            sum.weigh(spline_slopes(block.x[l]), block.re_x[l], block.im_x[l]);
            slope.weigh(along, block.re_y[l], block.im_y[l]);
        }
    }
}

void BandSignals::read(std::size_t index, std::size_t n, const double* x, const double* y,
                       const SignalOutputs& out) const {
    if (out.has_rate() && !rates_) {
        throw Error(ErrorKind::invalid_value, "the signals were made without their rates");
    }
    const Pair& pair = pairs_[index];
    const double period = pair.lattice.period;
    const double half_turns_x = 2.0 * pair.lattice.carrier[0] / period;
    const double half_turns_y = 2.0 * pair.lattice.carrier[1] / period;
    Block block;
    for (std::size_t first = 0; first < n; first += kPlaces) {
        const std::size_t count = std::min(kPlaces, n - first);
        const double* const block_x = x + first;
        const double* const block_y = y + first;
        const Carrier carrier{block.cosine, block.sine, count};
        find_carrier(block_x, block_y, count, half_turns_x, half_turns_y, block.cosine, block.sine);
        const auto write = [&](const float* re, const float* im, float* out_re, float* out_im) {
            carrier.turn(re, im, offset(out_re, first), offset(out_im, first));
        };
        if (out.has_gradient()) {
            read_block<true>(pair, pair.map[0], block_x, block_y, count, block);
            // grad (g e^(i K.x)) = (grad g + i K g) e^(i K.x)
            const auto cells_x = static_cast<float>(pair.side[0] / period);
            const auto cells_y = static_cast<float>(pair.side[1] / period);
            const auto k_x = static_cast<float>(kPi * half_turns_x);
            const auto k_y = static_cast<float>(kPi * half_turns_y);
            for (std::size_t l = 0; l < count; ++l) {
                block.re_x[l] = cells_x * block.re_x[l] - k_x * block.im[l];
                block.im_x[l] = cells_x * block.im_x[l] + k_x * block.re[l];
                block.re_y[l] = cells_y * block.re_y[l] - k_y * block.im[l];
                block.im_y[l] = cells_y * block.im_y[l] + k_y * block.re[l];
            }
            write(block.re_x, block.im_x, out.re_x, out.im_x);
            write(block.re_y, block.im_y, out.re_y, out.im_y);
        } else if (out.has_value()) {
            read_block<false>(pair, pair.map[0], block_x, block_y, count, block);
        }
        write(block.re, block.im, out.re, out.im);
        if (!out.has_rate()) continue;
        read_block<false>(pair, pair.map[1], block_x, block_y, count, block);
        write(block.re, block.im, out.re_t, out.im_t);
    }
}

}  // namespace ocean
