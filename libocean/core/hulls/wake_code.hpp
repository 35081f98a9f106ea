// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sum of a wake's amplitudes over the runs of a hull's past; see wake_nodes.hpp for the
// formula. Within a segment the phase is linear, e^(i (p + b u)) with u = 0 .. 1, and the window is
// linear from w0 to w1:
//     Int (w0 + (w1 - w0) u) e^(i (p + b u)) du = e^(ip) (w0 (Z0 - Z1) + w1 Z1)
//     Z0 = Int e^(ibu) du,   Z1 = Int u e^(ibu) du
// A run has one b: its sum needs a window and a rotation for each node. The build compiles it once
// for each instruction set (core/CMakeLists.txt).
#pragma once

#include "base/simd/simd.hpp"
#include "hulls/wake_task.hpp"

namespace ocean::OCEAN_KERNEL {

constexpr float kWakeTwoPi = 6.28318530718f;
constexpr float kWindowBegin = 0.30f;  // shares of the square's side, from its middle
constexpr float kWindowEnd = 0.46f;

OCEAN_INLINE Vec select(IntLanes where, Vec a, Vec b) {
    return Vec(Lanes(where ? a.v : b.v));
}
OCEAN_INLINE Vec magnitude(Vec x) {
    return max(x, -x);
}
OCEAN_INLINE Complex times(Complex a, Complex b) {
    return {fms(a.re, b.re, a.im * b.im), fma(a.re, b.im, a.im * b.re)};
}

/// Returns 1 up to kWindowBegin and 0 from kWindowEnd on, with two continuous derivatives.
OCEAN_INLINE Vec window(Vec share) {
    const Vec per_width(1.0f / (kWindowEnd - kWindowBegin));
    Vec r = (magnitude(share) - Vec(kWindowBegin)) * per_width;
    r = min(max(r, Vec(0.0f)), Vec(1.0f));
    const Vec inner = fma(r, fms(r, Vec(6.0f), Vec(15.0f)), Vec(10.0f));
    return fnma(r * r * r, inner, Vec(1.0f));
}

/// Returns 3 (sin u - u cos u) / u^3, the share of the volume of a parabolic water line that a wave
/// sees along the hull, at u = 2 pi turns.
OCEAN_INLINE Vec along_hull(Vec turns) {
    const Vec u = turns * Vec(kWakeTwoPi);
    const Vec u2 = u * u;
    Vec series = fma(u2, Vec(-1.0f / 15120.0f), Vec(1.0f / 280.0f));
    series = fma(series, u2, Vec(-0.1f));
    series = fma(series, u2, Vec(1.0f));
    const IntLanes small = u2.v < Vec(0.25f).v;
    const SinCosLanes wave = sin_cos(turns);
    const Vec divisor = select(small, Vec(1.0f), u2 * u);
    const Vec far = Vec(3.0f) * fnma(u, wave.cosine, wave.sine) / divisor;
    return select(small, series, far);
}

/// Z0 and Z1 of a phase b = 2 pi turns, and e^(ib).
struct SegmentIntegrals {
    Complex turn;
    Complex zero;
    Complex one;
};
OCEAN_INLINE SegmentIntegrals segment_integrals(Vec turns) {
    const SinCosLanes wave = sin_cos(turns - nearest(turns));
    const Vec b = turns * Vec(kWakeTwoPi);
    const Vec b2 = b * b;
    const IntLanes small = b2.v < Vec(0.25f).v;
    const Vec divisor = select(small, Vec(1.0f), b);
    const Vec inverse = Vec(1.0f) / divisor;
    SegmentIntegrals z;
    z.turn = {wave.cosine, wave.sine};
    const Complex zero{wave.sine * inverse, (Vec(1.0f) - wave.cosine) * inverse};
    const Complex one{(wave.sine - zero.im) * inverse, (zero.re - wave.cosine) * inverse};
    // The series of both for small phases, to b^7.
    Vec zero_re = fma(b2, Vec(-1.0f / 5040.0f), Vec(1.0f / 120.0f));
    zero_re = fma(fma(zero_re, b2, Vec(-1.0f / 6.0f)), b2, Vec(1.0f));
    Vec zero_im = fma(b2, Vec(-1.0f / 40320.0f), Vec(1.0f / 720.0f));
    zero_im = fma(fma(zero_im, b2, Vec(-1.0f / 24.0f)), b2, Vec(0.5f)) * b;
    Vec one_re = fma(b2, Vec(-1.0f / 5760.0f), Vec(1.0f / 144.0f));
    one_re = fma(fma(one_re, b2, Vec(-1.0f / 8.0f)), b2, Vec(0.5f));
    Vec one_im = fma(b2, Vec(-1.0f / 45360.0f), Vec(1.0f / 840.0f));
    one_im = fma(fma(one_im, b2, Vec(-1.0f / 30.0f)), b2, Vec(1.0f / 3.0f)) * b;
    z.zero = {select(small, zero_re, zero.re), select(small, zero_im, zero.im)};
    z.one = {select(small, one_re, one.re), select(small, one_im, one.im)};
    return z;
}

/// The waves of one group of lanes.
struct WakeWaves {
    Vec n, m, rate_high, rate_low, group_x, group_y, gain;

    /// Returns turns of k.(x, y), in parts of the square, without whole turns.
    OCEAN_INLINE Vec turns_at(const PhaseClock& x, const PhaseClock& y) const {
        const Vec none(0.0f);
        return x.turns(n, none) + y.turns(m, none);
    }
};

/// Nodes of a run; none if last < first.
struct NodeRange {
    int first, last;

    /// Keeps the nodes j with a + b j < limit. Rounding keeps a node more, whose weight is 0.
    OCEAN_INLINE void keep_below(float a, float b, float limit) {
        const float room = limit - a;
        const auto whole = [](float j) OCEAN_INLINE_LAMBDA {
            return j < -1.0f ? -1 : j > 1e6f ? 1000000 : static_cast<int>(j);
        };
        if (b > 0.0f) {
            const int end = whole(room / b + 1.0f);
            last = end < last ? end : last;
        } else if (b < 0.0f) {
            const int begin = whole(room / b);
            first = begin > first ? begin : first;
        } else if (room < 0.0f) {
            last = -1;
        }
    }
};

/// Returns the nodes at which a packet of the block may be within the window: places are linear in
/// the node's number.
OCEAN_INLINE NodeRange nodes_within(const WakeTask& task, const WakeRun& run,
                                    const GroupVelocities& group) {
    const float limit = kWindowEnd * static_cast<float>(task.size);
    const auto ago = static_cast<float>(-run.since), step = static_cast<float>(run.seconds);
    const auto dx = static_cast<float>(run.dx), dy = static_cast<float>(run.dy);
    NodeRange nodes{0, run.segments};
    nodes.keep_below(run.from_middle_x + group.least_x * ago, dx - group.least_x * step, limit);
    nodes.keep_below(-run.from_middle_x - group.most_x * ago, -dx + group.most_x * step, limit);
    nodes.keep_below(run.from_middle_y + group.least_y * ago, dy - group.least_y * step, limit);
    nodes.keep_below(-run.from_middle_y - group.most_y * ago, -dy + group.most_y * step, limit);
    return nodes;
}

/// Returns the sum of a run, times -i (k.v) F W.
OCEAN_INLINE Complex add_run(const WakeTask& task, const WakeRun& run, const NodeRange& nodes,
                             const WakeWaves& waves, Complex sum) {
    const double per_side = 1.0 / task.size;
    const Vec seconds(run.seconds), step_x(run.dx * per_side), step_y(run.dy * per_side);
    const Vec along = fma(waves.n, step_x, waves.m * step_y);  // turns of k.step
    const SegmentIntegrals z = segment_integrals(fms(waves.rate_high, seconds, along));
    const double passed = nodes.first;
    const Vec phase =
        PhaseClock(run.since + passed * run.seconds).turns(waves.rate_high, waves.rate_low) -
        waves.turns_at(PhaseClock((run.x + passed * run.dx) * per_side),
                       PhaseClock((run.y + passed * run.dy) * per_side));
    const SinCosLanes begin = sin_cos(phase);
    Complex turn{begin.cosine, begin.sine};
    const auto side = static_cast<float>(per_side);
    const auto first = static_cast<float>(-run.since);
    const auto step = static_cast<float>(run.seconds);
    const auto dx = static_cast<float>(run.dx), dy = static_cast<float>(run.dy);
    // Sums of w e^(ip) over the segments' first nodes, and over their last.
    Complex firsts{Vec(0.0f), Vec(0.0f)}, lasts{Vec(0.0f), Vec(0.0f)};
    Complex term{Vec(0.0f), Vec(0.0f)};
    for (int j = nodes.first; j <= nodes.last; ++j) {
        const auto at = static_cast<float>(j);
        const Vec ago(first - at * step);
        const Vec x = fma(waves.group_x, ago, Vec(run.from_middle_x + at * dx)) * Vec(side);
        const Vec y = fma(waves.group_y, ago, Vec(run.from_middle_y + at * dy)) * Vec(side);
        const Vec weight =
            window(x) * window(y) * Vec(task.ages[run.ages + static_cast<std::size_t>(j)]);
        term = {weight * turn.re, weight * turn.im};
        if (j < run.segments) firsts = firsts + term;
        if (j > 0) lasts = lasts + term;
        turn = times(turn, z.turn);
    }
    const Complex backwards{z.turn.re, -z.turn.im};
    const Complex integral = times(z.zero - z.one, firsts) + times(times(z.one, backwards), lasts);
    // k.v times the seconds of a segment is the phase of its way.
    const auto way = static_cast<float>(__builtin_sqrt(run.dx * run.dx + run.dy * run.dy));
    const Vec hull_turns = along * Vec(static_cast<float>(task.half_length) / way);
    const Vec force = along * Vec(kWakeTwoPi) * along_hull(hull_turns);
    return {fma(force, integral.im, sum.re), fnma(force, integral.re, sum.im)};
}

/// Returns da/dt: the waves go on, and the hull feeds them.
OCEAN_INLINE Complex wake_rate(const WakeTask& task, const WakeWaves& waves, Complex amplitude) {
    const Vec omega = waves.rate_high * Vec(kWakeTwoPi);
    Complex rate{omega * amplitude.im, -(omega * amplitude.re)};
    const double speed =
        __builtin_sqrt(task.velocity_x * task.velocity_x + task.velocity_y * task.velocity_y);
    if (!(speed > 0.0)) return rate;
    const double per_side = 1.0 / task.size;
    const Vec along =
        fma(waves.n, Vec(task.velocity_x * per_side), waves.m * Vec(task.velocity_y * per_side));
    const SinCosLanes place = sin_cos(
        waves.turns_at(PhaseClock(task.hull_x * per_side), PhaseClock(task.hull_y * per_side)));
    const Vec force =
        along * Vec(kWakeTwoPi) * along_hull(along * Vec(task.half_length / speed)) * waves.gain;
    // -i f e^(-i phase) = -f sin(phase) - i f cos(phase)
    rate.re = fnma(force, place.sine, rate.re);
    rate.im = fnma(force, place.cosine, rate.im);
    return rate;
}

static void run_wake_loop(const WakeTask& task) {
    for (std::size_t i = 0; i < task.count; i += kLanes) {
        const WakeWaves waves{load(task.n + i),         load(task.m + i),
                              load(task.rate_high + i), load(task.rate_low + i),
                              load(task.group_x + i),   load(task.group_y + i),
                              load(task.gain + i)};
        Complex sum{Vec(0.0f), Vec(0.0f)};
        for (std::size_t r = 0; r < task.run_count; ++r) {
            const NodeRange nodes =
                nodes_within(task, task.runs[r], task.velocities[i / kWakeBlock]);
            if (nodes.first <= nodes.last) sum = add_run(task, task.runs[r], nodes, waves, sum);
        }
        const Complex amplitude{sum.re * waves.gain, sum.im * waves.gain};
        store(task.re + i, amplitude.re);
        store(task.im + i, amplitude.im);
        if (task.rate_re == nullptr) continue;
        const Complex rate = wake_rate(task, waves, amplitude);
        store(task.rate_re + i, rate.re);
        store(task.rate_im + i, rate.im);
    }
}

extern const WakeLoop kWakeLoop;
constexpr WakeLoop kWakeLoop = run_wake_loop;

}  // namespace ocean::OCEAN_KERNEL
