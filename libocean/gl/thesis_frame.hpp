// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The transform of [Fluegge 2017] on textures: one dispatch for each radix-2 stage, by a butterfly
// texture, back and forth between two textures, and a last pass for the signs. A reference to read,
// to compare with and to look at; the frames of map_frame.hpp are the same in two dispatches.
#pragma once

#include <map>

#include "compute_program.hpp"
#include "modes_on_gpu.hpp"
#include "ocean/backend.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/map_request.hpp"

namespace ocean::gl {

class ThesisFrame {
  public:
    ThesisFrame(int resolution, const ContextInfo& limits);

    /// Uploads modes that are missing. Returns true if it uploaded any.
    bool load(const MapRequest& request, ThreadPool& pool);
    /// Transforms one field; the result is in field(). Throws Error no_gpu.
    void transform(Linear field, const MapRequest& request);
    /// Runs only `stages` stages of the transform, 0 .. 2 log2 N; the result is in complex().
    void transform_stages(Linear field, const MapRequest& request, int stages);

    int stages() const { return 2 * octaves_; }
    const Texture& field() const { return field_; }                 // GL_R32F
    const Texture& complex() const { return ping_pong_[newest_]; }  // GL_RG32F
    const Texture& butterflies() const { return butterflies_; }     // GL_RGBA32F
    int octaves() const { return octaves_; }

  private:
    ComputeProgram& spectrum_program(Linear field);
    void run_tiles() const;

    int resolution_;
    int octaves_ = 0;  // log2 N
    ModesOnGpu modes_;
    Texture butterflies_;
    Texture ping_pong_[2];
    std::size_t newest_ = 0;
    Texture field_;
    std::map<Linear, ComputeProgram> spectrum_;
    ComputeProgram stage_;
    ComputeProgram permutation_;
};

}  // namespace ocean::gl
