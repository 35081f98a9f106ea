// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sum of a wake's amplitudes over the runs of a hull's past; see wake_nodes.hpp for the
// formula. A phase is a product of turns: omega (s - t) by rotation from tick to tick, k.X by
// tables along x and y. Within a segment the phase is linear, e^(i (p + b u)) with u = 0 .. 1, and
// the window is linear from w0 to w1:
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
constexpr float kSmall = 0.25f;  // square of a phase, below which series stand for closed forms
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

/// The phases of a past's nodes for one group of lanes. It keeps the last one.
class NodeTurns {
  public:
    OCEAN_INLINE NodeTurns(const WakeRuns& past, const WakeWaves& waves, std::size_t i)
        : nodes_(past.nodes), high_(load(waves.rate_high + i)), low_(load(waves.rate_low + i)) {
        const WakeBlock& block = waves.blocks[i / kWakeBlock];
        column_ = past.tables.columns + i % kWakeBlock +
                  static_cast<std::size_t>(block.column) * past.tables.nodes * 4 * kWakeBlock;
        row_ = past.tables.rows + static_cast<std::size_t>(block.row) * past.tables.nodes * 4;
    }

    /// Returns e^(ip) at a node: omega (s - t) - k.X.
    OCEAN_INLINE Complex at(int node) {
        if (node == node_) return turn_;
        const WakeNode& wanted = nodes_[node];
        constexpr int kAnchor = 16;  // rounding errors of a rotation add up
        if (wanted.since == 0.0) {
            clock_ = {Vec(1.0f), Vec(0.0f)};
        } else if (node_ >= 0 && wanted.since == nodes_[node_].since) {
            // The clock stands.
        } else if (node == node_ + 1 && node % kAnchor != 0) {
            if (pace_ != wanted.pace) {
                pace_ = wanted.pace;
                step_ = clock_at(wanted.since - nodes_[node - 1].since);
            }
            clock_ = times(clock_, step_);
        } else {
            clock_ = clock_at(wanted.since);
        }
        node_ = node;
        turn_ = times(clock_, factor(node, 0));
        return turn_;
    }
    /// Returns e^(iu) at the first node of a run: u = k.e L/2 along the hull.
    OCEAN_INLINE Complex hull(int node) const { return factor(node, 2); }

  private:
    OCEAN_INLINE Complex clock_at(double since) const {
        const SinCosLanes wave = sin_cos(PhaseClock(since).turns(high_, low_));
        return {wave.cosine, wave.sine};
    }
    OCEAN_INLINE Complex factor(int node, std::size_t part) const {
        const auto at = static_cast<std::size_t>(node) * 4 + part;
        const Complex column{load(column_ + at * kWakeBlock),
                             load(column_ + (at + 1) * kWakeBlock)};
        return turned(column, row_[at], row_[at + 1]);
    }

    const WakeNode* nodes_;
    Vec high_, low_;
    const float* column_;
    const float* row_;
    int node_ = -2;
    int pace_ = -2;
    Complex turn_{Vec(0.0f), Vec(0.0f)}, clock_{Vec(0.0f), Vec(0.0f)};
    Complex step_{Vec(0.0f), Vec(0.0f)};
};

/// The phases of a run's segments, and the force of its hull.
struct RunLanes {
    Vec b;        // phase of a segment
    Vec inverse;  // 1 / b, or 1 where b is small
    IntLanes small;
    /// (k.v) F / F(0) times the seconds of a segment: k.v times them is the phase of its way. F is
    /// 3 (sin u - u cos u) / u^3, the share of the volume of a parabolic water line.
    Vec force;

    OCEAN_INLINE RunLanes(const WakeRun& run, const WaveLanes& waves, Complex hull) {
        const Vec along = fma(waves.n, Vec(run.side_x), waves.m * Vec(run.side_y));
        b = fms(waves.rate_high, Vec(run.pause), along) * Vec(kWakeTwoPi);
        small = (b * b).v < Vec(kSmall).v;
        const Vec phase = along * Vec(kWakeTwoPi);
        const Vec u = phase * Vec(run.halves);
        const Vec u2 = u * u;
        const IntLanes short_hull = u2.v < Vec(kSmall).v;
        Vec series = fma(u2, Vec(-1.0f / 15120.0f), Vec(1.0f / 280.0f));
        series = fma(series, u2, Vec(-0.1f));
        series = fma(series, u2, Vec(1.0f));
        const Vec cubes = select(short_hull, Vec(1.0f), u2 * u);
        const Vec segments = select(small, Vec(1.0f), b);
        const Vec both = Vec(1.0f) / (cubes * segments);
        inverse = both * cubes;
        const Vec far = Vec(3.0f) * fnma(u, hull.re, hull.im);
        force = phase * select(short_hull, series, far) * (both * segments);
    }
};

/// Returns Int_0^n e^(i (p + b u)) du from begin = e^(ip) and end = e^(i (p + nb)).
OCEAN_INLINE Complex flat_integral(const RunLanes& run, float n, Complex begin, Complex end) {
    const Vec phase = run.b * Vec(n);
    const Vec phase2 = phase * phase;
    const IntLanes small = phase2.v < Vec(kSmall).v;
    const Vec inverse = n == 1.0f ? run.inverse : Vec(1.0f) / select(small, Vec(1.0f), run.b);
    const Complex far{(end.im - begin.im) * inverse, (begin.re - end.re) * inverse};
    if (!any_below(phase2, Vec(kSmall))) return far;
    // n Z0 by its series to (nb)^7.
    Vec re = fma(phase2, Vec(-1.0f / 5040.0f), Vec(1.0f / 120.0f));
    re = fma(fma(re, phase2, Vec(-1.0f / 6.0f)), phase2, Vec(1.0f)) * Vec(n);
    Vec im = fma(phase2, Vec(-1.0f / 40320.0f), Vec(1.0f / 720.0f));
    im = fma(fma(im, phase2, Vec(-1.0f / 24.0f)), phase2, Vec(0.5f)) * (phase * Vec(n));
    const Complex near = times({re, im}, begin);
    return {select(small, near.re, far.re), select(small, near.im, far.im)};
}

/// Z0 and Z1 of a phase b, and e^(-ib).
struct SegmentIntegrals {
    Complex zero, one, back;

    SegmentIntegrals() = default;
    /// turn: e^(ib).
    OCEAN_INLINE SegmentIntegrals(const RunLanes& run, Complex turn) : back{turn.re, -turn.im} {
        const Vec b = run.b, b2 = b * b;
        const Complex far{turn.im * run.inverse, (Vec(1.0f) - turn.re) * run.inverse};
        const Complex first{(turn.im - far.im) * run.inverse, (far.re - turn.re) * run.inverse};
        zero = far;
        one = first;
        if (!any_below(b2, Vec(kSmall))) return;
        // The series of both for small phases, to b^7.
        Vec zero_re = fma(b2, Vec(-1.0f / 5040.0f), Vec(1.0f / 120.0f));
        zero_re = fma(fma(zero_re, b2, Vec(-1.0f / 6.0f)), b2, Vec(1.0f));
        Vec zero_im = fma(b2, Vec(-1.0f / 40320.0f), Vec(1.0f / 720.0f));
        zero_im = fma(fma(zero_im, b2, Vec(-1.0f / 24.0f)), b2, Vec(0.5f)) * b;
        Vec one_re = fma(b2, Vec(-1.0f / 5760.0f), Vec(1.0f / 144.0f));
        one_re = fma(fma(one_re, b2, Vec(-1.0f / 8.0f)), b2, Vec(0.5f));
        Vec one_im = fma(b2, Vec(-1.0f / 45360.0f), Vec(1.0f / 840.0f));
        one_im = fma(fma(one_im, b2, Vec(-1.0f / 30.0f)), b2, Vec(1.0f / 3.0f)) * b;
        zero = {select(run.small, zero_re, far.re), select(run.small, zero_im, far.im)};
        one = {select(run.small, one_re, first.re), select(run.small, one_im, first.im)};
    }
};

// Bits of a node for all waves of a block. Window w is 0: kOut << w; it depends on x: kAlongX << w,
// on y: kAlongY << w. kOld: a weight by age is not 1. No bit: both windows are 1.
constexpr std::int32_t kOut = 1, kBothOut = 3, kAlongX = 4, kAlongY = 16, kOld = 64;

/// Writes the choices of the nodes of a block of waves.
OCEAN_INLINE void choose_nodes(const WakeSums& task, const WakeBlock& group) {
    const Vec begin(kWindowBegin * task.size), end(kWindowEnd * task.size);
    for (std::size_t j = 0; j < task.node_count; j += kLanes) {
        IntLanes bits{};
        for (int w = 0; w < 2; ++w) {
            const WakeWindow& window = task.windows[w];
            const Vec ago = load(window.ago + j), weight = load(window.weight + j);
            const Vec x = load(window.x + j), y = load(window.y + j);
            const Vec west = fma(ago, Vec(group.least_x), x), east = fma(ago, Vec(group.most_x), x);
            const Vec south = fma(ago, Vec(group.least_y), y);
            const Vec north = fma(ago, Vec(group.most_y), y);
            const Vec nearest_off = max(max(west, -east), max(south, -north));
            const IntLanes out = (nearest_off.v > end.v) | (weight.v == Vec(0.0f).v);
            bits |= out & (kOut << w);
            bits |= (max(-west, east).v > begin.v) & (kAlongX << w);
            bits |= (max(-south, north).v > begin.v) & (kAlongY << w);
            bits |= (weight.v < Vec(1.0f).v) & kOld;
        }
        *reinterpret_cast<IntLanes*>(task.choices + j) = bits;
    }
}

/// Adds -i force integral.
OCEAN_INLINE void add_forced(Vec force, Complex integral, Complex& sum) {
    sum = {fma(force, integral.im, sum.re), fnma(force, integral.re, sum.im)};
}

/// Returns the weight of a node in window w.
OCEAN_INLINE Vec weight_of(const WakeSums& task, int w, int node, const WaveLanes& waves) {
    const std::int32_t bits = task.choices[node];
    if ((bits & kOut << w) != 0) return Vec(0.0f);
    const WakeWindow& window = task.windows[w];
    const Vec ago(window.ago[node]), per_side(1.0f / task.size);
    Vec weight(window.weight[node]);
    if ((bits & kAlongX << w) != 0) {
        weight = weight * window_of(fma(waves.group_x, ago, Vec(window.x[node])) * per_side);
    }
    if ((bits & kAlongY << w) != 0) {
        weight = weight * window_of(fma(waves.group_y, ago, Vec(window.y[node])) * per_side);
    }
    return weight;
}

/// The weights of the last node, which the next run begins with.
struct NodeWeights {
    int node = -1;
    Vec of[2] = {Vec(0.0f), Vec(0.0f)};

    OCEAN_INLINE void move_to(int wanted, const WakeSums& task, const WaveLanes& waves) {
        if (node == wanted) return;
        node = wanted;
        for (int w = 0; w < 2; ++w) of[w] = weight_of(task, w, node, waves);
    }
};

/// Adds a run to the sums of both windows.
OCEAN_INLINE void add_run(const WakeSums& task, const WakeRun& run, const WaveLanes& waves,
                          NodeTurns& turns, NodeWeights& weights, Complex (&sums)[2]) {
    const std::int32_t* const choices = task.choices;
    const auto is_out = [choices](int j) OCEAN_INLINE_LAMBDA {
        return (choices[j] & choices[j + 1] & kBothOut) == kBothOut;
    };
    const auto is_in = [choices](int j)
                           OCEAN_INLINE_LAMBDA { return (choices[j] | choices[j + 1]) == 0; };
    int j = run.first;
    while (j < run.last && is_out(j)) ++j;
    if (j == run.last) return;
    const RunLanes lanes(run, waves, turns.hull(run.first));
    const Complex none{Vec(0.0f), Vec(0.0f)};
    Complex flat = none;
    // Sums of w e^(ip) over the segments' first nodes, and over their last.
    Complex firsts[2] = {none, none}, lasts[2] = {none, none};
    SegmentIntegrals z;
    bool is_flat = true;
    while (j < run.last) {
        if (is_out(j)) {
            ++j;
            continue;
        }
        Complex turn = turns.at(j);
        if (is_in(j)) {
            int end = j + 1;
            while (end < run.last && choices[end + 1] == 0) ++end;
            flat = flat + flat_integral(lanes, static_cast<float>(end - j), turn, turns.at(end));
            j = end;
        } else {
            do {
                const Complex next = turns.at(j + 1);
                if (is_flat) z = {lanes, times(next, {turn.re, -turn.im})};
                is_flat = false;
                weights.move_to(j, task, waves);
                for (int w = 0; w < 2; ++w) {
                    const Vec weight = weights.of[w];
                    firsts[w] = firsts[w] + Complex{weight * turn.re, weight * turn.im};
                }
                weights.move_to(j + 1, task, waves);
                for (int w = 0; w < 2; ++w) {
                    const Vec weight = weights.of[w];
                    lasts[w] = lasts[w] + Complex{weight * next.re, weight * next.im};
                }
                turn = next;
                ++j;
            } while (j < run.last && !is_in(j) && !is_out(j));
        }
    }
    for (int w = 0; w < 2; ++w) {
        Complex integral = flat;
        if (!is_flat) {
            integral =
                integral + times(z.zero - z.one, firsts[w]) + times(times(z.one, z.back), lasts[w]);
        }
        add_forced(lanes.force, integral, sums[w]);
    }
}

static void run_wake_sums(const WakeSums& task) {
    for (std::size_t i = 0; i < task.waves.count; i += kLanes) {
        if (i % kWakeBlock == 0) choose_nodes(task, task.waves.blocks[i / kWakeBlock]);
        const WaveLanes waves(task.waves, i);
        NodeTurns turns(task.past, task.waves, i);
        NodeWeights weights;
        Complex sums[2] = {{Vec(0.0f), Vec(0.0f)}, {Vec(0.0f), Vec(0.0f)}};
        for (std::size_t r = 0; r < task.past.run_count; ++r) {
            add_run(task, task.past.runs[r], waves, turns, weights, sums);
        }
        for (int w = 0; w < 2; ++w) {
            float* const re = task.re[w] + i;
            float* const im = task.im[w] + i;
            store(re, fma(waves.gain, sums[w].re, load(re)));
            store(im, fma(waves.gain, sums[w].im, load(im)));
        }
    }
}

static void run_wake_frame(const WakeFrame& task) {
    for (std::size_t i = 0; i < task.waves.count; i += kLanes) {
        const WaveLanes waves(task.waves, i);
        NodeTurns turns(task.past, task.waves, i);
        const Complex first{load(task.re[0] + i), load(task.im[0] + i)};
        const Complex second{load(task.re[1] + i), load(task.im[1] + i)};
        const Vec share(task.share);
        Complex before{fma(share, second.re - first.re, first.re),
                       fma(share, second.im - first.im, first.im)};
        if (task.ticks_re != nullptr) {
            before = before + Complex{load(task.ticks_re + i), load(task.ticks_im + i)};
        }
        const Complex sum = times(before, turns.at(0));
        Complex added{Vec(0.0f), Vec(0.0f)};
        for (std::size_t r = 0; r < task.past.run_count; ++r) {
            const WakeRun& run = task.past.runs[r];
            const RunLanes lanes(run, waves, turns.hull(run.first));
            const Complex begin = turns.at(run.first), end = turns.at(run.last);
            add_forced(lanes.force,
                       flat_integral(lanes, static_cast<float>(run.last - run.first), begin, end),
                       added);
            if (!task.moves || r + 1 < task.past.run_count) continue;
            // The hull feeds the waves now: dh0/dt = -i omega h0 has it, and the height does not.
            const Vec pushed = lanes.force / (waves.rate_high * Vec(run.pause * kWakeTwoPi));
            added = {fma(pushed, end.re, added.re), fma(pushed, end.im, added.im)};
        }
        store(task.to_re + i, fma(waves.gain, added.re, sum.re));
        store(task.to_im + i, fma(waves.gain, added.im, sum.im));
    }
}

extern const WakeLoops kWakeLoops;
constexpr WakeLoops kWakeLoops = {run_wake_sums, run_wake_frame};

}  // namespace ocean::OCEAN_KERNEL
