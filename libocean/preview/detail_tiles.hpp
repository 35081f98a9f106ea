// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Slopes of the waves too short for the shown maps (ocean/detail.hpp) as an array texture.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/open_sea.hpp"
#include "ocean/internal/preview/sea_maps.hpp"

namespace ocean::preview {

class DetailTiles {
  public:
    /// Returns the tiles of a sea at a time [s], which its cascades' maps lack. They are valid
    /// until the next call. Throws Error.
    const std::vector<DrawnTile>& make(OpenSea& sea, double time,
                                       const std::vector<DrawnCascade>& cascades);

  private:
    void set_sea(OpenSea& sea, const DrawnCascade& finest);

    /// The sea on the grid of its finest map: the detail begins where the waves of that grid end.
    std::unique_ptr<OpenSea> sea_;
    std::uint64_t revision_ = 0;  // of the shown sea
    gl::Texture maps_;            // a layer for each band
    std::vector<std::vector<float>> images_;
    std::vector<std::array<double, kTileLevels>> read_;  // as in DrawnTile
    std::vector<DrawnTile> tiles_;
};

}  // namespace ocean::preview
