// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The spray of a frame as a file of points whose header says what it is: what the formats of such
// files share. The product `spray` stands alone.
#pragma once

#include <string>
#include <vector>

#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/io/points.hpp"
#include "ocean/io/product_image.hpp"
#include "ocean/spray.hpp"

namespace ocean {

inline constexpr Product kSprayProduct = {"spray", {}, 0, "", false, kSeaKind};
/// For the help of --products.
inline constexpr std::string_view kSprayProductHelp =
    "; or spray alone: particles that the wind tears off where the sea turns white";

struct SprayPoints {
    SpraySettings settings;
    io::Axes axes = io::Axes::zup;
};

/// --spray-lifetime, --spray-density, --spray-most.
std::vector<FormatOption> spray_options();
/// Throws Error invalid_value for an option of spray: what is asked for is not `made_of_it`.
void refuse_spray_options(const BakeOptions& options, std::string_view made_of_it);
SpraySettings read_spray_settings(const BakeOptions& options);
SprayPoints read_spray(const BakeOptions& options);
/// Null where the plan's format makes something else.
const SprayPoints* spray_of(const BakePlan& plan);

/// As a header and a recipe say them.
std::vector<io::HeaderString> spray_setting_strings(const SpraySettings& settings);

FormatPlan settle_spray(const BakePlan& begun);
std::vector<BakeFile> list_spray(const BakePlan& plan, int frame);
std::vector<io::HeaderString> spray_strings(const BakePlan& plan, int frame);
std::string spray_recipe(const BakePlan& plan, const BakeFile& file);
/// Of a frame, at most.
std::uint64_t most_spray_points(const BakePlan& plan);
std::uint64_t spray_frame_bytes(const BakePlan& plan);
io::Points make_spray_points(const FrameWork& work);
void adopt_spray_settings(const BakedHeader& header, BakeOptions& options);
void adopt_spray(const BakedHeader& header, BakeOptions& options);

}  // namespace ocean
