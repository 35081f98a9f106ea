// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps for POV-Ray as density files: one a frame and, for the sea to the horizon, coarser ones
// beside it, sea_0001_far1.df3 and so on. A density file has no room for words: sea_0001.df3.inc
// tells a scene what they are of.
#include "ocean/io/df3.hpp"
#include "formats/formats.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/checked_text.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/io/povray_declarations.hpp"
#include "ocean/text.hpp"

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
    files.push_back({path + ".inc", frame, plan.maps.resolutions.size(), "map"});
    return files;
}

std::string recipe(const BakePlan& plan, const BakeFile& file) {
    return bake_recipe(plan, file.frame);
}

constexpr std::string_view kOpening = "// A frame for POV-Ray";

/// A square of whole maps' size, six slices; or words that open as ours do.
bool is_baked(const BakeFile& file) {
    if (file.path.ends_with(".inc")) {
        return text::first_bytes(file.path, kOpening.size()) == kOpening;
    }
    const std::string head = text::first_bytes(file.path, 6);
    if (head.size() < 6) return false;
    const auto size_at = [&head](std::size_t i) {
        return static_cast<unsigned char>(head[i]) << 8 | static_cast<unsigned char>(head[i + 1]);
    };
    return size_at(0) == size_at(2) && is_resolution(size_at(0)) && size_at(4) == io::kDf3Slices;
}

std::uint64_t most_bytes(const BakePlan& plan, const BakeFile& file) {
    constexpr std::uint64_t kWords = 512;
    const std::vector<int>& maps = plan.maps.resolutions;
    return file.part < maps.size() ? io::df3_bytes(maps[file.part]) : kWords;
}

/// Three heights, so that words and map are known to be of one frame.
std::string witnesses(const Surface& map) {
    const auto height_at = [&map](int i, int j) {
        const auto place = static_cast<std::size_t>(j * map.resolution() + i);
        return shortest_text(static_cast<double>(map.channel(Channel::height)[place]));
    };
    const int half = map.resolution() / 2;
    return "#declare Ocean_Frame_Heights = array[3] { " + height_at(0, 0) + ", " +
           height_at(half, half / 2) + ", " + height_at(half / 2, half) +
           " };  // m, at <0, 0>, <1/2, 1/4>, <1/4, 1/2> periods\n";
}

void write(const FrameWork& work, std::span<const BakeFile> files) {
    for (const BakeFile& file : files.first(work.maps.size())) {
        work.put(file, [&] { io::write_df3(work.maps[file.part], file.path); });
    }
    work.put(files.back(), [&] {
        io::write_file_atomically(
            files.back().path,
            std::string(kOpening) + ": what Ocean_Load of ocean.inc asks for.\n" +
                io::povray_frame_declarations(work.label()) + witnesses(work.maps.front()));
    });
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
