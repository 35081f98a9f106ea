// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The last stage: from the linear fields of some samples to the channels made of several of them,
// and into the caller's buffers. The GPU compiles the same formulas.
#pragma once

#include "base/simd/simd.hpp"
#include "frame_task.hpp"
#include "rows.hpp"
#include "transpose.hpp"

namespace ocean::OCEAN_KERNEL {

namespace formula {
#define formula OCEAN_INLINE
using real = Vec;
#include "wave/foam_cover.glsl"
#include "wave/surface.glsl"
#undef formula
}  // namespace formula

inline constexpr int kRowVectors = kItemWidth / kLanes;

/// Where the samples of a row are: kItemWidth neighbouring x at one y. Slots of linear fields point
/// to their samples; the slots of derived channels after them point to `derived`.
struct RowSamples {
    const float* slot[kLinearCount + kChannelCount];
    float* derived;

    OCEAN_INLINE Vec at(int s, int v) const { return load_unaligned(slot[s] + v * kLanes); }
};

/// Prefetches the earlier foam that this row of the next item reads. Rows are far apart, and
/// nothing else asks for them in time: a tick of foam would take a third longer. [measured,
/// AVX-512]
OCEAN_INLINE void prefetch_foam(const float* row) {
    for (int i = kItemWidth; i < 2 * kItemWidth; i += kLineFloats) {
        __builtin_prefetch(row + i, 0, 2);  // to the second cache
    }
}

/// Writes normal, Jacobian, whitecap, foam and cover of a row, if requested.
template <bool kFlat>
OCEAN_INLINE void derive_channels(const FrameTask& task, const RowSamples& row, std::size_t place) {
    const auto slot_of = [&](Linear field) { return task.slot_of[static_cast<int>(field)]; };
    const auto gradient = [&](Linear field, int v) OCEAN_INLINE_LAMBDA {
        return kFlat ? Vec(0.0f) : row.at(slot_of(field), v);
    };
    const auto set = [&](Channel channel, int v, Vec x) OCEAN_INLINE_LAMBDA {
        const int slot = task.derived_slot[static_cast<int>(channel)];
        if (slot >= 0) store(row.derived + (slot - task.slots) * kItemWidth + v * kLanes, x);
    };
    const Vec choppiness(kFlat ? 0.0f : task.choppiness);
    if (task.derived_slot[static_cast<int>(Channel::nx)] >= 0) {
        for (int v = 0; v < kRowVectors; ++v) {
            const Vec hx = row.at(slot_of(Linear::slope_x), v);
            const Vec hy = row.at(slot_of(Linear::slope_y), v);
            const formula::SurfaceNormal normal = formula::surface_normal(
                choppiness, gradient(Linear::gradient_xx, v), gradient(Linear::gradient_yy, v),
                gradient(Linear::gradient_xy, v), hx, hy);
            set(Channel::nx, v, normal.x);
            set(Channel::ny, v, normal.y);
            set(Channel::nz, v, normal.z);
        }
    }
    if (!task.needs_jacobian) return;
    const auto set_whitecap = [&](int v) OCEAN_INLINE_LAMBDA {
        const Vec j = formula::surface_jacobian(choppiness, gradient(Linear::gradient_xx, v),
                                                gradient(Linear::gradient_yy, v),
                                                gradient(Linear::gradient_xy, v));
        const Vec w = formula::surface_whitecap(j, task.foam_threshold, task.foam_width);
        set(Channel::jacobian, v, j);
        set(Channel::whitecap, v, w);
        return w;
    };
    if (task.derived_slot[static_cast<int>(Channel::foam)] < 0) {
        for (int v = 0; v < kRowVectors; ++v) set_whitecap(v);
        return;
    }
    if (task.foam.map != nullptr) prefetch_foam(task.foam.map + place);
    for (int v = 0; v < kRowVectors; ++v) {
        const Vec w = set_whitecap(v);
        const Vec before = task.foam.map != nullptr
                               ? load_unaligned(task.foam.map + place + v * kLanes)
                               : Vec(0.0f);
        const Vec value =
            formula::foam_with_whitecap(w, Vec(task.foam.fade) * before, Vec(task.foam.alone));
        Vec foam = Vec(value.v < Vec(task.foam.cutoff).v ? Lanes{} : value.v);
        if (task.foam.kept != nullptr) {
            float* const kept = task.foam.kept + place + v * kLanes;
            if (task.stream_outputs) {
                stream(kept, foam);
            } else {
                store(kept, foam);
            }
            foam = formula::foam_with_whitecap(w, foam, Vec(task.foam.alone));
        }
        set(Channel::foam, v, foam);
    }
    if (task.derived_slot[static_cast<int>(Channel::cover)] < 0) return;
    for (int v = 0; v < kRowVectors; ++v) {
        const Vec foam = row.at(task.derived_slot[static_cast<int>(Channel::foam)], v);
        set(Channel::cover, v, formula::foam_cover(foam, task.foam.cover_power));
    }
}

/// Returns the distance from the beginning of a cache line, in floats.
OCEAN_INLINE int place_in_line(const float* p) {
    return static_cast<int>(reinterpret_cast<std::uintptr_t>(p) / sizeof(float) % kLineFloats);
}

/// Copies `count` floats from `lines` + place_in_line(target) to `target`: whole lines at once and
/// past the caches, including the partial lines that rows of two items share. A cache would first
/// read both partial lines, each from its own page: 1.5 times the frame [measured].
template <int count>
OCEAN_INLINE void stream_lines(float* target, const float* lines) {
    const int offset = place_in_line(target);
    stream_part(target, lines + offset, kLineFloats - offset);
    target -= offset;
    for (int i = kLineFloats; i < count; i += kLanes) stream(target + i, load(lines + i));
    stream_part(target + count, lines + count, offset);
}

/// Writes a row of one output of n interleaved components, past the caches or through them.
template <int n>
OCEAN_INLINE void write_interleaved(const MapOutput& output, const RowSamples& row, bool streams,
                                    float* target) {
    // Host buffers may be unaligned: malloc returns addresses 16 bytes past a cache line.
    const bool in_lines = streams && !is_aligned(target);
    const bool direct = streams && !in_lines;
    alignas(64) float lines[n * kItemWidth + kLineFloats];
    float* const stored = in_lines ? lines + place_in_line(target) : target;
    for (int v = 0; v < kRowVectors; ++v) {
        Vec component[n];
        for (int c = 0; c < n; ++c) {
            const MapOutput::Component& from = output.component[static_cast<std::size_t>(c)];
            component[c] = row.at(from.quantity.id, v) * Vec(from.factor);
        }
        if constexpr (n > 1) interleave(component);
        for (int c = 0; c < n; ++c) {
            const int i = (v * n + c) * kLanes;
            if (direct) {
                stream(target + i, component[c]);
            } else {
                store_unaligned(stored + i, component[c]);
            }
        }
    }
    if (in_lines) stream_lines<n * kItemWidth>(target, lines);
}

/// Writes a row of an output, value by value, if some of its components must stay unchanged.
inline void write_some_components(const MapOutput& output, const RowSamples& row, float* target) {
    for (int c = 0; c < output.components; ++c) {
        const MapOutput::Component& from = output.component[static_cast<std::size_t>(c)];
        if (from.quantity.id < 0) continue;
        const float* values = row.slot[from.quantity.id];
        for (int i = 0; i < kItemWidth; ++i)
            target[i * output.components + c] = values[i] * from.factor;
    }
}

/// Writes a row of samples, which begins at (x, y), to all outputs.
OCEAN_INLINE void write_row(const FrameTask& task, const RowSamples& row, int x, int y) {
    const auto column = static_cast<std::size_t>(x);
    const auto line = static_cast<std::size_t>(y);
    const std::size_t place = line * static_cast<std::size_t>(task.size) + column;
    if (task.choppiness == 0.0f) {
        derive_channels<true>(task, row, place);
    } else {
        derive_channels<false>(task, row, place);
    }
    for (int o = 0; o < task.output_count; ++o) {
        const MapOutput& output = task.outputs[o];
        float* const target = output.data + line * output.row_pitch +
                              column * static_cast<std::size_t>(output.components);
        switch (task.whole[o] ? output.components : 0) {
            case 1:
                write_interleaved<1>(output, row, task.stream_outputs, target);
                break;
            case 2:
                write_interleaved<2>(output, row, task.stream_outputs, target);
                break;
            case 3:
                write_interleaved<3>(output, row, task.stream_outputs, target);
                break;
            case 4:
                write_interleaved<4>(output, row, task.stream_outputs, target);
                break;
            default:
                write_some_components(output, row, target);
                break;
        }
    }
}

void write_outputs(const FrameTask& task, const Rows& rows) {
    alignas(64) float derived[kChannelCount * kItemWidth];
    RowSamples row;
    row.derived = derived;
    for (int s = 0; s < task.derived_slots; ++s) {
        row.slot[task.slots + s] = derived + s * kItemWidth;
    }
    for (int u = 0; u < task.used_count; ++u) row.slot[task.used[u]] = rows.slot[task.used[u]];
    for (int r = 0; r < rows.count; ++r) {
        write_row(task, row, rows.x, rows.y + r * rows.step);
        for (int u = 0; u < task.used_count; ++u) row.slot[task.used[u]] += kItemWidth;
    }
}

}  // namespace ocean::OCEAN_KERNEL
