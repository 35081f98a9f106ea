// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The water in a box of the world as OpenVDB volumes: its surface as a level set, its velocity, and
// the mist of its spray as a fog.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "formats/formats.hpp"
#include "formats/spray_points.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"
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

std::vector<FormatOption> volume_options();
ProductChoice volume_choice();
VolumeSettings read_volumes(const BakeOptions& options, const ChosenProducts& chosen);
std::vector<const Product*> volume_products(const VolumeSettings& settings);
FrameMaps volume_maps(const BakePlan& draft, const VolumeSettings& settings);
/// Returns the settings, with defaults for a box and voxels that were not given.
VolumeSettings resolve_volumes(const BakePlan& draft, const VolumeSettings& requested);
std::vector<BakeFile> list_volumes(const BakePlan& plan, const VolumeSettings& settings, int frame);
std::vector<io::HeaderString> volume_strings(const BakePlan& plan, const VolumeSettings& settings,
                                             int frame);
std::string volume_recipe(const BakePlan& plan, const VolumeSettings& settings,
                          const BakeFile& file);
/// Return upper bounds of the memory of a frame and of the size of its file [bytes].
std::uint64_t volume_frame_bytes(const BakePlan& plan, const VolumeSettings& settings);
std::uint64_t max_volume_bytes(const BakePlan& plan, const VolumeSettings& settings);
void write_volumes(const FrameWork& work, const VolumeSettings& settings,
                   std::span<const BakeFile> files);
/// Sets all options but the products and the axes.
void adopt_volumes(const BakedHeader& header, BakeOptions& options);

}  // namespace ocean
