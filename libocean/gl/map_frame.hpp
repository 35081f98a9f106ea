// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps of one resolution on the GPU: modes in, textures out, in two dispatches.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "compute_program.hpp"
#include "frame_plan.hpp"
#include "modes_on_gpu.hpp"
#include "objects.hpp"
#include "ocean/backend.hpp"
#include "ocean/gl/context.hpp"

namespace ocean::gl {

class MapFrame {
  public:
    /// Throws Error no_gpu for a resolution that is beyond the limits.
    MapFrame(int resolution, const ContextInfo& limits);

    /// Makes the textures of these quantities. The foam's past is taken from `past`, a texture of
    /// one float, where `layer` has one; fade and least are the layer's. Returns whether it had to
    /// upload modes.
    bool make(const MapRequest& request, std::vector<Quantity> quantities, const Texture& past,
              ThreadPool& pool);

    /// Of the last make.
    const FramePlan& plan() const { return program_->plan; }
    const Texture& map(std::size_t number) const { return maps_[number]; }

  private:
    struct Programs {
        FramePlan plan;
        ComputeProgram rows;
        ComputeProgram columns;
    };

    Programs& programs_for(std::vector<Quantity> quantities, bool flat);
    void hold_packs(std::size_t count);
    void hold_maps(const FramePlan& plan);
    void run_rows(const MapRequest& request);
    void run_columns(const MapRequest& request, const Texture& past);

    PassShape shape_;
    ModesOnGpu modes_;
    Buffer roots_;
    std::vector<Buffer> packs_;
    std::vector<Texture> maps_;
    std::vector<GLenum> formats_;  // of maps_
    std::map<std::string, Programs> programs_;
    Programs* program_ = nullptr;
};

inline constexpr GLuint kRootsBinding = 3;

/// Throws Error no_gpu for a resolution that is beyond the limits, which it names.
void require_limits(int resolution, const ContextInfo& limits);
/// e^(2 pi i k / N) for k = 0 .. N - 1.
Buffer make_roots(int resolution);
/// The uniforms of shaders/compute/modes.glsl for the current program.
void set_time(ComputeProgram& program, const MapModes& modes);
/// A texture of N x N texels without mipmaps, for texelFetch and imageStore.
Texture make_texture(GLenum format, int resolution);

}  // namespace ocean::gl
