// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of the loops that sum a wake's amplitudes: plain data, so that the files compiled for
// one instruction set need nothing of the standard library.
#pragma once

#include <cstddef>

#include "base/simd/simd_level.hpp"

namespace ocean {

/// Where a hull was, relative to a time [s] and to the centre of a lattice [m].
struct WakeNode {
    double since;  // <= 0
    double x, y;
};

/// Equal straight segments of a hull's past, one after another.
struct WakeRun {
    int first, last;  // nodes
    double seconds;   // of a segment
    double dx, dy;    // of a segment [m]
};

/// The past of a hull in a square.
struct WakeRuns {
    const WakeNode* nodes;
    const WakeRun* runs;
    std::size_t run_count;
    double size;         // side of the square [m]
    double half_length;  // of the hull [m]
};

/// The waves of a block, which shares the choice of nodes that need no window: the max lanes of an
/// instruction set. Arrays of waves, and of nodes in a window, have a multiple of as many and are
/// aligned to 64 bytes.
inline constexpr std::size_t kWakeBlock = 16;

/// The group velocities of the waves of a block lie within these [m/s].
struct GroupVelocities {
    float least_x, most_x, least_y, most_y;
};

/// Some waves of a lattice.
struct WakeWaves {
    std::size_t count;                  // a multiple of kWakeBlock
    const GroupVelocities* velocities;  // of each block
    const float* n;                     // whole waves along x and y of the square
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

/// Sums the waves of a past in two windows.
struct WakeSums {
    WakeWaves waves;
    WakeRuns past;
    WakeWindow windows[2];
    std::size_t node_count;  // of the windows, padded
    float* choices;          // scratch for as many
    float* re[2];            // amplitudes a [m]
    float* im[2];
};

/// Makes the waves of a frame from the sums of an earlier time and the past since then.
struct WakeFrame {
    WakeWaves waves;
    WakeRuns past;       // since the time of the sums
    const float* re[2];  // of WakeSums
    const float* im[2];
    float share;             // of the second window
    double since;            // the time of the sums, less the frame's [s]
    float shift_x, shift_y;  // from the centre of the sums' lattice to the frame's, in its sides
    bool moves;              // the hull moves at the end of the last run
    float* to_re;            // amplitude h0 of the time 0 [m]
    float* to_im;
};

/// The loops of an instruction set. Eight and sixteen lanes give the same bits.
struct WakeLoops {
    void (*sum)(const WakeSums&);
    void (*frame)(const WakeFrame&);
};

/// Returns the loops of an instruction set that is compiled in.
WakeLoops wake_loops(SimdLevel level);

}  // namespace ocean
