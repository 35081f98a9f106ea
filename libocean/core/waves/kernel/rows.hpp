// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The rows that pass two hands to the last stage, outputs.hpp.
#pragma once

#include "base/simd/simd.hpp"
#include "frame_task.hpp"

namespace ocean::OCEAN_KERNEL {

/// Rows of an item, those of y, y + step and so on: kItemWidth neighbouring x each, from x on.
struct Rows {
    int x;
    int y;
    int step;
    int count;
    const float* slot[kLinearCount];  // the samples of each field, one row behind the other
};

/// Writes rows to all outputs. One function for all sizes: its copies in the passes of each were
/// half of their code.
void write_outputs(const FrameTask& task, const Rows& rows);

}  // namespace ocean::OCEAN_KERNEL
