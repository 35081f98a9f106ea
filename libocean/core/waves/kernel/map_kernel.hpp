// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The kernel of the cpu backend: from the modes of a map to the maps of one time, in one go. The
// mathematics is in pass_one.hpp and pass_two.hpp, compiled once per instruction set; this file is
// its interface to the rest of core.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "frame_task.hpp"
#include "ocean/backend.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean {

class PackedModes;

/// One frame.
struct KernelFrame {
    double tau = 0.0;                    // Modes::tau of the time
    SurfaceSettings settings;            // choppiness; for whitecaps as from with_threshold
    std::span<const MapOutput> outputs;  // linear fields, their multiples and kKernelFormulas
    FoamLayer foam;
};

/// Returns the modes of one map in the order in which the kernel walks them. Immutable: kernels in
/// any threads may share it.
std::shared_ptr<const PackedModes> pack_modes(const MapModes& modes, ThreadPool& pool,
                                              SimdLevel level = simd_level());

/// Makes frames of one map. Owns the arrays between the passes, so that a frame allocates nothing
/// once its fields have been requested. One frame at a time; kernels in several threads are
/// independent.
class MapKernel {
  public:
    /// The sizes of caches change the order of the work, never its bits.
    explicit MapKernel(std::shared_ptr<const PackedModes> modes,
                       const CacheSizes& caches = cache_sizes());
    /// Switches to other modes of the same resolution, or to the same filled anew, and keeps the
    /// arrays. The amplitudes are theirs.
    void use(std::shared_ptr<const PackedModes> modes);
    /// Puts the amplitudes `share` of the way towards those of other modes of the same lattice;
    /// null: they are those of the modes in use.
    void interpolate(std::shared_ptr<const PackedModes> toward, float share);
    ~MapKernel();
    MapKernel(MapKernel&&) noexcept;
    MapKernel& operator=(MapKernel&&) noexcept;

    void run(const KernelFrame& frame, ThreadPool& pool);

    /// Begins a frame of at most kMaxOutputs outputs without computing any, for a caller that reads
    /// few columns of a map: sweep() and then write_strip() make these.
    void begin(const KernelFrame& frame, ThreadPool& pool);
    /// Runs pass one for each strip of strip_width() columns whose number in `strips` is not 0, or
    /// for all if `strips` is empty, on the threads of the pool or, if it is null, on the calling
    /// thread. Most of the work is the same for any number of strips. A later call adds others.
    void sweep(std::span<const std::uint8_t> strips, ThreadPool* pool);
    /// Runs pass two for one strip that has been swept: writes the outputs there. Strips may run in
    /// any order, and in several threads at once, each with its own scratch of scratch_floats().
    int strip_width() const;
    std::size_t scratch_floats() const;
    void write_strip(int strip, float* scratch) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Runs the last stage alone, for linear fields that exist as planes: writes rows first .. last - 1
/// of the outputs.
void write_rows(const PlanarFields& fields, int resolution, int first, int last,
                const KernelFrame& frame, SimdLevel level = simd_level());

/// Returns an upper bound of the bytes of a map's packed modes.
std::uint64_t packed_bytes(int resolution);
/// Returns the bytes that a kernel needs for maps of a sea: packed modes, and the arrays between
/// the passes.
std::uint64_t kernel_bytes(const Grid& grid, LinearSet fields, int resolution);

}  // namespace ocean
