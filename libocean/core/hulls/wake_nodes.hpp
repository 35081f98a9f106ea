// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The past of a hull as nodes, and where the square of its wake lies.
//
// A thin hull of half-breadth f(x, z) is a sheet of sources -2 U df/dx on its centre plane
// [Michell 1898]. Where it was at the time s, X(s) with the velocity v(s), it feeds each wave k
// with
//     a(k, t) = -i/L^2 Int (k.v) F(k, e) W(k, s) e^(i omega (s - t) - i k.X(s)) ds        [m]
//     eta^(k, t) = a(k, t) + conj a(-k, t),   F = half the hull's volume as the wave k sees it
//     [m^3]
// over the square of side L around the hull: e is the heading. So a is an h0 that already has its
// phase, and the open sea's synthesis makes the maps of it.
//
// The square is a lattice and would wrap: the packet (k, s) is now at X(s) + c_g (t - s), and W, a
// C2 step of that place, ends it before it reaches the border. W is 1 around the hull.
//
// The integral is exact for a straight run of constant speed with W linear between its nodes. Nodes
// lie on an absolute clock, so that they do not depend on t; straight stretches merge into dyadic
// blocks, and equal blocks into runs. Test: the rows hulls.michell_* of `ocean verify`.
//
// W of a frame lies between those of two times of the same clock, in proportion: the sums over the
// past before the first of them serve all frames between them, and only what follows is added anew.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hulls/track_path.hpp"
#include "hulls/wake_task.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

/// The time between nodes at most [s].
inline constexpr double kWakeTick = 0.5;

/// The square of a wake at one time.
struct WakePlace {
    PathVector centre;  // of the lattice, on a multiple of its step: maps move by whole samples
    PathVector middle;  // of the window, which moves smoothly
};
/// Returns the square at a time. It trails the hull by at most 0.26 of its side.
WakePlace wake_place(const TrackPath& path, double time, double size, double step);

/// The past since the begin of a span.
struct WakeNewest {
    int ticks;                  // whole ones of the span, and then
    std::vector<double> times;  // of nodes
};

/// Absolute times: ticks for nodes, and spans of 1, 2, 4 or 8 ticks for windows.
class WakeClock {
  public:
    /// longest: of a span [s]. A span of one tick may be longer.
    WakeClock(const TrackPath& path, double longest);

    /// Returns the span in which a time lies: begin(span) < time <= begin(span + 1).
    std::int64_t span_of(double time) const;
    double begin(std::int64_t span) const { return at(span * ticks_); }
    /// Returns the begin of a tick of a span.
    double tick_begin(std::int64_t span, int tick) const { return at(span * ticks_ + tick); }

    /// Returns the times of the nodes up to the begin of a span, from `age` before it on.
    std::vector<double> settled(const TrackPath& path, std::int64_t span, double age) const;
    /// Returns the times of the nodes of a tick of a span, or none before the track begins.
    std::vector<double> tick(const TrackPath& path, std::int64_t span, int tick) const;
    /// Returns what lies between the begin of the span of a time and that time: one segment if it
    /// is straight, else ticks and what follows them.
    WakeNewest newest(const TrackPath& path, double time) const;

    bool operator==(const WakeClock&) const = default;

  private:
    std::vector<double> nodes(const TrackPath& path, std::int64_t oldest, double time) const;
    double at(std::int64_t tick) const { return static_cast<double>(tick) * tick_; }

    double tick_ = kWakeTick;
    std::int64_t ticks_ = 1;  // of a span
};

/// The past of a hull as nodes, relative to a time and to the centre of the square at that time.
struct WakePast {
    WakePlace place;
    std::vector<WakeNode> nodes;
    std::vector<WakeRun> runs;  // those that move

    /// Inserts a node that belongs to no run.
    void insert_before(const WakeNode& node);
    /// Returns true if the hull moves at the last node.
    bool moves() const {
        return !runs.empty() && runs.back().last + 1 == static_cast<int>(nodes.size());
    }
};
WakePast wake_past(const TrackPath& path, const std::vector<double>& times, double time,
                   const WakePlace& place);

/// The nodes of a past in the window of another time.
class WindowNodes {
  public:
    /// later: from the time of the past [s]. age: of the oldest waves [s].
    WindowNodes(const WakePast& past, double later, const PathVector& middle, double age);

    /// Returns the number of nodes, padded.
    std::size_t count() const { return count_; }
    /// Returns the window from the node `first` on, a multiple of kWakeBlock.
    WakeWindow window(int first) const;

  private:
    std::size_t count_;
    PageVector<float> values_;
};

}  // namespace ocean
