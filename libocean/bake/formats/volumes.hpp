// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The water in a box of the world as OpenVDB volumes: its surface as a level set, its velocity, and
// the mist of its spray as a fog.
#pragma once

#include <string>
#include <vector>

#include "formats/formats.hpp"
#include "formats/volume_settings.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/io/vdb.hpp"

namespace ocean {

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
