// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The waves too short for the shown maps as textures of their slopes: ocean/detail.hpp in the
// context.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ocean/gl/objects.hpp"
#include "ocean/ocean.hpp"
#include "ocean/preview/sea_maps.hpp"

namespace ocean::preview {

class DetailTiles {
  public:
    /// Of a sea at a time, beside the maps of its cascades. Throws Error.
    const std::vector<ShownTile>& make(Ocean& sea, double time,
                                       const std::vector<ShownCascade>& cascades);

  private:
    void stand_for(Ocean& sea, const ShownCascade& finest);

    /// The sea on the grid of its finest map: there the detail begins where that ends.
    std::unique_ptr<Ocean> sea_;
    std::uint64_t revision_ = 0;  // of the sea that it is of
    gl::Texture maps_;            // a layer for each band
    std::vector<std::vector<float>> images_;
    std::vector<std::array<double, kTileLevels>> read_;  // as in ShownTile
    std::vector<ShownTile> tiles_;
};

}  // namespace ocean::preview
