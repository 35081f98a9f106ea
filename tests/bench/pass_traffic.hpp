// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bytes that the two passes of a frame must read and write.
#pragma once

#include "waves/kernel/frame_task.hpp"

namespace ocean::bench {

struct PassTraffic {
    double one;
    double two;
};

/// Returns the bytes of a frame of N x N samples. Modes: the packets of the half plane. Between the
/// passes each source is half a spectrum of complex numbers.
/// sources: of the fields that are not made of another
/// floats: of all outputs, of a sample
inline PassTraffic pass_traffic(int n, int sources, int floats) {
    const double half = 0.5 * n * n;
    const double modes = half * sizeof(float) * kPairNumbers / 2;
    const double between = half * 2 * sizeof(float) * sources;
    return {modes + between, between + 2.0 * half * sizeof(float) * floats};
}

}  // namespace ocean::bench
