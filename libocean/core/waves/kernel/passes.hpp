// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The two passes of each size N = A B, by the first factor A (frame_task.hpp): a table for each A,
// since the sizes that share A share code.
#pragma once

#include <cstddef>

#include "base/simd/simd.hpp"
#include "frame_task.hpp"

namespace ocean::OCEAN_KERNEL {

struct SizePasses {
    int size;
    std::size_t field_floats;   // floats per slot of pass two's scratch
    std::size_t source_floats;  // floats per source of pass one's scratch
    std::size_t tile_floats;    // and once per thread
    void (*pass_one)(const FrameTask&, int item, float* scratch);
    void (*pass_two)(const FrameTask&, int item, float* scratch);
};

extern const SizePasses kPasses16[4];  // N = 32 to 256
extern const SizePasses kPasses32[2];  // 512, 1024
extern const SizePasses kPasses64[3];  // 2048 to 8192

}  // namespace ocean::OCEAN_KERNEL
