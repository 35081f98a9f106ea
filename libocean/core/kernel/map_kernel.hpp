// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The kernel of the cpu backend: from the modes of a map to the maps of one time, in one go. The
// mathematics is in pass_one.hpp and pass_two.hpp, compiled once per instruction set; here is what
// the rest of core sees of it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "frame_task.hpp"
#include "ocean/backend.hpp"

namespace ocean {

class PackedModes;

/// One frame.
struct KernelFrame {
    double tau = 0.0;                    // of Modes
    SurfaceSettings settings;            // choppiness; for whitecaps as from with_threshold
    std::span<const MapOutput> outputs;  // of linear fields, their multiples and kKernelFormulas
    FoamLayer foam;
};

/// The modes of one map in the order in which the kernel walks them. Immutable: many kernels, in
/// any threads, may share it.
std::shared_ptr<const PackedModes> pack_modes(const MapModes& modes, ThreadPool& pool,
                                              SimdLevel level = simd_level());

/// Makes frames of one map. Owns the arrays between the passes, so that a frame allocates nothing
/// once its fields have been asked for. One frame at a time; kernels in several threads are
/// independent.
class MapKernel {
  public:
    explicit MapKernel(std::shared_ptr<const PackedModes> modes);
    /// Other modes of the same resolution, in the arrays that are there.
    void use(std::shared_ptr<const PackedModes> modes);
    ~MapKernel();
    MapKernel(MapKernel&&) noexcept;
    MapKernel& operator=(MapKernel&&) noexcept;

    void run(const KernelFrame& frame, ThreadPool& pool);

    /// The same in parts, for who looks at few columns of a map: pass one, for at most kMaxOutputs
    /// outputs;
    void begin(const KernelFrame& frame, ThreadPool& pool);
    /// then, strip after strip of strip_width() columns in any order, what the outputs have there.
    /// Several threads at once, with a scratch of scratch_floats() of its own each.
    int strip_width() const;
    std::size_t scratch_floats() const;
    void write_strip(int strip, float* scratch) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The last stage alone, for linear fields that are there as planes: rows first .. last - 1 of the
/// outputs.
void write_rows(const PlanarFields& fields, int resolution, int first, int last,
                const KernelFrame& frame, SimdLevel level = simd_level());

/// Bytes of the packed modes of a map, at most.
std::uint64_t packed_bytes(int resolution);
/// Those that a kernel takes for maps of a sea: packed modes, and what lies between the passes.
std::uint64_t kernel_bytes(const Grid& grid, LinearSet fields, int resolution);

}  // namespace ocean
