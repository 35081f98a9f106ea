// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The settings of a bake of volumes: its grids, its box and the size of its voxels.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "formats/spray_points.hpp"
#include "ocean/internal/io/product_image.hpp"
#include "ocean/io/vdb.hpp"

namespace ocean {

/// The limit of all coordinates of a box [m].
inline constexpr double kMaxVolumeCoordinate = 1e7;

struct VolumeSettings {
    bool is_default = false;  // --products was not given
    bool surface = false;
    bool velocity = false;
    bool density = false;
    bool half_floats = false;
    io::Axes axes = io::Axes::zup;
    // Values that were not given are absent or 0 until resolve_volumes().
    std::optional<std::array<double, 6>> box;  // low and high x, y, z [m]; last NaN: at the crest
    double voxel = 0.0;                        // [m]
    double velocity_voxel = 0.0;               // [m]
    HeightRange heights;                       // heights of the subject
    /// Cross-section of the mist for each area that turns white [m^2 / m^2]; in a strong gale the
    /// default leaves a visibility of 3 km.
    double mist = 0.05;
    SpraySettings spray;  // the spray whose births make the mist

    bool to_the_crest() const { return std::isnan(box->back()); }
    std::vector<const Product*> product_rows() const;
    std::string products() const;
    std::string box_text() const;
    /// Returns the box; one that ends at the crests has the height `crest` [m].
    io::WorldBox world_box(double crest) const;
};

}  // namespace ocean
