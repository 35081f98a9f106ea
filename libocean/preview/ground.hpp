// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Land as a drawable: the repeated tile to its horizon on the clipmap.
#pragma once

#include <string>

#include "clipmap.hpp"
#include "drawable.hpp"
#include "land_block.hpp"
#include "texture_units.hpp"

namespace ocean::preview {

/// Returns the defines that ground.vert and ground.frag are compiled with. taps: samples along a
/// footprint; 0: the driver's anisotropic filter.
std::string ground_defines(int taps);

class Ground : public Drawable {
  public:
    explicit Ground(const RendererOptions& options);

    /// Sets the land of the pictures to come, which must outlive them.
    void show(const ShownLand& land) { land_ = &land; }
    double farthest(const PictureFrame& frame) const override;
    void draw(const PictureFrame& frame) override;

  private:
    int taps_;  // samples along a footprint; 0: the driver's filter fits the footprints
    int shadow_steps_;
    Clipmap clipmap_;
    Clipmap lines_;  // of a wireframe: coarser, so that its lines do not fill the picture
    gl::ShaderProgram program_;
    gl::Sampler sampler_;
    UniformBlock<LandBlock> block_;
    const ShownLand* land_ = nullptr;
};

}  // namespace ocean::preview
