// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The passes of one size as a row of the table of passes.hpp. Included by the files of the tables,
// passes_16_code.hpp and so on, which the build compiles for each instruction set.
#pragma once

#include "frame_task.hpp"
#include "layout.hpp"
#include "pass_one.hpp"
#include "pass_two.hpp"
#include "passes.hpp"

namespace ocean::OCEAN_KERNEL {

template <int A, int B>
void pass_one_of(const FrameTask& task, int item, float* scratch) {
    bool rates = false;
    for (int s = 0; s < task.source_count; ++s) rates = rates || task.source[s].rate;
    if (rates) {
        pass_one<A, B, true>(task, item, scratch);
    } else {
        pass_one<A, B, false>(task, item, scratch);
    }
}

template <int A, int B>
constexpr SizePasses passes_of_size() {
    constexpr std::size_t kSource = B * Sweep<A>::kLine;
    return {A * B,
            kPairs * kSource + CombinedOutputs<A, B>::kSlotFloats,
            kSource,
            B * kTileStride,
            pass_one_of<A, B>,
            pass_two<A, B>};
}

}  // namespace ocean::OCEAN_KERNEL
