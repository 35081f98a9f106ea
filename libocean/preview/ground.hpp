// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Land as a drawable: the ground to its horizon on the patches of the quadtree, and the water of a
// land with a coast.
#pragma once

#include <string>

#include "drawable.hpp"
#include "land_block.hpp"
#include "land_patches.hpp"
#include "texture_units.hpp"

namespace ocean::preview {

/// Returns the defines that the shaders of land are compiled with. taps: samples along a footprint;
/// 0: the driver's anisotropic filter. coast: the land is the bed of a sea.
std::string ground_defines(int taps, bool coast = false);

class Ground : public Drawable {
  public:
    explicit Ground(const RendererOptions& options);

    /// Sets the land of the pictures to come, which must outlive them.
    void show(const DrawnLand& land);
    double farthest(const PictureFrame& frame) const override;
    void draw(const PictureFrame& frame) override;
    /// Returns whether the last picture lacks patches that other threads make.
    Pending pending() const { return patches_.pending(); }
    LandStatistics statistics() const;

  private:
    void draw_water(const PictureFrame& frame);
    void bind_maps(gl::ShaderProgram& program, TextureUnits& units);

    int taps_;  // samples along a footprint; 0: the driver's filter fits the footprints
    int shadow_steps_;
    LandPatches patches_;
    Clipmap water_;
    gl::ShaderProgram program_, water_program_;
    gl::Sampler sampler_;
    UniformBlock<LandBlock> block_;
    const DrawnLand* land_ = nullptr;
    std::uint64_t map_bytes_ = 0;
};

}  // namespace ocean::preview
