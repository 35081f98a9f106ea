// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The kernel of one instruction set: the code that all sizes share, and the choice among the sizes,
// which are compiled in files of their own (passes_code.hpp). core/CMakeLists.txt makes a source
// file for each instruction set; these files include this one and differ in their compiler flags
// alone.
#pragma once

#include "codelets.hpp"
#include "frame_task.hpp"
#include "outputs.hpp"
#include "passes.hpp"

namespace ocean::OCEAN_KERNEL {

static const SizePasses& passes_of(int size) {
    for (const SizePasses& passes : kPasses16) {
        if (passes.size == size) return passes;
    }
    for (const SizePasses& passes : kPasses32) {
        if (passes.size == size) return passes;
    }
    for (const SizePasses& passes : kPasses64) {
        if (passes.size == size) return passes;
    }
    return kPasses64[0];  // no caller requests another size
}

static std::size_t field_floats(int size) {
    return passes_of(size).field_floats;
}

static std::size_t scratch_floats(const FrameTask& task) {
    const SizePasses& passes = passes_of(task.size);
    const std::size_t one =
        static_cast<std::size_t>(task.source_count) * passes.source_floats + passes.tile_floats;
    const std::size_t two = static_cast<std::size_t>(task.slots) * passes.field_floats;
    return one > two ? one : two;
}

static void run_pass_one(const FrameTask& task, int item, float* scratch) {
    passes_of(task.size).pass_one(task, item, scratch);
}

static void run_pass_two(const FrameTask& task, int item, float* scratch) {
    passes_of(task.size).pass_two(task, item, scratch);
}

/// Writes one row from planes.
static void run_write_row(const FrameTask& task, const PlanarFields& fields, int row) {
    Rows rows{0, row, 1, 1, {}};
    for (; rows.x < task.size; rows.x += kItemWidth) {
        for (int f = 0; f < kLinearCount; ++f) {
            if (task.slot_of[f] < 0) continue;
            rows.slot[task.slot_of[f]] = fields.plane[static_cast<std::size_t>(f)] +
                                         static_cast<std::size_t>(row) * fields.row_stride + rows.x;
        }
        write_outputs(task, rows);
    }
    finish_streams();
}

static void run_codelet(int points, const float* in, float* out) {
    const auto load_point = [=](int j) { return load_complex(in + j * 2 * kLanes); };
    const auto store_point = [=](int k, Complex x) { store_complex(out + k * 2 * kLanes, x); };
    switch (points) {
        case 2:
            return Codelet<2>::run(load_point, store_point);
        case 4:
            return Codelet<4>::run(load_point, store_point);
        case 8:
            return Codelet<8>::run(load_point, store_point);
        case 16:
            return Codelet<16>::run(load_point, store_point);
        case 32:
            return Codelet<32>::run(load_point, store_point);
        case 64:
            return Codelet<64>::run(load_point, store_point);
        default:
            return Codelet<128>::run(load_point, store_point);
    }
}

extern const KernelCode kCode;
constexpr KernelCode kCode = {kLanes,       kItemWidth,   scratch_floats, field_floats,
                              run_pass_one, run_pass_two, run_write_row,  run_codelet};

}  // namespace ocean::OCEAN_KERNEL
