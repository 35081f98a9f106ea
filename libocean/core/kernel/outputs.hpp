// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The samples of a row, and the function that writes them: the border between pass two, which is
// compiled for each size, and the outputs, which are the same for all sizes (outputs_code.hpp).
#pragma once

#include "frame_task.hpp"
#include "layout.hpp"
#include "simd.hpp"

namespace ocean::OCEAN_KERNEL {

inline constexpr int kRowVectors = kItemWidth / kLanes;

/// Where the samples of a row are: kItemWidth neighbouring x at one y. Slots of linear fields point
/// to their samples, those of derived channels to `derived`.
struct RowSamples {
    const float* slot[kLinearCount + kChannelCount];
    float* derived;

    OCEAN_INLINE Vec at(int s, int v) const { return load_unaligned(slot[s] + v * kLanes); }
};

/// Returns the samples of a row, with the derived slots after the linear ones.
OCEAN_INLINE RowSamples row_samples(const FrameTask& task, float* derived) {
    RowSamples row;
    row.derived = derived;
    for (int s = task.slots; s < task.slots + task.derived_slots; ++s) {
        row.slot[s] = derived + (s - task.slots) * kItemWidth;
    }
    return row;
}

/// Writes a row of samples, those from (x, y) on, to all outputs.
void write_outputs(const FrameTask& task, const RowSamples& row, int x, int y);

}  // namespace ocean::OCEAN_KERNEL
