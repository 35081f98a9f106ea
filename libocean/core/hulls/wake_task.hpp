// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of the loop that sums a wake's amplitudes: plain data, so that the files compiled for
// one instruction set need nothing of the standard library.
#pragma once

#include <cstddef>

#include "base/simd/simd_level.hpp"

namespace ocean {

/// Equal straight segments of a hull's past, one after another.
struct WakeRun {
    double since;         // time of the first node, less the present [s]; <= 0
    double x, y;          // of the first node, from the centre of the lattice [m]
    float from_middle_x;  // of the first node, from the middle of the window [m]
    float from_middle_y;
    double seconds;  // of a segment
    double dx, dy;   // of a segment [m]
    int segments;
    std::size_t ages;  // index of the first node's weight by age
};

/// The waves of a block, which skips the nodes whose packets have left the square: the max lanes of
/// an instruction set. Arrays of waves have a multiple of as many.
inline constexpr std::size_t kWakeBlock = 16;

/// The group velocities of the waves of a block lie within these [m/s].
struct GroupVelocities {
    float least_x, most_x, least_y, most_y;
};

/// Some waves of a lattice, and the runs that feed them. Arrays of waves are aligned to 64 bytes.
struct WakeTask {
    std::size_t count;                  // of waves, a multiple of kWakeBlock
    const GroupVelocities* velocities;  // of each block
    const float* n;                     // whole waves along x and y of the square
    const float* m;
    const float* rate_high;  // omega / 2 pi [Hz]
    const float* rate_low;
    const float* group_x;  // group velocity [m/s]
    const float* group_y;
    const float* gain;  // F / L^2 without the part along the hull [m]
    const WakeRun* runs;
    std::size_t run_count;
    const float* ages;
    double size;                    // side of the square [m]
    double half_length;             // of the hull [m]
    double hull_x, hull_y;          // the hull now, from the centre [m]
    double velocity_x, velocity_y;  // [m/s]
    float* re;                      // amplitude a [m]
    float* im;
    float* rate_re;  // da/dt [m/s]; nullptr: not requested
    float* rate_im;
};

using WakeLoop = void (*)(const WakeTask&);

/// Returns the loop of an instruction set that is compiled in. Eight and sixteen lanes give the
/// same bits.
WakeLoop wake_loop(SimdLevel level);

}  // namespace ocean
