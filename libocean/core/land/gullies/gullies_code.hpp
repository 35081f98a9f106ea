// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The loop of the gullies for one instruction set: the formulas that the GPU compiles, with a
// vector of points for each number. The build compiles it once for each instruction set
// (core/CMakeLists.txt).
#pragma once

#include "base/simd/simd.hpp"
#include "land/gullies/gullies_task.hpp"

namespace ocean::OCEAN_KERNEL {

namespace land {

using real = Vec;

/// kLanes unsigned integers of 32 bits, with the arithmetic of one.
struct Uint {
    using UintLanes = std::uint32_t __attribute__((vector_size(4 * kLanes)));
    UintLanes v;

    Uint() = default;
    OCEAN_INLINE Uint(UintLanes lanes) : v(lanes) {}
    OCEAN_INLINE Uint(std::uint32_t x) : v(x - UintLanes{}) {}
    /// Takes integers below 2^31.
    OCEAN_INLINE explicit operator Vec() const {
        return Lanes(__builtin_convertvector(reinterpret_cast<IntLanes>(v), Lanes));
    }
};
OCEAN_INLINE Uint operator+(Uint a, Uint b) {
    return a.v + b.v;
}
OCEAN_INLINE Uint operator-(Uint a, Uint b) {
    return a.v - b.v;
}
OCEAN_INLINE Uint operator*(Uint a, Uint b) {
    return a.v * b.v;
}
OCEAN_INLINE Uint operator^(Uint a, Uint b) {
    return a.v ^ b.v;
}
OCEAN_INLINE Uint operator&(Uint a, Uint b) {
    return a.v & b.v;
}
OCEAN_INLINE Uint operator>>(Uint a, int bits) {
    return a.v >> bits;
}
OCEAN_INLINE Uint min(Uint a, Uint b) {
    return Uint::UintLanes(a.v < b.v ? a.v : b.v);
}

OCEAN_INLINE Vec abs(Vec x) {
    return Vec(reinterpret_cast<Lanes>(reinterpret_cast<IntLanes>(x.v) & 0x7fffffff));
}
OCEAN_INLINE Vec sqrt(Vec x) {
#if defined(__AVX512F__)
    return Lanes(_mm512_sqrt_ps(x.v));
#elif defined(__AVX2__)
    return Lanes(_mm256_sqrt_ps(x.v));
#elif defined(__SSE2__)
    return Lanes(_mm_sqrt_ps(x.v));
#else
    for (int k = 0; k < kLanes; ++k) x.v[k] = __builtin_sqrtf(x.v[k]);
    return x;
#endif
}
/// Returns the largest integer that is at most x, |x| < 2^22.
OCEAN_INLINE Vec floor(Vec x) {
#if defined(__AVX512F__)
    return Lanes(_mm512_roundscale_ps(x.v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC));
#elif defined(__AVX2__)
    return Lanes(_mm256_floor_ps(x.v));
#elif defined(__SSE4_1__)
    return Lanes(_mm_floor_ps(x.v));
#else
    const Vec whole = nearest(x);
    return whole - Vec(Lanes(whole.v > x.v ? Vec(1.0f).v : Vec(0.0f).v));
#endif
}

#define uint Uint
#define formula OCEAN_INLINE
#include "land/gullies.glsl"
#undef formula
#undef uint

}  // namespace land

using DoubleLanes = double __attribute__((vector_size(8 * kLanes)));
using LongLanes = std::int64_t __attribute__((vector_size(8 * kLanes)));

struct LatticeLanes {
    land::Uint index;
    Vec offset;
};

/// Returns the lattice point next to each of kLanes places along one axis.
OCEAN_INLINE LatticeLanes nearest_points(const double* places, const GullyOctaveTask& octave) {
    DoubleLanes at;
    __builtin_memcpy(&at, places, sizeof(at));
    at = at * octave.points_per_metre;
    DoubleLanes whole = (at + kRoundDouble) - kRoundDouble;
    const Vec offset(__builtin_convertvector(at - whole, Lanes));
    if (octave.count > 0.0) {
        const DoubleLanes periods =
            (whole * octave.periods_per_point + kRoundDouble) - kRoundDouble;
        whole = whole - periods * octave.count;
        whole = whole < 0.0 ? whole + octave.count : whole;
    }
    const LongLanes bits = reinterpret_cast<LongLanes>(whole + kRoundDouble);
    return {land::Uint(__builtin_convertvector(bits, land::Uint::UintLanes)), offset};
}

/// Adds gullies to kLanes points.
OCEAN_INLINE void add_gullies(const GullyTask& task, const GullyArrays& points, std::size_t first) {
    const Vec base_x = load_unaligned(points.slope_x + first);
    const Vec base_y = load_unaligned(points.slope_y + first);
    const land::GullyRule rule = {task.flat_square, task.roundness, task.mean,
                                  task.short_mean,  task.profile,   task.wear_scale};
    land::GullyState state = land::gully_begin(base_x, base_y);
    for (int o = 0; o < task.octaves; ++o) {
        const GullyOctaveTask& octave = task.octave[o];
        const LatticeLanes along_x = nearest_points(points.x + first, octave);
        const LatticeLanes along_y = nearest_points(points.y + first, octave);
        state = land::gully_octave(
            state, rule, {octave.height, octave.steepness, octave.weight, octave.key, octave.last},
            {along_x.index, along_y.index, along_x.offset, along_y.offset});
    }
    store_unaligned(points.height + first, load_unaligned(points.height + first) + state.height);
    store_unaligned(points.slope_x + first, land::gully_slope(base_x, state.slope_x));
    store_unaligned(points.slope_y + first, land::gully_slope(base_y, state.slope_y));
    const Vec one(1.0f);
    if (points.wear != nullptr) {
        store_unaligned(points.wear + first, rule.wear_scale * state.wear);
    }
    if (points.gully != nullptr) store_unaligned(points.gully + first, one - state.no_gully);
    if (points.ridge != nullptr) store_unaligned(points.ridge + first, one - state.no_ridge);
}

/// The last points, fewer than kLanes, padded with copies of the last one.
struct LastPoints {
    double place[2][kLanes];
    float value[6][kLanes];

    OCEAN_INLINE GullyArrays arrays() {
        return {kLanes,   place[0], place[1], value[0], value[1],
                value[2], value[3], value[4], value[5]};
    }
    OCEAN_INLINE void read(const GullyArrays& points, std::size_t first) {
        for (std::size_t k = 0; k < kLanes; ++k) {
            const std::size_t p = first + k < points.count ? first + k : points.count - 1;
            place[0][k] = points.x[p];
            place[1][k] = points.y[p];
            value[0][k] = points.height[p];
            value[1][k] = points.slope_x[p];
            value[2][k] = points.slope_y[p];
        }
    }
    OCEAN_INLINE void write(const GullyArrays& points, std::size_t first) const {
        float* const to[6] = {points.height, points.slope_x, points.slope_y,
                              points.wear,   points.gully,   points.ridge};
        for (int a = 0; a < 6; ++a) {
            if (to[a] == nullptr) continue;
            for (std::size_t p = first; p < points.count; ++p) to[a][p] = value[a][p - first];
        }
    }
};

static void run_gully_loop(const GullyTask& task, const GullyArrays& points) {
    LastPoints last;
    for (std::size_t first = 0; first < points.count; first += kLanes) {
        const bool whole = points.count - first >= kLanes;
        if (!whole) last.read(points, first);
        add_gullies(task, whole ? points : last.arrays(), whole ? first : 0);
        if (!whole) last.write(points, first);
    }
}

extern const GullyLoop kGullyLoop;
constexpr GullyLoop kGullyLoop = run_gully_loop;

}  // namespace ocean::OCEAN_KERNEL
