// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The water as a drawable: to its horizon on the clipmap, or as tiles of the look `seed`.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "clipmap.hpp"
#include "coast_ground.hpp"
#include "drawable.hpp"
#include "lace_maps.hpp"
#include "seed_mesh.hpp"
#include "texture_units.hpp"
#include "water_block.hpp"
#include "water_program.hpp"

namespace ocean::preview {

class Water : public Drawable {
  public:
    explicit Water(const RendererOptions& options);

    /// Sets the sea of the pictures to come, which must outlive them. Throws Error invalid_value
    /// for more cascades, foams or slope tiles than two seas have.
    void show(const DrawnSea& sea);
    double farthest(const PictureFrame& frame) const override;
    void draw(const PictureFrame& frame) override;

    /// Returns what the last picture lacks for want of texture units.
    const LeftOut& left_out() const { return left_out_; }
    /// Returns the state of the pattern of the foam, if the last picture has one.
    Pending pending() const;

  private:
    using Programs = std::map<WaterVariant, gl::ShaderProgram>;

    WaterVariant variant(const PictureFrame& frame) const;
    gl::ShaderProgram& program(Programs& known, const std::string& name,
                               const WaterVariant& variant);
    void bind_maps(gl::ShaderProgram& program, TextureUnits& units, const WaterVariant& variant);
    void bind_lace(gl::ShaderProgram& program, TextureUnits& units, bool ready);
    void draw_seed(const PictureFrame& frame);
    void draw_clipmap(const PictureFrame& frame);

    int taps_;  // samples along a footprint; 0: the driver's filter fits the footprints
    int available_units_;
    Clipmap clipmap_;
    SeedMesh seed_mesh_;
    LaceMaps lace_maps_;
    RendererOptions options_;
    std::optional<CoastGround> coast_;  // made for the first picture of a coast
    Programs waters_, seeds_;
    gl::Sampler sampler_;
    UniformBlock<WaterBlock> block_;
    const DrawnSea* sea_ = nullptr;
    bool lace_used_ = false;
    LeftOut left_out_;
};

}  // namespace ocean::preview
