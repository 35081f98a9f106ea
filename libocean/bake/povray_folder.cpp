// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See povray_folder.hpp.
#include "ocean/internal/bake/povray_folder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "complete_file.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/foam_texture.hpp"
#include "ocean/internal/io/mesh2.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/io/povray_declarations.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/seafile.hpp"
#include "ocean/thread_pool.hpp"
#include "povray_macros.hpp"

namespace ocean {
namespace {

/// Returns the settings of POV-Ray's frame counter and clock. A frame has its number in the sea,
/// and the clock is its time [s].
std::string frame_settings(const Sea& sea, const std::vector<int>& frames) {
    const auto lines = [&](const char* names, int first, int last) {
        return format_text(names, first, last, sea.time_of(first), sea.time_of(last));
    };
    // POV-Ray has no frames below 0.
    const auto shown = std::ranges::lower_bound(frames, 0);
    const auto count = frames.end() - shown;
    if (frames.size() == 1 && frames.front() <= 1) {
        // Without an animation the picture has no number.
        return (frames.front() == 1 ? "Initial_Frame=1\nFinal_Frame=1\n" : "") +
               format_text("Clock=%.9g\n", sea.time_of(frames.front()));
    }
    if (count == 0) return "";
    const int first = *shown, last = frames.back();
    if (count == 1) {  // with one frame POV-Ray's clock is not a number
        return lines("Initial_Frame=%d\nFinal_Frame=%d\nInitial_Clock=%.9g\nFinal_Clock=%.9g\n",
                     first, first + 1) +
               format_text("Subset_End_Frame=%d\n", first);
    }
    std::string text = lines(
        "Initial_Frame=%d\nFinal_Frame=%d\nInitial_Clock=%.9g\nFinal_Clock=%.9g\n", first, last);
    const int step = common_step({shown, frames.end()});
    if (step > 1) text += format_text("Frame_Step=%d\n", step);
    return text;
}

std::string animation_settings(const Sea& sea, const std::vector<int>& frames) {
    const int one = std::max(frames.back(), 0);
    std::string text =
        "; All frames of this folder: povray ocean.ini\n" +
        format_text("; One of them: povray ocean.ini +SF%d +EF%d; another size: ", one, one) +
        "povray ocean.ini +W640 +H360\n"
        "Input_File_Name=scene.pov\n"
        "Library_Path=.\n";
    text += kPovrayPicture;
    text += "; Frames: " + frames_text(frames) + ". At one that is not there POV-Ray stops.\n";
    if (frames.front() < 0 && frames.size() > 1) {
        text += "; POV-Ray has no frames below 0: a scene shows one by Ocean_Frame_Name(" +
                std::to_string(frames.front()) + ").\n";
    }
    text +=
        format_text("; clock is in seconds, at %.9g frames a second\n", sea.parameters.time.fps);
    return text + frame_settings(sea, frames);
}

/// Returns the words in the header of a texture's file. They differ from the words that `ocean
/// foam-texture` writes, which does not replace these files.
HeaderString foam_words(const FoamTextureSettings& settings) {
    return {"ocean:povray_foam",
            format_text("%s, %d texels, seed %u, edition %d",
                        std::string(foam_texture_info(settings.kind).name).c_str(), settings.size,
                        settings.seed, kFoamTextureEdition)};
}

std::string name_of(FoamTextureKind kind) {
    return "foam_" + std::string(foam_texture_info(kind).name) + ".png";
}

/// Returns the bytes of the file with these words in its header; "" if the path has no such file or
/// an incomplete one.
std::string read_foam_image(const std::string& path, const HeaderString& words) {
    constexpr std::size_t kLimit = std::size_t{16} << 20;
    constexpr std::string_view kLastChunk("\0\0\0\0IEND\xae\x42\x60\x82", 12);  // [PNG 1.2] 4.1.4
    try {
        const auto is_same = [&words](const HeaderString& found) {
            return found.name == words.name && found.text == words.text;
        };
        if (std::ranges::none_of(io::read_png_header(path), is_same)) return "";
        std::string bytes = text::read_file(path, kLimit);
        return bytes.ends_with(kLastChunk) ? bytes : "";
    } catch (const Error&) {  // no such file, or a foreign one, refused when replaced
        return "";
    }
}

/// Returns a PNG that is equal for all folders and frames: 3 MB together. A texel of lace measures
/// 12 mm. The textures take a second to make, so that textures in the folder or the cache are used
/// again.
std::string foam_image(FoamTextureKind kind, const FoamImages& places, ThreadPool& pool) {
    const FoamTextureSettings settings{kind, kind == FoamTextureKind::lace ? 1024 : 512};
    const HeaderString words = foam_words(settings);
    const std::string name = name_of(kind);
    if (std::string present = read_foam_image(places.folder + "/" + name, words);
        !present.empty()) {
        return present;
    }
    const std::string cached = places.cache.empty() ? "" : places.cache + "/" + name;
    if (std::string present = read_foam_image(cached, words); !present.empty()) return present;
    const std::vector<float> texture = make_foam_texture(settings, pool);
    std::vector<std::uint16_t> grey(texture.size());
    std::ranges::transform(texture, grey.begin(), [](float value) {
        return static_cast<std::uint16_t>(std::lround(value * 65535.0f));
    });
    std::string made =
        io::with_png_strings(io::grey_png(settings.size, settings.size, grey), {{words}});
    try {
        if (!cached.empty()) io::write_output(cached, made);
    } catch (const Error&) {
        return made;  // if the disk refuses, the next folder takes a second longer
    }
    return made;
}

}  // namespace

std::string FolderFile::opening() const {
    // Compares signature, size, depth and colour of an image; or the first line of a text, up to
    // its first number.
    if (name.ends_with(".png")) return text.substr(0, 33);
    if (name.ends_with(".df3")) return "";  // of any size; the text beside it is ours
    return text.substr(0, text.find_first_of("\n0123456789"));
}

ExistingFrames povray_existing_frames(const BakePlan& plan) {
    return find_frames(plan, [&plan](std::span<const BakeFile> files) {
        constexpr std::size_t kHead = 4096;  // the declarations begin the file
        return std::ranges::all_of(files, is_regular) &&
               io::declares_sea(text::first_bytes(files.back().path, kHead), plan.subject_id);
    });
}

std::vector<FolderFile> povray_frame_lists(const BakePlan& plan, const SeaState& state,
                                           const std::vector<int>& frames) {
    const io::PovrayFolder folder{sea_of(*plan.subject), state,          plan.format->name,
                                  plan.maps.resolutions, frames,         frames_text(frames),
                                  plan.subject_id,       plan.maps.finer};
    return {{"ocean_parameters.inc", io::povray_declarations(folder)},
            {"ocean.ini", animation_settings(sea_of(*plan.subject), frames)}};
}

std::vector<FolderFile> povray_folder_files(const BakePlan& plan, const SeaState& state,
                                            const std::vector<int>& frames,
                                            const FoamImages& foam) {
    std::vector<FolderFile> files = {{"ocean.inc", std::string(kOceanInc)}};
    std::ranges::move(povray_frame_lists(plan, state, frames), std::back_inserter(files));
    files.push_back(
        {"sea.toml", "# The sea of this folder, by `ocean povray`.\n" + plan.subject_text});
    files.push_back({"scene.pov", std::string(kScenePov), true});
    // The macros make the faces of larger maps, because the text would be 220 MB at 2048 samples.
    if (plan.format->name == "df3" && plan.resolution <= 1024) {
        files.push_back({"faces.inc", io::povray_faces(io::patch_triangles(plan.resolution))});
    }
    if (plan.format->name == "df3") {
        ThreadPool pool(plan.threads);
        for (const FoamTextureInfo& info : kFoamTextures) {
            files.push_back({name_of(info.kind), foam_image(info.kind, foam, pool)});
        }
    }
    return files;
}

}  // namespace ocean
