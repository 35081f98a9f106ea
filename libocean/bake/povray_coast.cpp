// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The folder of a sea over a bed or with hulls for POV-Ray; see povray_folder.hpp. It is the folder
// of the open sea beside the region, with a map of the region for each frame, the bed as a land,
// and the macros of all.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "ocean/internal/bake/povray_folder.hpp"
#include "ocean/internal/io/df3.hpp"
#include "ocean/internal/io/povray_declarations.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/sea_bed.hpp"
#include "ocean/seafile.hpp"
#include "povray_macros.hpp"

namespace ocean {
namespace {

constexpr int kMaxLandSide = 2048;  // samples
constexpr std::array kBedMasks = {channel_of(LandMask::beach), channel_of(LandMask::cliff)};

/// Returns the bed's domain with every stride-th sample, at most kMaxLandSide along a side.
Domain land_domain(const SeaBed& bed, int& stride) {
    Domain domain = bed.domain;
    const int longer = std::max(domain.samples[0], domain.samples[1]);
    stride = (longer + kMaxLandSide - 1) / kMaxLandSide;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        domain.samples[axis] = (bed.domain.samples[axis] - 1) / stride + 1;
        domain.size[axis] = (domain.samples[axis] - 1) * stride * bed.domain.step(axis);
    }
    return domain;
}

float smooth_step(float from, float to, float value) {
    const float t = std::clamp((value - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/// Returns the share of sand: up to 2 .. 3.5 m over still water, on flat ground. The limits are
/// chosen by eye.
float beach_share(float height, float slope) {
    return smooth_step(3.5f, 2.0f, height) * smooth_step(0.45f, 0.25f, slope);
}
/// Returns the share of bare rock: steep ground up to 6 .. 14 m over still water. The limits are
/// chosen by eye.
float cliff_share(float height, float slope) {
    return smooth_step(14.0f, 6.0f, height) * smooth_step(0.35f, 0.6f, slope);
}

/// Returns the bed as a land: its height and normal, and the masks that its shape suggests.
Surface bed_land(const SeaBed& bed) {
    int stride = 1;
    const Domain domain = land_domain(bed, stride);
    ChannelSet channels = {Channel::height, Channel::nx, Channel::ny, Channel::nz};
    for (const Channel mask : kBedMasks) channels = channels | ChannelSet{mask};
    Surface land(domain, 0.0, channels);
    const auto columns = static_cast<std::size_t>(bed.domain.samples[0]);
    const auto bed_at = [&](int i, int j) {
        const int column = std::clamp(i, 0, bed.domain.samples[0] - 1);
        const int row = std::clamp(j, 0, bed.domain.samples[1] - 1);
        return bed
            .heights[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column)];
    };
    const float over = 0.5f / (static_cast<float>(stride) * static_cast<float>(bed.cell()));
    std::size_t at = 0;
    for (int j = 0; j < domain.samples[1] * stride; j += stride) {
        for (int i = 0; i < domain.samples[0] * stride; i += stride, ++at) {
            const float height = bed_at(i, j);
            const float east = (bed_at(i + stride, j) - bed_at(i - stride, j)) * over;
            const float north = (bed_at(i, j + stride) - bed_at(i, j - stride)) * over;
            const float slope = std::hypot(east, north),
                        up = 1.0f / std::sqrt(1.0f + slope * slope);
            land.channel(Channel::height)[at] = height;
            land.channel(Channel::nx)[at] = -east * up;
            land.channel(Channel::ny)[at] = -north * up;
            land.channel(Channel::nz)[at] = up;
            land.channel(kBedMasks[0])[at] = beach_share(height, slope);
            land.channel(kBedMasks[1])[at] = cliff_share(height, slope);
        }
    }
    return land;
}

FolderFile& named(std::vector<FolderFile>& files, std::string_view name) {
    return *std::ranges::find(files, name, &FolderFile::name);
}

void add_region(std::vector<FolderFile>& files, const BakePlan& region) {
    const auto& bed = sea_of(*region.subject).parameters.water.bed;
    named(files, "ocean_parameters.inc").text += io::povray_region_declarations(
        region.domain(), bed ? &bed->domain : nullptr, region.subject_id);
}

/// Returns the files of the bed as a land.
std::vector<FolderFile> land_files(const SeaBed& sea_bed) {
    const Surface land = bed_land(sea_bed);
    const std::string id = sea_bed.sha256.substr(0, 16);
    const io::PovrayBed bed{land, kBedMasks, id};
    return {{"terrain_parameters.inc", io::povray_bed_parameters(bed)},
            {"land.df3.inc", io::povray_bed_words(bed)},
            {"land.df3", io::df3_text(land, io::df3_slices(kTerrainKind))},
            {"land_masks.df3", io::masks_df3_text(land, kBedMasks)}};
}

}  // namespace

std::vector<FolderFile> povray_region_frame_lists(const PovrayRegionPlans& plans,
                                                  const SeaState& state,
                                                  const std::vector<int>& frames) {
    std::vector<FolderFile> files = povray_frame_lists(plans.open, state, frames);
    add_region(files, plans.region);
    return files;
}

std::vector<FolderFile> povray_region_files(const PovrayRegionPlans& plans, const SeaState& state,
                                            const std::vector<int>& frames,
                                            const FoamImages& foam) {
    const auto& bed = sea_of(*plans.region.subject).parameters.water.bed;
    std::vector<FolderFile> files = povray_folder_files(plans.open, state, frames, foam);
    add_region(files, plans.region);
    named(files, "scene.pov").text = bed ? kCoastScenePov : kHullScenePov;
    named(files, "sea.toml").text =
        "# The sea of this folder, by `ocean povray`.\n" + plans.region.subject_text;
    files.push_back({"coast.inc", std::string(kCoastInc)});
    files.push_back({"terrain.inc", std::string(kTerrainInc)});
    if (bed) std::ranges::move(land_files(*bed), std::back_inserter(files));
    return files;
}

}  // namespace ocean
