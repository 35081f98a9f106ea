// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps of one resolution on the GPU: modes in, textures out, in two dispatches.
#pragma once

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "compute_program.hpp"
#include "frame_plan.hpp"
#include "modes_on_gpu.hpp"
#include "ocean/backend.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/gl/textures.hpp"
#include "ocean/internal/map_request.hpp"

namespace ocean::gl {

class MapFrame {
  public:
    /// Throws Error no_gpu for a resolution that is beyond the limits.
    MapFrame(int resolution, const ContextInfo& limits, Mipmaps mipmaps = Mipmaps::no);

    /// Makes the textures of these quantities; of mipmaps the first level alone. The foam's past is
    /// a texture of one float, or null; its fade and cutoff are the request's. Returns whether it
    /// had to upload modes.
    bool make(const MapRequest& request, std::vector<Quantity> quantities, const Texture* past,
              ThreadPool& pool);
    /// Gives a map another texture, of that format, and takes the one that it had, or none.
    void exchange_map(std::size_t number, GLenum format, Texture& texture);

    /// Sets a function called before each dispatch and after the last one, to measure their times.
    void watch(std::function<void()> mark) { mark_ = std::move(mark); }

    /// Returns the plan of the last make().
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
    void run_columns(const MapRequest& request, const Texture* past);

    PassShape shape_;
    Mipmaps mipmaps_ = Mipmaps::no;
    ModesOnGpu modes_;
    Buffer roots_;
    std::vector<Buffer> packs_;
    std::vector<Texture> maps_;
    std::vector<GLenum> formats_;  // of maps_
    Texture no_past_;              // for foam that begins
    std::function<void()> mark_;
    /// By the quantities' ids and whether the choppiness is 0.
    std::map<std::pair<std::vector<int>, bool>, Programs> programs_;
    Programs* program_ = nullptr;
};

inline constexpr GLuint kRootsBinding = 3;

/// Throws Error no_gpu for a resolution that is beyond the limits, which it names.
void require_limits(int resolution, const ContextInfo& limits);
/// Returns a buffer of e^(2 pi i k / N) for k = 0 .. N - 1.
Buffer make_roots(int resolution);
/// Sets the uniforms of shaders/compute/modes.glsl for the current program.
void set_time(ComputeProgram& program, const MapModes& modes);

}  // namespace ocean::gl
