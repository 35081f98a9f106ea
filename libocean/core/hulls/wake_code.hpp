// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sum of a wake's amplitudes over the runs of a hull's past; see wake_nodes.hpp for the
// formula. Within a segment the phase is linear, e^(i (p + b u)) with u = 0 .. 1, and the window is
// linear from w0 to w1:
//     Int (w0 + (w1 - w0) u) e^(i (p + b u)) du = e^(ip) (w0 (Z0 - Z1) + w1 Z1)
//     Z0 = Int e^(ibu) du,   Z1 = Int u e^(ibu) du
// A run has one b: its sum needs a window and a rotation for each node. Where the window is 1, n
// segments are one whose phase is n b: Int_0^n e^(ibu) du = (e^(inb) - 1) / (ib). The build
// compiles it once for each instruction set (core/CMakeLists.txt).
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
OCEAN_INLINE Vec window_of(Vec share) {
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

/// Returns Int_0^n e^(i (p + b u)) du from begin = e^(ip) and end = e^(i (p + nb)), at b = 2 pi
/// turns.
OCEAN_INLINE Complex flat_integral(Vec turns, float n, Complex begin, Complex end) {
    const Vec b = turns * Vec(kWakeTwoPi);
    const Vec phase = b * Vec(n);
    const Vec phase2 = phase * phase;
    const IntLanes small = phase2.v < Vec(0.25f).v;
    const Vec inverse = Vec(1.0f) / select(small, Vec(1.0f), b);
    const Complex far{(end.im - begin.im) * inverse, (begin.re - end.re) * inverse};
    // n Z0 by its series to (nb)^7.
    Vec re = fma(phase2, Vec(-1.0f / 5040.0f), Vec(1.0f / 120.0f));
    re = fma(fma(re, phase2, Vec(-1.0f / 6.0f)), phase2, Vec(1.0f)) * Vec(n);
    Vec im = fma(phase2, Vec(-1.0f / 40320.0f), Vec(1.0f / 720.0f));
    im = fma(fma(im, phase2, Vec(-1.0f / 24.0f)), phase2, Vec(0.5f)) * (phase * Vec(n));
    const Complex near = times({re, im}, begin);
    return {select(small, near.re, far.re), select(small, near.im, far.im)};
}

/// The waves of one group of lanes.
struct WaveLanes {
    Vec n, m, rate_high, rate_low, group_x, group_y, gain;

    OCEAN_INLINE WaveLanes(const WakeWaves& waves, std::size_t i)
        : n(load(waves.n + i)),
          m(load(waves.m + i)),
          rate_high(load(waves.rate_high + i)),
          rate_low(load(waves.rate_low + i)),
          group_x(load(waves.group_x + i)),
          group_y(load(waves.group_y + i)),
          gain(load(waves.gain + i)) {}
};

/// Returns e^(ip) at a node: omega (s - t) - k.X.
OCEAN_INLINE Complex node_turn(const WakeRuns& past, int node, const WaveLanes& waves) {
    const WakeNode& at = past.nodes[node];
    const double per_side = 1.0 / past.size;
    const Vec none(0.0f);
    const Vec place = PhaseClock(at.x * per_side).turns(waves.n, none) +
                      PhaseClock(at.y * per_side).turns(waves.m, none);
    const SinCosLanes wave =
        sin_cos(PhaseClock(at.since).turns(waves.rate_high, waves.rate_low) - place);
    return {wave.cosine, wave.sine};
}

/// The phases of a run's segments.
struct RunLanes {
    Vec along;  // turns of k.step
    Vec turns;  // of b

    OCEAN_INLINE RunLanes(const WakeRuns& past, const WakeRun& run, const WaveLanes& waves) {
        const double per_side = 1.0 / past.size;
        along = fma(waves.n, Vec(run.dx * per_side), waves.m * Vec(run.dy * per_side));
        turns = fms(waves.rate_high, Vec(run.seconds), along);
    }
    /// Returns (k.v) F / F(0) times the seconds of a segment: k.v times them is the phase of its
    /// way.
    OCEAN_INLINE Vec force(const WakeRuns& past, const WakeRun& run) const {
        const auto way = static_cast<float>(__builtin_sqrt(run.dx * run.dx + run.dy * run.dy));
        const auto half_length = static_cast<float>(past.half_length);
        return along * Vec(kWakeTwoPi) * along_hull(along * Vec(half_length / way));
    }
};

// Both windows of a node are 0 for all waves of a block, both are 1, or neither.
constexpr float kOutside = 0.0f;
constexpr float kInside = 1.0f;
constexpr float kBetween = 0.5f;

/// Writes the choices of the nodes of a block of waves.
OCEAN_INLINE void choose_nodes(const WakeSums& task, const GroupVelocities& group) {
    const auto size = static_cast<float>(task.past.size);
    const Vec zero(0.0f), one(1.0f);
    for (std::size_t j = 0; j < task.node_count; j += kLanes) {
        Vec weakest = one, strongest = zero;
        for (const WakeWindow& window : task.windows) {
            const Vec ago = load(window.ago + j), weight = load(window.weight + j);
            const Vec x = load(window.x + j), y = load(window.y + j);
            const Vec west = fma(ago, Vec(group.least_x), x), east = fma(ago, Vec(group.most_x), x);
            const Vec south = fma(ago, Vec(group.least_y), y);
            const Vec north = fma(ago, Vec(group.most_y), y);
            const Vec nearest_off = max(max(west, -east), max(south, -north));
            const Vec farthest_off = max(max(-west, east), max(-south, north));
            const IntLanes out = nearest_off.v > Vec(kWindowEnd * size).v;
            const IntLanes in = farthest_off.v < Vec(kWindowBegin * size).v;
            strongest = max(strongest, select(out, zero, weight));
            weakest = min(weakest, select(in, weight, zero));
        }
        const IntLanes all = weakest.v == one.v;
        const IntLanes any = strongest.v > zero.v;
        store(task.choices + j,
              select(all, Vec(kInside), select(any, Vec(kBetween), Vec(kOutside))));
    }
}

/// The last phase that a past computed.
struct LastTurn {
    int node = -1;
    Complex turn;

    OCEAN_INLINE Complex at(int wanted, const WakeRuns& past, const WaveLanes& waves) const {
        return node == wanted ? turn : node_turn(past, wanted, waves);
    }
};

/// Returns the integral of a run's segments first .. last with the window 1.
OCEAN_INLINE Complex flat_run(const WakeRuns& past, const RunLanes& run, int first, int last,
                              const WaveLanes& waves, LastTurn& edge) {
    const Complex begin = edge.at(first, past, waves);
    edge = {last, node_turn(past, last, waves)};
    return flat_integral(run.turns, static_cast<float>(last - first), begin, edge.turn);
}

/// Adds -i force integral.
OCEAN_INLINE void add_forced(Vec force, Complex integral, Complex& sum) {
    sum = {fma(force, integral.im, sum.re), fnma(force, integral.re, sum.im)};
}

OCEAN_INLINE Vec weight_of(const WakeWindow& window, float side, int node, const WaveLanes& waves) {
    const Vec ago(window.ago[node]);
    const Vec x = fma(waves.group_x, ago, Vec(window.x[node])) * Vec(side);
    const Vec y = fma(waves.group_y, ago, Vec(window.y[node])) * Vec(side);
    return window_of(x) * window_of(y) * Vec(window.weight[node]);
}

/// Adds a run to the sums of both windows.
OCEAN_INLINE void add_run(const WakeSums& task, const WakeRun& run, const WaveLanes& waves,
                          LastTurn& edge, Complex (&sums)[2]) {
    const float* const choices = task.choices;
    const auto both = [choices](int j, float choice) OCEAN_INLINE_LAMBDA {
        return choices[j] == choice && choices[j + 1] == choice;
    };
    int j = run.first;
    while (j < run.last && both(j, kOutside)) ++j;
    if (j == run.last) return;
    const RunLanes lanes(task.past, run, waves);
    const auto side = static_cast<float>(1.0 / task.past.size);
    const Complex none{Vec(0.0f), Vec(0.0f)};
    Complex flat = none;
    // Sums of w e^(ip) over the segments' first nodes, and over their last.
    Complex firsts[2] = {none, none}, lasts[2] = {none, none};
    SegmentIntegrals z{none, none, none};
    bool is_flat = true;
    while (j < run.last) {
        if (both(j, kInside)) {
            int end = j + 1;
            while (end < run.last && choices[end + 1] == kInside) ++end;
            flat = flat + flat_run(task.past, lanes, j, end, waves, edge);
            j = end;
        } else if (both(j, kOutside)) {
            ++j;
        } else {
            if (is_flat) z = segment_integrals(lanes.turns);
            is_flat = false;
            Complex turn = edge.at(j, task.past, waves);
            Vec weights[2];
            for (int w = 0; w < 2; ++w) weights[w] = weight_of(task.windows[w], side, j, waves);
            do {
                const Complex next = times(turn, z.turn);
                for (int w = 0; w < 2; ++w) {
                    firsts[w] = firsts[w] + Complex{weights[w] * turn.re, weights[w] * turn.im};
                    weights[w] = weight_of(task.windows[w], side, j + 1, waves);
                    lasts[w] = lasts[w] + Complex{weights[w] * next.re, weights[w] * next.im};
                }
                turn = next;
                ++j;
            } while (j < run.last && !both(j, kInside) && !both(j, kOutside));
        }
    }
    const Vec force = lanes.force(task.past, run);
    const Complex backwards{z.turn.re, -z.turn.im};
    for (int w = 0; w < 2; ++w) {
        Complex integral = flat;
        if (!is_flat) {
            integral = integral + times(z.zero - z.one, firsts[w]) +
                       times(times(z.one, backwards), lasts[w]);
        }
        add_forced(force, integral, sums[w]);
    }
}

static void run_wake_sums(const WakeSums& task) {
    for (std::size_t i = 0; i < task.waves.count; i += kLanes) {
        if (i % kWakeBlock == 0) choose_nodes(task, task.waves.velocities[i / kWakeBlock]);
        const WaveLanes waves(task.waves, i);
        Complex sums[2] = {{Vec(0.0f), Vec(0.0f)}, {Vec(0.0f), Vec(0.0f)}};
        LastTurn edge;
        for (std::size_t r = 0; r < task.past.run_count; ++r) {
            add_run(task, task.past.runs[r], waves, edge, sums);
        }
        for (int w = 0; w < 2; ++w) {
            store(task.re[w] + i, sums[w].re * waves.gain);
            store(task.im[w] + i, sums[w].im * waves.gain);
        }
    }
}

static void run_wake_frame(const WakeFrame& task) {
    const PhaseClock since(task.since);
    for (std::size_t i = 0; i < task.waves.count; i += kLanes) {
        const WaveLanes waves(task.waves, i);
        const Complex first{load(task.re[0] + i), load(task.im[0] + i)};
        const Complex second{load(task.re[1] + i), load(task.im[1] + i)};
        const Vec share(task.share);
        const Complex before{fma(share, second.re - first.re, first.re),
                             fma(share, second.im - first.im, first.im)};
        const Vec shift = fma(waves.n, Vec(task.shift_x), waves.m * Vec(task.shift_y));
        const SinCosLanes wave =
            sin_cos(since.turns(waves.rate_high, waves.rate_low) + (shift - nearest(shift)));
        Complex sum = times(before, {wave.cosine, wave.sine});
        Complex added{Vec(0.0f), Vec(0.0f)};
        LastTurn edge;
        for (std::size_t r = 0; r < task.past.run_count; ++r) {
            const WakeRun& run = task.past.runs[r];
            const RunLanes lanes(task.past, run, waves);
            const Vec force = lanes.force(task.past, run);
            add_forced(force, flat_run(task.past, lanes, run.first, run.last, waves, edge), added);
            if (!task.moves || r + 1 < task.past.run_count) continue;
            // The hull feeds the waves now: dh0/dt = -i omega h0 has it, and the height does not.
            const Vec pushed =
                force / (waves.rate_high * Vec(static_cast<float>(run.seconds) * kWakeTwoPi));
            added = {fma(pushed, edge.turn.re, added.re), fma(pushed, edge.turn.im, added.im)};
        }
        store(task.to_re + i, fma(waves.gain, added.re, sum.re));
        store(task.to_im + i, fma(waves.gain, added.im, sum.im));
    }
}

extern const WakeLoops kWakeLoops;
constexpr WakeLoops kWakeLoops = {run_wake_sums, run_wake_frame};

}  // namespace ocean::OCEAN_KERNEL
