// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sums over the waves of a coast on the GPU, by compute/coast_waves.comp.
#pragma once

#include <array>
#include <memory>

#include "compute_program.hpp"
#include "ocean/internal/coast_waves.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/gl/objects.hpp"

namespace ocean::gl {

/// Keeps the maps that do not change with time, and the buffers. Its context must be current in
/// every call.
class CoastSums {
  public:
    explicit CoastSums(const ContextInfo& limits) : limits_(limits) {}

    /// Writes the sums of a request. Throws Error unsupported for maps that are larger than a
    /// texture or a buffer of this GPU can be, out_of_memory, and no_gpu.
    void write(const CoastRequest& request);

  private:
    /// QuadMaps as a texture with a layer for each map.
    struct Layers {
        Texture texture;
        std::shared_ptr<const void> owner;
    };
    void load(const QuadMaps& maps, Layers& layers) const;
    void load_signals(const CoastWaves& waves, bool rates);

    ContextInfo limits_;
    std::array<ComputeProgram, 3> programs_;  // of parts 1, 3 and 4; made when first needed
    Layers delays_, energy_;
    Buffer labels_, coefficients_, coast_, depths_, sums_;
};

}  // namespace ocean::gl
