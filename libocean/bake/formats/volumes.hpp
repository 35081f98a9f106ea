// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The water in a box of the world as OpenVDB volumes: its surface as a level set, its velocity, and
// the mist of its spray as a fog.
#pragma once

#include <any>
#include <string>
#include <vector>

#include "formats/formats.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/io/vdb.hpp"

namespace ocean {

std::vector<FormatOption> volume_options();
ProductChoice volume_choice();
std::any read_volumes(const BakeOptions& options, const ChosenProducts& chosen);
std::vector<const Product*> volume_products(const BakePlan& begun);
FormatPlan settle_volumes(const BakePlan& begun);
std::vector<BakeFile> list_volumes(const BakePlan& plan, int frame);
std::vector<io::HeaderString> volume_strings(const BakePlan& plan, int frame);
std::string volume_recipe(const BakePlan& plan, const BakeFile& file);
std::uint64_t volume_frame_bytes(const BakePlan& plan);
std::uint64_t most_volume_bytes(const BakePlan& plan);
void write_volumes(const FrameWork& work, std::span<const BakeFile> files);
/// All but the products and the axes.
void adopt_volumes(const BakedHeader& header, BakeOptions& options);

}  // namespace ocean
