// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps for POV-Ray as density files: one a frame and, for the sea to the horizon, coarser ones
// beside it, sea_0001_far1.df3 and so on.
#include "ocean/io/df3.hpp"
#include "formats/formats.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/checked_text.hpp"

namespace ocean {
namespace {

std::vector<FormatOption> list_options(const Catalogue&) {
    return {{"far-maps", "", "Coarser maps beside that of each frame, a third more data"}};
}

std::any read_options(const BakeOptions& options, const Catalogue&) {
    return !options.format_option("far-maps").empty();
}

FormatPlan settle(const BakePlan& begun) {
    const bool far_maps = std::any_cast<bool>(begun.settings);
    return {{io::df3_channels(),
             far_maps ? halving_resolutions(begun.resolution) : std::vector<int>{begun.resolution}},
            begun.settings};
}

/// "sea_0001.df3" -> "sea_0001_far1.df3".
std::string far_path(const std::string& path, std::size_t level) {
    const std::size_t dot = path.rfind('.');
    return path.substr(0, dot) + "_far" + std::to_string(level) + path.substr(dot);
}

std::vector<BakeFile> list_files(const BakePlan& plan, int frame) {
    const std::string path = plan.pattern.file(frame);
    std::vector<BakeFile> files;
    for (std::size_t part = 0; part < plan.maps.resolutions.size(); ++part) {
        files.push_back({part == 0 ? path : far_path(path, part), frame, part, "map"});
    }
    return files;
}

std::string recipe(const BakePlan& plan, const BakeFile& file) {
    return bake_recipe(plan, file.frame);
}

/// A square of whole maps' size, six slices.
bool is_baked(const BakeFile& file) {
    const std::string head = text::first_bytes(file.path, 6);
    if (head.size() < 6) return false;
    const auto size_at = [&head](std::size_t i) {
        return static_cast<unsigned char>(head[i]) << 8 | static_cast<unsigned char>(head[i + 1]);
    };
    return size_at(0) == size_at(2) && is_resolution(size_at(0)) && size_at(4) == io::kDf3Slices;
}

std::uint64_t most_bytes(const BakePlan& plan, const BakeFile& file) {
    return io::df3_bytes(plan.maps.resolutions[file.part]);
}

void write(const FrameWork& work, std::span<const BakeFile> files) {
    for (const BakeFile& file : files) {
        work.put(file, [&] { io::write_df3(work.maps[file.part], file.path); });
    }
}

}  // namespace

const BakeFormat kDf3Format = {
    .name = "df3",
    .extension = ".df3",
    .family = "DF3 files",
    .options = list_options,
    .read_options = read_options,
    .settle = settle,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .most_bytes = most_bytes,
    .write = write,
};

}  // namespace ocean
