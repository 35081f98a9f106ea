// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The kernel of one instruction set, for all sizes. Included by one file per instruction set,
// kernel_avx512.cpp and so on, which differ in their compiler flags alone.
#pragma once

#include "codelets.hpp"
#include "frame_task.hpp"
#include "outputs.hpp"
#include "pass_one.hpp"
#include "pass_two.hpp"

namespace ocean::OCEAN_KERNEL {

/// The factors of a size as a type, and work(Factors) for the one of `size`.
template <int kA, int kB>
struct Factors {
    static constexpr int A = kA;
    static constexpr int B = kB;
};
template <typename Work>
OCEAN_INLINE void with_factors(int size, const Work& work) {
    switch (size) {
        case 32:
            return work(Factors<16, 2>{});
        case 64:
            return work(Factors<16, 4>{});
        case 128:
            return work(Factors<16, 8>{});
        case 256:
            return work(Factors<16, 16>{});
        case 512:
            return work(Factors<32, 16>{});
        case 1024:
            return work(Factors<32, 32>{});
        case 2048:
            return work(Factors<64, 32>{});
        case 4096:
            return work(Factors<64, 64>{});
        case 8192:
            return work(Factors<64, 128>{});
        default:
            break;
    }
}

static std::size_t field_floats(int size) {
    std::size_t floats = 0;
    with_factors(size, [&](auto factors) {
        constexpr int A = decltype(factors)::A;
        constexpr int B = decltype(factors)::B;
        floats = kPairs * B * Sweep<A, B>::kLine + CombinedOutputs<A, B>::kSlotFloats;
    });
    return floats;
}

static std::size_t scratch_floats(const FrameTask& task) {
    std::size_t floats = 0;
    with_factors(task.size, [&](auto factors) {
        constexpr int A = decltype(factors)::A;
        constexpr int B = decltype(factors)::B;
        using Line = Sweep<A, B>;
        const auto sources = static_cast<std::size_t>(task.source_count);
        const std::size_t one = sources * B * Line::kLine + B * kTileStride;
        const std::size_t two = static_cast<std::size_t>(task.slots) * field_floats(task.size);
        floats = one > two ? one : two;
    });
    return floats;
}

static bool needs_rates(const FrameTask& task) {
    bool rates = false;
    for (int s = 0; s < task.source_count; ++s) rates = rates || task.source[s].rate;
    return rates;
}

static void run_pass_one(const FrameTask& task, int item, float* scratch) {
    const bool rates = needs_rates(task);
    with_factors(task.size, [&](auto factors) {
        constexpr int A = decltype(factors)::A;
        constexpr int B = decltype(factors)::B;
        if (rates) {
            pass_one<A, B, true>(task, item, scratch);
        } else {
            pass_one<A, B, false>(task, item, scratch);
        }
    });
}

static void run_pass_two(const FrameTask& task, int item, float* scratch) {
    with_factors(task.size, [&](auto factors) {
        pass_two<decltype(factors)::A, decltype(factors)::B>(task, item, scratch);
    });
}

/// Writes one row from planes.
static void run_write_row(const FrameTask& task, const PlanarFields& fields, int row) {
    alignas(64) float derived[kChannelCount * kItemWidth];
    RowSamples samples = row_samples(task, derived);
    for (int x = 0; x < task.size; x += kItemWidth) {
        for (int f = 0; f < kLinearCount; ++f) {
            if (task.slot_of[f] < 0) continue;
            samples.slot[task.slot_of[f]] = fields.plane[static_cast<std::size_t>(f)] +
                                            static_cast<std::size_t>(row) * fields.row_stride + x;
        }
        write_outputs(task, samples, x, row);
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
