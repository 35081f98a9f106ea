// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The cascades and the foam of a sea as textures that the sea's own backend fills, as
// gl::SeaTextures are the textures that shaders fill.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "ocean/internal/foam.hpp"
#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/gl/sea_textures.hpp"
#include "ocean/internal/open_sea.hpp"

namespace ocean::preview {

/// A map of foam, over which the renderer lays the whitecaps of the moment.
struct FoamOfMaps {
    unsigned texture = 0;
    FoamLattice lattice{};
    float fade = 1.0f;       // factor of its texels
    double threshold = 0.0;  // of the whitecaps
    double width = 1.0;
};

/// RGBA maps of all cascades.
class UploadedCascades {
  public:
    UploadedCascades(int resolution, std::size_t cascades);

    bool fits(int resolution, std::size_t cascades) const {
        return resolution == resolution_ && cascades == cascades_;
    }
    void make(OpenSea& sea, double time);
    gl::CascadeArrays arrays() const {
        return {resolution_, displacement_.name(), gradients_.name(), moments_.name()};
    }

  private:
    void make_layer(OpenSea& sea, double time, std::size_t cascade);
    std::size_t texels() const {
        return 4 * static_cast<std::size_t>(resolution_) * static_cast<std::size_t>(resolution_);
    }
    gl::Texture array() const;
    void upload(const gl::Texture& texture, int layer, const std::vector<float>& image) const;

    int resolution_;
    std::size_t cascades_;
    gl::Texture displacement_, gradients_, moments_;
    std::vector<float> displacement_image_, gradients_image_, moments_image_;  // of one cascade
};

class UploadedMaps {
  public:
    /// Samples along a side: 0 = the samples of the sea's lattices, and of its default map.
    /// after_stage: "cascades", "foam".
    UploadedMaps(int cascade_resolution, int foam_resolution, gl::AfterStage after_stage)
        : cascade_resolution_(cascade_resolution),
          foam_resolution_(foam_resolution),
          after_stage_(std::move(after_stage)) {}

    /// Makes the textures of a time [s]. Throws Error.
    void show(OpenSea& sea, double time);

    // The results of the last show().
    gl::CascadeArrays arrays() const { return cascades_->arrays(); }
    const FoamOfMaps& foam() const { return foam_; }

  private:
    void find_threshold(OpenSea& sea, double time, int resolution);
    void make_foam(OpenSea& sea, double time, int resolution);

    int cascade_resolution_;
    int foam_resolution_;
    gl::AfterStage after_stage_;
    std::optional<UploadedCascades> cascades_;
    FoamOfMaps foam_;
    gl::Texture foam_texture_;
    int texture_resolution_ = 0;
    std::vector<float> foam_image_;
    Revision threshold_revision_;
    SurfaceSettings given_;
};

}  // namespace ocean::preview
