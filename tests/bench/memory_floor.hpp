// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The least time that a frame takes on this machine: its bytes at the speed of memory.
#pragma once

#include <cstddef>

#include "kernel/simd_level.hpp"
#include "subject.hpp"

namespace ocean::bench {

struct FloorLoops {
    void (*copy)(const float* from, float* to, std::size_t count);  // by non-temporal stores
    void (*fill)(float* to, std::size_t count);                     // the same
    float (*sum)(const float* from, std::size_t count);
    float (*fma)(std::size_t count);
    double fma_flops;  // of one count
};
const FloorLoops& floor_loops(SimdLevel level);

/// Bytes per second, of which a copy reads one half and writes the other; operations per second.
struct MachineSpeed {
    double copy = 0.0;
    double write = 0.0;
    double read = 0.0;
    double fma = 0.0;
};
/// The best of some rounds without other work, in arrays far larger than the caches.
MachineSpeed measure_machine(SimdLevel level, int threads);

/// What a frame must read and write. Modes: for the half plane p and q, and the phase rate in two
/// floats that k and its mirror image in ky share. Between the passes each field travels as half a
/// spectrum; derivatives along x are made behind: 4 of 5 fields, 5 of 8.
struct FrameTraffic {
    double read;
    double written;
};
FrameTraffic frame_traffic(FrameKind kind, int n);

}  // namespace ocean::bench
