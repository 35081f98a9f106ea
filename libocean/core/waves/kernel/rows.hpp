// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The rows that pass two hands to the last stage, outputs.hpp.
#pragma once

#include "base/simd/simd.hpp"
#include "frame_task.hpp"

namespace ocean::OCEAN_KERNEL {

/// Rows of an item: y, y + step and so on, each with kItemWidth neighbouring x from x on.
struct Rows {
    int x;
    int y;
    int step;
    int count;
    const float* slot[kLinearCount];  // the samples of each field, row after row
};

/// Writes rows to all outputs. It is one function for all sizes, because copies in the passes of
/// each size were half of their code.
void write_outputs(const FrameTask& task, const Rows& rows);

}  // namespace ocean::OCEAN_KERNEL
