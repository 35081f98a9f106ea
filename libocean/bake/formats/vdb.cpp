// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenVDB: volumes of the water in a box, or the points of spray.
#include "ocean/io/vdb.hpp"

#include <variant>

#include "formats/formats.hpp"
#include "formats/spray_points.hpp"
#include "formats/volumes.hpp"
#include "ocean/bake/typed_format.hpp"
#include "refuse.hpp"
#include "source.hpp"

namespace ocean {
namespace {

using VolumesOrSpray = std::variant<VolumeSettings, SprayPoints>;

const SprayPoints* spray_of(const VolumesOrSpray& settings) {
    return std::get_if<SprayPoints>(&settings);
}

const VolumeSettings& volumes_of(const VolumesOrSpray& settings) {
    return std::get<VolumeSettings>(settings);
}

std::vector<FormatOption> list_options(const Catalogue&) {
    std::vector<FormatOption> options = volume_options();
    for (FormatOption& option : spray_options()) options.push_back(std::move(option));
    return options;
}

std::optional<ProductChoice> product_choice(const Catalogue&) {
    ProductChoice choice = volume_choice();
    choice.alone = &kSprayProduct;
    return choice;
}

VolumesOrSpray read_options(const BakeOptions& options, const Catalogue& catalogue) {
    const ChosenProducts chosen = choose_products(options, *product_choice(catalogue));
    if (!chosen.has(kSprayProduct)) return read_volumes(options, chosen);
    for (const char* const name : {"box", "voxel", "velocity-voxel", "mist", "type"}) {
        const std::string& value = options.format_option(name);
        if (value.empty()) continue;
        refuse("--" + std::string(name) + " " + value +
               ": only volumes have it, and spray is points");
    }
    return read_spray(options);
}

std::vector<const Product*> list_products(const BakePlan&, const VolumesOrSpray& settings) {
    if (spray_of(settings)) return {&kSprayProduct};
    return volume_products(volumes_of(settings));
}

FormatPlan<VolumesOrSpray> resolve(const BakePlan& draft, const VolumesOrSpray& requested) {
    if (spray_of(requested)) return {spray_maps(draft), requested};
    const VolumeSettings& volumes = volumes_of(requested);
    return {volume_maps(draft, volumes), resolve_volumes(draft, volumes)};
}

std::vector<BakeFile> list_files(const BakePlan& plan, const VolumesOrSpray& settings, int frame) {
    if (spray_of(settings)) return list_spray(plan, frame);
    return list_volumes(plan, volumes_of(settings), frame);
}

std::string recipe(const BakePlan& plan, const VolumesOrSpray& settings, const BakeFile& file) {
    if (const auto* spray = spray_of(settings)) return spray_recipe(plan, *spray, file);
    return volume_recipe(plan, volumes_of(settings), file);
}

bool is_baked(const BakeFile& file) {
    return !header_or_none(io::read_vdb_header, file.path).empty();
}

std::uint64_t frame_bytes(const BakePlan& plan, const VolumesOrSpray& settings) {
    const SprayPoints* const spray = spray_of(settings);
    if (spray == nullptr) return volume_frame_bytes(plan, volumes_of(settings));
    return spray_frame_bytes(plan, *spray) +
           2 * io::points_bytes(max_spray_points(plan, spray->settings));
}

/// Returns the cell of the points' grid [m], which is the cell of the spray's lattice, so that each
/// cell holds a few points.
double cell_of(const BakePlan& plan) {
    return spray_domain(plan).step(0);
}

std::uint64_t max_bytes(const BakePlan& plan, const VolumesOrSpray& settings, const BakeFile&) {
    const SprayPoints* const spray = spray_of(settings);
    if (spray == nullptr) return max_volume_bytes(plan, volumes_of(settings));
    // Counts the leaves where spray is born, and the margin into which the wind carries it, in four
    // layers.
    constexpr double kMaxSpeed = 60.0;  // [m/s]
    const Domain born = spray_domain(plan);
    const double leaf = 8.0 * born.step(0);
    const auto leaves = [&](std::size_t axis) {
        return born.size[axis] / leaf + 2.0 + 2.0 * kMaxSpeed * spray->settings.lifetime / leaf;
    };
    return 2 * plan.subject_text.size() + 8192 +
           io::points_vdb_bytes(max_spray_points(plan, spray->settings),
                                static_cast<std::uint64_t>(4.0 * leaves(0) * leaves(1)));
}

void write(const FrameWork& work, const VolumesOrSpray& settings, std::span<const BakeFile> files) {
    const SprayPoints* const spray = spray_of(settings);
    if (spray == nullptr) return write_volumes(work, volumes_of(settings), files);
    const io::VdbGrid points = io::make_points(make_spray_points(work, *spray), cell_of(work.plan));
    work.write_and_verify(files.front(), [&] {
        io::write_vdb({&points, 1}, spray_strings(work.plan, *spray, work.frame), false,
                      files.front().path);
    });
}

void adopt(const BakedHeader& header, const Catalogue&, BakeOptions& options) {
    options.set_default("products", header.text("field"));
    options.set_default("axes", header.text("axes"));
    if (header.text("field") == kSprayProduct.name) {
        adopt_spray(header, options);  // no other product was given
    } else {
        adopt_volumes(header, options);
    }
}

constexpr BakeFormatOf<VolumesOrSpray> kOf = {
    .name = "vdb",
    .extension = ".vdb",
    .label = "VDB",
    .family = "Volumes VDB",
    .summary = "OpenVDB volumes of water, or points of spray",
    .example = "--products surface,vel --voxel 1",
    .library_bytes = 28 << 20,  // half of OpenVDB's 56 MB is used [measured]
    .options = list_options,
    .product_choice = product_choice,
    .read_options = read_options,
    .products = list_products,
    .resolve = resolve,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .frame_bytes = frame_bytes,
    .max_bytes = max_bytes,
    .write = write,
    .read_header = io::read_vdb_header,
    .adopt = adopt,
};

}  // namespace

const BakeFormat kVdbFormat = bake_format<kOf>();

}  // namespace ocean
