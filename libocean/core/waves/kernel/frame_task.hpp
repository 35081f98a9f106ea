// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input of the kernel's passes: plain data, so that the files compiled for one instruction set
// need nothing of the standard library.
//
// A map of N x N samples is made in two passes. x and kx belong together, y and ky; fields are
// real, so ky >= 0 is enough.
//   Pass one: for kLanes neighbouring ky at a time, the modes' state at this time and the
//     coefficients of each source, then the transform along kx -> x, then the transpose.
//   Pass two: for 32 neighbouring x at a time, the transform along ky -> y, two real lines (x and
//     x + 16) as one complex line, and the outputs.
// Both transforms split N = A B ("sweeps"): B transforms of A points, twiddles, A transforms of B.
//   index of a wavenumber: j + B i (i < A, j < B); index of a sample: k + A l (k < A, l < B).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/simd/simd_level.hpp"
#include "ocean/channel.hpp"
#include "ocean/internal/foam_layer.hpp"
#include "ocean/surface.hpp"

namespace ocean {

/// The channels of several linear fields that the kernel has code for, in outputs.hpp.
inline constexpr ChannelSet kKernelFormulas = {Channel::nx,       Channel::ny,       Channel::nz,
                                               Channel::jacobian, Channel::whitecap, Channel::foam,
                                               Channel::cover};

/// Returns A, of N = A B: the first codelets have 16, 32 or 64 points, the second at most 128.
constexpr int first_factor(int size) {
    return size <= 256 ? 16 : size <= 1024 ? 32 : 64;
}

/// The coefficients that pass one transforms. The coefficients of a second field, `derived`, are i
/// ky times the source's: pass two makes them from the same intermediate values.
enum class SourceKind : int {
    plain,        // h
    along_x,      // i kx h
    toward_x,     // -i kx u, with u = displacement * h
    toward_y,     // -i ky u
    gradient_xx,  // kx^2 u
};
struct Source {
    SourceKind kind;
    bool rate;    // made of dh/dt instead of h
    int own;      // slot of the field itself, or -1: not requested
    int derived;  // slot, or -1

    /// Returns true if pass two makes a field from the source.
    bool is_read() const { return own >= 0 || derived >= 0; }
};
inline constexpr int kSourceCount = 8;

/// The packets of the packed modes. All numbers of a packet are kLanes floats, one per ky.
///   A pair, for kx = +-n:  P+ Q+ P- Q- (re, im each)  rate_high rate_low displacement.
///   Two singles, the same for two kx that are no pair: P Q P Q, then both rates and displacements.
/// h(t) = P cos(wt) + Q sin(wt), with P = h0(k) + conj(h0(-k)), Q = -i (h0(k) - conj(h0(-k))).
inline constexpr int kPairNumbers = 11;
inline constexpr int kSinglesNumbers = 14;

/// Modes kx = j + B i and their mirrors N - kx, for i < A. Bit i of `present`: 1 = the group has a
/// packet for i, 0 = its modes are zero.
struct ModeGroup {
    std::uint64_t present;
    std::uint64_t first_packet;  // in floats

    bool operator==(const ModeGroup&) const = default;
};

/// An output whose one component is a linear field: it is written directly, without the detour
/// through the other outputs.
struct DirectPlane {
    int slot;
    float factor;
    float* data;
    std::size_t row_pitch;
};

inline constexpr int kMaxOutputs = 32;

/// One frame. Slots number the fields that pass two computes; channels that combine several fields
/// have the slots after them.
struct FrameTask {
    int size;     // N
    int columns;  // ky < columns may have modes: a multiple of B and of sixteen
    const float* packets;
    const float* toward;      // packets of the same places; null: none
    float share;              // of the way from the amplitudes of `packets` to those of `toward`
    const ModeGroup* groups;  // [block of ky][j < B / 2]
    const float* wavenumber;  // [index of kx or ky], rad/m
    const float* twiddle;     // [j < B][k < A]: cosine, sine of 2 pi j k / N
    double tau;
    float rate_unit;  // omega = rate * rate_unit
    float choppiness;
    float foam_threshold;
    float foam_width;
    FoamLayer foam;

    float* intermediate;
    std::size_t pair_stride;    // floats from one pair of x blocks to the next
    std::size_t source_stride;  // from one source to the next
    std::size_t line_stride;    // and from one j < B / 2 to the next
    bool stream_intermediate;
    /// [item of pass two]: 1 = pass one stores what this item reads; null: for all items.
    const std::uint8_t* strips;
    bool stream_outputs;

    Source source[kSourceCount];
    int source_count;
    int slots;  // linear fields

    /// The sources that pass two reads next: for another part of this item, or for the next item.
    int ahead[kSourceCount];
    int ahead_count;
    int ahead_items;

    DirectPlane direct[kMaxOutputs];
    int direct_count;
    /// The other outputs. Their quantities are slots, and their pitch is known.
    MapOutput outputs[kMaxOutputs];
    int output_count;
    bool whole[kMaxOutputs];  // every component is written
    int used[kLinearCount];   // slots that these outputs read
    int used_count;
    /// [linear field]: its slot, or -1.
    int slot_of[kLinearCount];
    /// [channel]: the slot of a channel that combines several fields, or -1.
    int derived_slot[kChannelCount];
    int derived_slots;    // their number
    bool needs_jacobian;  // for its own channel, whitecaps, foam or cover
};

/// Sets the strides of the intermediate values for kernels of `lanes` lanes: from the size, the
/// columns and the number of sources.
void lay_out(FrameTask& task, int lanes);

/// Linear fields that exist as planes. plane[field] is null or points to the first row of the map;
/// rows lie row_stride floats apart.
struct PlanarFields {
    std::array<const float*, kLinearCount> plane{};
    std::size_t row_stride = 0;
};

/// The functions of one instruction set.
struct KernelCode {
    int lanes;
    int item_width;  // samples of an item of pass two
    std::size_t (*scratch_floats)(const FrameTask&);
    /// Returns the floats of one field in the scratch of pass two.
    std::size_t (*field_floats)(int size);
    /// Runs an item of pass one: a block of `lanes` ky.
    void (*pass_one)(const FrameTask&, int item, float* scratch);
    /// Runs an item of pass two: `item_width` neighbouring x.
    void (*pass_two)(const FrameTask&, int item, float* scratch);
    void (*write_row)(const FrameTask&, const PlanarFields&, int row);
    void (*codelet)(int points, const float* in, float* out);  // for its test
};

const KernelCode& kernel_code(SimdLevel level);

}  // namespace ocean
