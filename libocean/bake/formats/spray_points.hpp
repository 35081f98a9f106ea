// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The spray of a frame as a file of points whose header describes it: the part that all such
// formats share. A file with the product `spray` holds no other product.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/internal/io/product_image.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/spray.hpp"

namespace ocean {

inline constexpr Product kSprayProduct = {
    .name = "spray",
    .channels = {},
    .count = 0,
    .unit = "",
    .subject = kSeaKind,
    .help = "Particles that the wind tears off where the sea turns white"};

struct SprayPoints {
    SpraySettings settings;
    io::Axes axes = io::Axes::zup;
};

/// Returns --spray-lifetime, --spray-density and --spray-most.
std::vector<FormatOption> spray_options();
/// Throws Error invalid_value for an option of spray if the products have no spray; `products`
/// names the products that would.
void refuse_spray_options(const BakeOptions& options, std::string_view products);
SpraySettings read_spray_settings(const BakeOptions& options);
SprayPoints read_spray(const BakeOptions& options);

/// Returns the settings in the form of headers and recipes.
std::vector<io::HeaderString> spray_setting_strings(const SpraySettings& settings);

FrameMaps spray_maps(const BakePlan& draft);
std::vector<BakeFile> list_spray(const BakePlan& plan, int frame);
std::vector<io::HeaderString> spray_strings(const BakePlan& plan, const SprayPoints& spray,
                                            int frame);
std::string spray_recipe(const BakePlan& plan, const SprayPoints& spray, const BakeFile& file);
/// Returns the region that a plan shows, as Ocean::spray takes it; nothing for one period.
std::optional<Domain> spray_region(const BakePlan& plan);
/// Returns the samples that a plan's spray is emitted on.
Domain spray_domain(const BakePlan& plan);
/// Returns the number of points of a frame, an upper bound.
std::uint64_t max_spray_points(const BakePlan& plan, const SpraySettings& settings);
/// Returns the bytes of the maps that spray is emitted on.
std::uint64_t spray_map_bytes(const BakePlan& plan);
std::uint64_t spray_frame_bytes(const BakePlan& plan, const SprayPoints& spray);
io::Points make_spray_points(const FrameWork& work, const SprayPoints& spray);
void adopt_spray_settings(const BakedHeader& header, BakeOptions& options);
void adopt_spray(const BakedHeader& header, BakeOptions& options);

/// Returns a warning if the spray's cells over a bed or of a region are longer than breakers are;
/// else "". Those of more than 4096 m have such cells.
std::string spray_cell_warning(const BakePlan& plan);

}  // namespace ocean
