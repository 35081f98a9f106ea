// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of the loops that sum a wake's amplitudes: plain data, so that the files compiled for
// one instruction set need nothing of the standard library.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/simd/simd_level.hpp"

namespace ocean {

/// Where a hull was, relative to a time [s] and to the centre of a lattice [m].
struct WakeNode {
    double since;
    double x, y;
    int pace = -1;  // equal for neighbours whose times are as far from the node before
};

/// Equal straight segments of a hull's past, one after another.
struct WakeRun {
    int first, last;  // nodes
    double seconds;   // of a segment
    double dx, dy;    // of a segment [m]

    // The same for the loops:
    float pause = 0.0f;                  // seconds
    float side_x = 0.0f, side_y = 0.0f;  // dx and dy in sides of the square
    float halves = 0.0f;                 // half the hull's length / the way of a segment
};

/// Factors of phases for n whole waves along x of the square, and for m along y. For each node:
/// cosine and sine of -k.X and, at the first node of a run, of k.e L/2 along the hull.
struct WakeTables {
    const float* columns;  // [block of m][node][four values][lane]
    const float* rows;     // [n][node][four values]
    std::size_t nodes;
};

/// The past of a hull in a square.
struct WakeRuns {
    const WakeNode* nodes;
    const WakeRun* runs;
    std::size_t run_count;
    WakeTables tables;
};

/// The waves of a block, neighbours along y, which share the choice of nodes that need no window:
/// the max lanes of an instruction set. Arrays of waves, and of nodes in a window, have a multiple
/// of as many and are aligned to 64 bytes.
inline constexpr std::size_t kWakeBlock = 16;

struct WakeBlock {
    int column, row;                         // of the tables
    float least_x, most_x, least_y, most_y;  // group velocities [m/s]
};

/// Some waves of a lattice.
struct WakeWaves {
    std::size_t count;  // a multiple of kWakeBlock
    const WakeBlock* blocks;
    const float* n;  // whole waves along x and y of the square
    const float* m;
    const float* rate_high;  // omega / 2 pi [Hz], not 0
    const float* rate_low;
    const float* group_x;  // group velocity [m/s]
    const float* group_y;
    const float* gain;  // F / L^2 without the part along the hull [m]
};

/// The nodes in the window of one time.
struct WakeWindow {
    const float* x;  // from the middle of the window [m]
    const float* y;
    const float* ago;     // [s]
    const float* weight;  // by age
};

/// Adds the waves of a past in two windows.
struct WakeSums {
    WakeWaves waves;
    WakeRuns past;
    WakeWindow windows[2];
    float size;              // side of the square [m]
    std::size_t node_count;  // of the windows, padded
    std::int32_t* choices;   // scratch for as many, aligned as arrays are
    float* re[2];            // amplitudes a [m]
    float* im[2];
};

/// Makes the waves of a frame from the sums of an earlier time and the past since then.
struct WakeFrame {
    WakeWaves waves{};
    WakeRuns past{};     // its first node is the time and the centre of the sums
    const float* re[2];  // of WakeSums
    const float* im[2];
    const float* ticks_re = nullptr;  // to be added to both windows; may be null
    const float* ticks_im = nullptr;
    float share;             // of the second window
    bool moves;              // the hull moves at the end of the last run
    float* to_re = nullptr;  // amplitude h0 of the time 0 [m]
    float* to_im = nullptr;
};

/// The loops of an instruction set. Eight and sixteen lanes give the same bits.
struct WakeLoops {
    void (*sum)(const WakeSums&);
    void (*frame)(const WakeFrame&);
};

/// Returns the loops of an instruction set that is compiled in.
WakeLoops wake_loops(SimdLevel level);

}  // namespace ocean
