// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps for POV-Ray as density files:
//   sea_0001.df3         the map of a frame
//   sea_0001_far1.df3    and so on: coarser maps, for the sea to the horizon
//   sea_0001_fine.df3    position at twice the samples, for floating objects: a wave of two samples
//                        cannot be interpolated, one of four can
//   sea_0001_detail.df3  slopes of the waves too short for the map, for the light of near water
//   land_masks.df3       masks of a land, a byte each
//   sea_0001.df3.inc     their description for a scene; a density file holds no text
#include "ocean/internal/io/df3.hpp"

#include <algorithm>

#include "formats/formats.hpp"
#include "ocean/bake/typed_format.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/povray_declarations.hpp"
#include "ocean/internal/io/subject_words.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"

namespace ocean {
namespace {

std::vector<FormatOption> list_options(const Catalogue&) {
    return {
        {"far-maps", "", "Write coarser maps beside that of each frame, a third more data"},
        {"fine-map", "",
         "Write height and displacement at twice the samples too, for exact heights of places, "
         "twice the data; not if its shortest wave has 4 samples",
         "", kSeaKind},
        {"detail-map", "",
         "Write slope tiles of the waves too short for the map beside each frame, at most a third "
         "of its data from 512 samples on",
         "", kSeaKind},
        {"mask-map", "",
         "Write the masks of a land too, such as beach and cliff, or those of a sea's region, such "
         "as wetness, a byte each; not flow, an area, or depth"}};
}

struct Df3Settings {
    bool far_maps = false;
    bool fine_map = false;
    bool detail_map = false;
    bool mask_map = false;
    DetailSettings detail = {};
    int detail_bands = 0;             // bands in the file; 0: no file
    io::Df3Slices slices = {};        // slices of the subject's maps
    std::vector<Channel> masks = {};  // masks in the file; empty: no file
};

Df3Settings read_options(const BakeOptions& options, const Catalogue&) {
    return {!options.format_option("far-maps").empty(), !options.format_option("fine-map").empty(),
            !options.format_option("detail-map").empty(),
            !options.format_option("mask-map").empty()};
}

/// Returns the samples along a side of the fine map, or 0 if the map itself is fine enough.
int fine_resolution(const BakePlan& draft) {
    constexpr int kMaxFineSamples = 4096;  // 200 MB
    const double shortest = draft.shortest_wave();
    const double cell = draft.subject->domain(draft.resolution).step(0);
    const int fine = 2 * draft.resolution;
    return shortest < 4.0 * cell && fine <= kMaxFineSamples ? fine : 0;
}

FormatPlan<Df3Settings> resolve(const BakePlan& draft, const Df3Settings& requested) {
    Df3Settings settings = requested;
    settings.slices = io::df3_slices(draft.subject->kind());
    FrameMaps maps{io::df3_channels(settings.slices), {draft.resolution}};
    if (settings.far_maps) maps.resolutions = halving_resolutions(draft.resolution);
    if (settings.fine_map) {
        maps.finer = fine_resolution(draft);
        maps.finer_channels = io::df3_channels(io::df3_position_slices());
    }
    if (settings.detail_map) {
        // The tiles have as many samples as the map, so that both files grow in proportion.
        settings.detail = {draft.resolution, std::clamp(draft.resolution, kMinDetailSamples,
                                                        DetailSettings{}.samples)};
        settings.detail_bands = static_cast<int>(
            detail_bands(sea_of(*draft.subject).parameters, settings.detail).size());
    }
    if (settings.mask_map) {
        settings.masks = io::df3_masks(draft.subject->channels());
        if (settings.masks.empty() && draft.subject->kind() == kSeaKind) {
            throw Error(ErrorKind::unsupported,
                        "--mask-map: a sea without a bed (water.seabed) and hulls has no masks");
        }
        for (const Channel mask : settings.masks) maps.channels = maps.channels | ChannelSet{mask};
    }
    return {maps, settings};
}

/// Returns "sea_0001_fine.df3" for "sea_0001.df3" and "_fine".
std::string path_with(const std::string& path, std::string_view ending) {
    const std::size_t dot = path.rfind('.');
    return path.substr(0, dot) + std::string(ending) + path.substr(dot);
}

constexpr std::string_view kMasksEnding = "_masks";

bool is_masks(const BakeFile& file) {
    return file.path.ends_with(std::string(kMasksEnding) + ".df3");
}

bool is_fine(const BakePlan& plan, const BakeFile& file) {
    return plan.maps.finer > 0 && file.part == plan.maps.resolutions.size();
}

std::vector<BakeFile> list_files(const BakePlan& plan, const Df3Settings& settings, int frame) {
    const std::string path = plan.pattern.file(frame);
    std::vector<BakeFile> files;
    for (std::size_t part = 0; part < plan.maps.resolutions.size(); ++part) {
        const std::string far = "_far" + std::to_string(part);
        files.push_back({part == 0 ? path : path_with(path, far), frame, part, "map"});
    }
    if (plan.maps.finer > 0) {
        files.push_back({path_with(path, "_fine"), frame, files.size(), "map"});
    }
    if (settings.detail_bands > 0) {
        files.push_back({path_with(path, "_detail"), frame, files.size(), "map"});
    }
    if (!settings.masks.empty()) {
        files.push_back({path_with(path, kMasksEnding), frame, files.size(), "map"});
    }
    files.push_back({path + ".inc", frame, files.size(), "map"});
    return files;
}

std::string recipe(const BakePlan& plan, const Df3Settings& settings, const BakeFile& file) {
    if (!file.path.ends_with(".inc")) return bake_recipe(plan, file.frame);
    std::string lines = "maps " + std::to_string(plan.maps.resolutions.size()) + "\ndetail " +
                        std::to_string(settings.detail_bands) + "\n";
    if (settings.mask_map) lines += "masks\n";
    return bake_recipe(plan, file.frame, lines);
}

constexpr std::string_view kOpening = "// A frame for POV-Ray";

bool is_our_text(const std::string& path) {
    return text::first_bytes(path, kOpening.size()) == kOpening;
}

/// Returns true if a text of ours lies beside a map, also if the map's name is a frame's with an
/// ending, such as land_far1.df3.
bool has_our_text(const std::string& path) {
    const std::size_t ending = path.rfind('_'), dot = path.rfind('.');
    if (is_our_text(path + ".inc")) return true;
    return ending < dot && is_our_text(path.substr(0, ending) + path.substr(dot) + ".inc");
}

/// Recognises a square map with the slices of a map, of a position, or two for each slope tile; any
/// map of a land beside its text; and texts with our opening.
bool is_baked(const BakeFile& file) {
    if (file.path.ends_with(".inc")) {
        return is_our_text(file.path);
    }
    const std::string head = text::first_bytes(file.path, 6);
    if (head.size() < 6) return false;
    const auto size_at = [&head](std::size_t i) {
        return static_cast<unsigned char>(head[i]) << 8 | static_cast<unsigned char>(head[i + 1]);
    };
    const auto slices = static_cast<std::size_t>(size_at(4));
    // A subject that is not displaced has as many slices as a position, and may be a rectangle.
    if (slices == io::df3_slices(kTerrainKind).size() && size_at(0) % kMinResolution == 0 &&
        size_at(2) % kMinResolution == 0) {
        return true;
    }
    if (has_our_text(file.path)) return true;
    return size_at(0) == size_at(2) && is_resolution(size_at(0)) &&
           (slices == io::df3_slices(kSeaKind).size() ||
            (slices % 2 == 0 && slices <= std::size_t{2 * kMaxDetailBands}));
}

std::uint64_t max_bytes(const BakePlan& plan, const Df3Settings& settings, const BakeFile& file) {
    constexpr std::uint64_t kTextBytes = 4096;
    const std::vector<int>& maps = plan.maps.resolutions;
    if (file.part < maps.size()) {
        return io::df3_bytes(plan.subject->domain(maps[file.part]), settings.slices.size());
    }
    if (is_masks(file)) return io::masks_df3_bytes(plan.domain(), settings.masks.size());
    if (is_fine(plan, file))
        return io::df3_bytes(plan.maps.finer, io::df3_position_slices().size());
    if (file.path.ends_with(".inc")) return kTextBytes;
    return io::slopes_df3_bytes(settings.detail.samples, settings.detail_bands);
}

std::uint64_t frame_bytes(const BakePlan& plan, const Df3Settings& settings) {
    if (settings.detail_bands == 0) return 0;
    return detail_bytes(sea_of(*plan.subject).parameters, settings.detail, plan.backend) +
           maps_bytes(settings.detail.samples, 2 * settings.detail_bands);
}

/// Returns the declaration of three heights, by which a scene checks that text and map belong to
/// one frame.
std::string check_heights(const Surface& map, const std::string& prefix) {
    const int width = map.domain().samples[0], height = map.domain().samples[1];
    const auto height_at = [&](int i, int j) {
        const auto place = static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                           static_cast<std::size_t>(i);
        return shortest_text(static_cast<double>(map.channel(Channel::height)[place]));
    };
    return "#declare " + prefix + "Frame_Heights_ = array[3] { " + height_at(0, 0) + ", " +
           height_at(width / 2, height / 4) + ", " + height_at(width / 4, height / 2) +
           " };  // m, at <0, 0>, <1/2, 1/4>, <1/4, 1/2> periods\n";
}

/// Returns the declaration of the codes of a height in its own range; "" for a sea.
std::string height_codes(const Surface& map, io::Df3Slices slices, const std::string& prefix) {
    if (slices.front().code != io::Df3Code::range) return "";
    const io::Df3Heights heights = io::df3_heights(map);
    return "#declare " + prefix + "Base_ = " + shortest_text(heights.base) +
           ";  // m, the minimal height\n#declare " + prefix +
           "Scale_ = " + shortest_text(heights.scale) + ";  // m, a height is right to " +
           shortest_text(0.5 * heights.quantum()) + " m\n";
}

/// Returns the declarations of a land's maps: their levels, the codes of their heights, and the
/// slice of each mask, -1 for a missing one.
std::string land_maps(const FrameWork& work, const Df3Settings& settings,
                      const std::string& prefix) {
    const auto levels = work.maps.first(work.plan.maps.resolutions.size());
    const std::string count = std::to_string(levels.size());
    std::string cells, codes;
    for (const Surface& map : levels) {
        const Domain& domain = map.domain();
        const char* const separator = cells.empty() ? "" : ", ";
        const io::Df3Heights heights = io::df3_heights(map);
        cells += separator +
                 ("<" + shortest_text(domain.step(0)) + ", " + std::to_string(domain.samples[0]) +
                  ", " + std::to_string(domain.samples[1]) + ">");
        codes += separator +
                 ("<" + shortest_text(heights.base) + ", " + shortest_text(heights.scale) + ", 0>");
    }
    return "#declare " + prefix + "Levels_ = array[" + count + "] { " + cells +
           " };  // cell [m], columns, rows of each map\n#declare " + prefix +
           "Level_Codes_ = array[" + count + "] { " + codes + " };  // base and scale [m]\n" +
           io::povray_mask_declarations(settings.masks, prefix);
}

/// Returns the text beside the maps of a frame.
std::string description(const FrameWork& work, const Df3Settings& settings, const Detail& detail) {
    const Surface& map = work.maps.front();
    const std::string_view kind = work.plan.subject->kind();
    const std::string prefix = io::subject_words(kind).prefix();
    const bool is_sea = kind == kSeaKind;
    std::string text =
        std::string(kOpening) + (is_sea ? ": what Ocean_Load of ocean.inc asks for.\n"
                                        : ": the data that " + prefix + "Load reads.\n");
    text += io::povray_frame_declarations(work.provenance()) + check_heights(map, prefix) +
            height_codes(map, settings.slices, prefix);
    if (!is_sea) return text + land_maps(work, settings, prefix);
    if (!settings.masks.empty()) {
        text += io::povray_mask_declarations(settings.masks, prefix + "Coast_");
    }
    const auto levels = work.maps.first(work.plan.maps.resolutions.size());
    return text + io::povray_foam_declarations(levels) + io::povray_detail_declarations(detail);
}

void write(const FrameWork& work, const Df3Settings& settings, std::span<const BakeFile> files) {
    for (const BakeFile& file : files.first(work.maps.size())) {
        const io::Df3Slices slices =
            is_fine(work.plan, file) ? io::df3_position_slices() : settings.slices;
        work.write_and_verify(file,
                              [&] { io::write_df3(work.maps[file.part], file.path, slices); });
    }
    Detail detail;
    if (settings.detail_bands > 0) {
        detail = ocean_of(work.source).detail(work.time(), settings.detail);
        const BakeFile& file = files[work.maps.size()];
        work.write_and_verify(file, [&] { io::write_slopes_df3(detail, file.path); });
    }
    if (!settings.masks.empty()) {
        const BakeFile& file = files[files.size() - 2];
        work.write_and_verify(
            file, [&] { io::write_masks_df3(work.maps.front(), settings.masks, file.path); });
    }
    work.write_and_verify(files.back(), [&] {
        io::write_file_atomically(files.back().path, description(work, settings, detail));
    });
}

constexpr BakeFormatOf<Df3Settings> kOf = {
    .name = "df3",
    .extension = ".df3",
    .label = "DF3",
    .family = "DF3 files",
    .summary = "POV-Ray density files: height, offsets, foam",
    .example = "--far-maps",
    .options = list_options,
    .read_options = read_options,
    .resolve = resolve,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .frame_bytes = frame_bytes,
    .max_bytes = max_bytes,
    .write = write,
};

}  // namespace

const BakeFormat kDf3Format = bake_format<kOf>();

}  // namespace ocean
