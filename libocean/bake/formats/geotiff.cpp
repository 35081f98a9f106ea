// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// GeoTIFF: the heights of a terrain as floats for GIS programs, with cell, origin and provenance.
#include "ocean/internal/io/geotiff.hpp"

#include "formats/formats.hpp"
#include "ocean/bake/typed_format.hpp"

namespace ocean {
namespace {

NoSettings read_options(const BakeOptions&, const Catalogue&) {
    return {};
}

FormatPlan<NoSettings> resolve(const BakePlan& draft, const NoSettings&) {
    return {{{Channel::height}, {draft.resolution}}, {}};
}

std::vector<BakeFile> list_files(const BakePlan& plan, const NoSettings&, int frame) {
    return {{plan.pattern.file(frame), frame, 0, "height"}};
}

std::string recipe(const BakePlan& plan, const NoSettings&, const BakeFile& file) {
    return bake_recipe(plan, file.frame);
}

bool is_baked(const BakeFile& file) {
    return !header_or_none(io::read_geotiff_header, file.path).empty();
}

std::uint64_t frame_bytes(const BakePlan& plan, const NoSettings&) {
    return io::max_geotiff_bytes(plan.domain());  // the file is made in memory
}

std::uint64_t max_bytes(const BakePlan& plan, const NoSettings&, const BakeFile&) {
    return 2 * plan.subject_text.size() + io::max_geotiff_bytes(plan.domain());
}

void write(const FrameWork& work, const NoSettings&, std::span<const BakeFile> files) {
    const io::Image image = height_image(work);
    const std::string& path = files.front().path;
    work.write_and_verify(files.front(), [&] { io::write_geotiff(image, path); });
}

bool read_pixels(const BakePlan& plan, const NoSettings&, const BakeFile& file, int,
                 const io::ByteSink& sink) {
    io::read_geotiff(file.path, plan.domain(), sink);
    return true;
}

constexpr BakeFormatOf<NoSettings> kOf = {
    .name = "geotiff",
    .extension = ".tif",
    .label = "GeoTIFF",
    .family = "GeoTIFF",
    .summary = "GeoTIFF of a terrain: heights as floats, for GIS",
    .holds_displaced = false,
    .read_options = read_options,
    .resolve = resolve,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .frame_bytes = frame_bytes,
    .max_bytes = max_bytes,
    .write = write,
    .read_pixels = read_pixels,
    .read_header = io::read_geotiff_header,
};

}  // namespace

const BakeFormat kGeotiffFormat = bake_format<kOf>();

}  // namespace ocean
