// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenVDB: volumes of the water in a box, or the points of spray.
#include "ocean/io/vdb.hpp"

#include "formats/formats.hpp"
#include "formats/spray_points.hpp"
#include "formats/volumes.hpp"
#include "ocean/error.hpp"
#include "ocean/sea_subject.hpp"
#include "source.hpp"

namespace ocean {
namespace {

std::vector<FormatOption> list_options(const Catalogue&) {
    std::vector<FormatOption> options = volume_options();
    for (FormatOption& option : spray_options()) options.push_back(std::move(option));
    return options;
}

std::any read_options(const BakeOptions& options, const Catalogue&) {
    ProductChoice choice = volume_choice();
    choice.alone = &kSprayProduct;
    const ChosenProducts chosen = choose_products(options, choice);
    if (!chosen.has(kSprayProduct)) return read_volumes(options, chosen);
    for (const char* const name : {"box", "voxel", "velocity-voxel", "mist", "type"}) {
        const std::string& value = options.format_option(name);
        if (value.empty()) continue;
        throw Error(ErrorKind::invalid_value,
                    "--" + std::string(name) + " " + value + ": is of volumes, spray is points");
    }
    return read_spray(options);
}

std::vector<const Product*> list_products(const BakePlan& begun) {
    return spray_of(begun) != nullptr ? std::vector{&kSprayProduct} : volume_products(begun);
}

FormatPlan settle(const BakePlan& begun) {
    return spray_of(begun) != nullptr ? settle_spray(begun) : settle_volumes(begun);
}

std::vector<BakeFile> list_files(const BakePlan& plan, int frame) {
    return spray_of(plan) != nullptr ? list_spray(plan, frame) : list_volumes(plan, frame);
}

std::string recipe(const BakePlan& plan, const BakeFile& file) {
    return spray_of(plan) != nullptr ? spray_recipe(plan, file) : volume_recipe(plan, file);
}

bool is_baked(const BakeFile& file) {
    try {
        return !io::read_vdb_header(file.path).empty();
    } catch (const Error&) {
        return false;
    }
}

std::uint64_t frame_bytes(const BakePlan& plan) {
    if (spray_of(plan) == nullptr) return volume_frame_bytes(plan);
    return spray_frame_bytes(plan) + 2 * io::points_bytes(most_spray_points(plan));
}

/// Of the points' grid, m: that of the spray's lattice, so that a cell has a few.
double cell_of(const BakePlan& plan) {
    const Lattice lattice = spray_lattice(sea_of(*plan.subject).parameters.grid);
    return lattice.period / lattice.resolution;
}

std::uint64_t most_bytes(const BakePlan& plan, const BakeFile&) {
    const SprayPoints* const spray = spray_of(plan);
    if (spray == nullptr) return most_volume_bytes(plan);
    // The period and what the wind carries out of it, in four layers.
    constexpr double kFastest = 60.0;  // m/s
    const double leaf = 8.0 * cell_of(plan);
    const double side =
        plan.domain().size[0] / leaf + 2.0 + 2.0 * kFastest * spray->settings.lifetime / leaf;
    return 2 * plan.subject_text.size() + 8192 +
           io::points_vdb_bytes(most_spray_points(plan),
                                static_cast<std::uint64_t>(4.0 * side * side));
}

void write(const FrameWork& work, std::span<const BakeFile> files) {
    if (spray_of(work.plan) == nullptr) {
        write_volumes(work, files);
        return;
    }
    const io::VdbGrid points = io::make_points(make_spray_points(work), cell_of(work.plan));
    work.put(files.front(), [&] {
        io::write_vdb({&points, 1}, spray_strings(work.plan, work.frame), false,
                      files.front().path);
    });
}

void adopt(const BakedHeader& header, const Catalogue&, BakeOptions& options) {
    options.take("products", header.text("field"));
    options.take("axes", header.text("axes"));
    if (header.text("field") == kSprayProduct.name) {
        adopt_spray(header, options);  // unless another product was typed
    } else {
        adopt_volumes(header, options);
    }
}

}  // namespace

const BakeFormat kVdbFormat = {
    .name = "vdb",
    .extension = ".vdb",
    .family = "Volumes VDB",
    .options = list_options,
    .read_options = read_options,
    .products = list_products,
    .settle = settle,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .frame_bytes = frame_bytes,
    .most_bytes = most_bytes,
    .write = write,
    .read_header = io::read_vdb_header,
    .adopt = adopt,
};

}  // namespace ocean
