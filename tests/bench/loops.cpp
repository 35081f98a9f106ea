// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Picks the loops that were compiled for an instruction set.
#include "machine_speed.hpp"
#include "ocean/error.hpp"
#include "rival_modes.hpp"

namespace ocean::bench {

extern const SpectralLoops spectral_loops_avx2;
extern const SpectralLoops spectral_loops_avx512;
extern const MachineLoops machine_loops_avx2;
extern const MachineLoops machine_loops_avx512;

namespace {

bool is_avx512(SimdLevel level) {
    if (level == SimdLevel::avx512 || level == SimdLevel::avx2) return level == SimdLevel::avx512;
    throw Error(ErrorKind::unsupported, "the benchmark needs AVX2 at least");
}

}  // namespace

const SpectralLoops& spectral_loops(SimdLevel level) {
    return is_avx512(level) ? spectral_loops_avx512 : spectral_loops_avx2;
}

const MachineLoops& machine_loops(SimdLevel level) {
    return is_avx512(level) ? machine_loops_avx512 : machine_loops_avx2;
}

}  // namespace ocean::bench
