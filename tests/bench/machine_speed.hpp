// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The speeds of memory and multipliers of this machine.
#pragma once

#include <cstddef>

#include "base/simd/simd_level.hpp"

namespace ocean::bench {

struct MachineLoops {
    void (*copy)(const float* from, float* to, std::size_t count);  // by non-temporal stores
    void (*fill)(float* to, std::size_t count);                     // the same
    float (*sum)(const float* from, std::size_t count);
    float (*fma)(std::size_t count);
    double fma_flops;  // of one count
};
const MachineLoops& machine_loops(SimdLevel level);

/// Bytes per second, of which a copy reads one half and writes the other; operations per second.
struct MachineSpeed {
    double copy = 0.0;
    double write = 0.0;
    double read = 0.0;
    double fma = 0.0;
};
/// The best of some rounds without other work, in arrays far larger than the caches.
MachineSpeed measure_machine(SimdLevel level, int threads);

}  // namespace ocean::bench
