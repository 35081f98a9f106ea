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
// blocks, and equal blocks into runs. Test: Wake.EnergyGainedPerMetreIsMichells.
#pragma once

#include <vector>

#include "hulls/track_path.hpp"
#include "hulls/wake_task.hpp"

namespace ocean {

/// The time between nodes at most [s].
inline constexpr double kWakeTick = 0.5;

/// The square of a wake at one time.
struct WakePlace {
    PathVector centre;  // of the lattice, on a multiple of its step: maps move by whole samples
    PathVector middle;  // of the window, which moves smoothly
};

/// The nodes of one time, relative to it and to the centre of the square.
struct WakePast {
    WakePlace place;
    std::vector<WakeRun> runs;  // those that move
    std::vector<float> ages;    // weights by age of the nodes of each run, one run after another
    PathVector hull;            // from the centre [m]
    PathVector velocity;        // over the last run [m/s]
};

/// Returns the square at a time. It trails the hull by at most 0.26 of its side.
WakePlace wake_place(const TrackPath& path, double time, double size, double step);
/// Returns the nodes of the last `age` seconds.
WakePast wake_past(const TrackPath& path, double time, double age, double size, double step);

}  // namespace ocean
