// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The settings of a bake of volumes: which grids, of which box, in voxels of which size.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "formats/spray_points.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/io/product_image.hpp"
#include "ocean/io/vdb.hpp"

namespace ocean {

/// Beyond all coordinates of a box [m].
inline constexpr double kFarthestInVolumes = 1e7;

struct VolumeSettings {
    bool usual = false;  // nobody asked for products
    bool surface = false;
    bool velocity = false;
    bool density = false;
    bool half_floats = false;
    io::Axes axes = io::Axes::zup;
    // Settled before the plan is made; what was not typed is NaN or 0 until then.
    std::optional<std::array<double, 6>> box;  // low and high x, y, z; NaN at the end: the crest
    double voxel = 0.0;                        // m
    double velocity_voxel = 0.0;
    HeightRange heights;  // of the subject
    /// m^2 of cross-section for each m^2 that turns white: a strong gale leaves 3 km of sight.
    double mist = 0.05;
    SpraySettings spray;  // whose births the mist is of

    bool to_the_crest() const { return std::isnan(box->back()); }
    std::vector<const Product*> product_rows() const;
    std::string products() const;
    std::string box_text() const;
    /// Returns the box, as high as `crest` [m] where it ends at the crests.
    io::WorldBox world_box(double crest) const;
};

/// Returns the settings of a plan of volumes.
const VolumeSettings& volume_settings_of(const BakePlan& plan);

}  // namespace ocean
