// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What lies around the frames of a folder for POV-Ray; see povray_folder.hpp.
#include "ocean/bake/povray_folder.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ocean/foam_texture.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/io/mesh2.hpp"
#include "ocean/io/png.hpp"
#include "ocean/io/povray_declarations.hpp"
#include "ocean/ocean.hpp"
#include "ocean/text.hpp"
#include "ocean/thread_pool.hpp"
#include "povray_macros.hpp"

namespace ocean {
namespace {

std::string animation_settings(const io::PovrayFolder& folder) {
    const bool own_numbers = folder.frames_are_consecutive();
    const int first = own_numbers ? folder.frames.front() : 1;
    const int last = own_numbers ? folder.frames.back() : static_cast<int>(folder.frames.size());
    std::string text =
        "; All frames of this folder: povray ocean.ini\n"
        "; One of them: povray ocean.ini +SF2 +EF2; another size: povray ocean.ini +W640 +H360\n"
        "Input_File_Name=scene.pov\n"
        "Library_Path=.\n"
        "Width=960\nHeight=540\n"
        "Antialias=on\nAntialias_Threshold=0.1\nAntialias_Depth=2\n"
        "Display=off\n";
    text += format_text("Initial_Frame=%d\nFinal_Frame=%d\n", first, last);
    const Sea& sea = folder.sea;
    const int fps = static_cast<int>(std::lround(sea.parameters.time.fps));
    text += format_text("; clock is in seconds, at %d frames a second\n", fps);
    text += format_text("Initial_Clock=%.9g\nFinal_Clock=%.9g\n",
                        sea.time_of(folder.frames.front()), sea.time_of(folder.frames.back()));
    return text;
}

/// The same in all folders, for all frames: 3 MB. Texels of lace are of 12 mm.
std::string foam_image(FoamTextureKind kind, ThreadPool& pool) {
    const FoamTextureSettings settings{kind, kind == FoamTextureKind::lace ? 1024 : 512};
    const std::vector<float> texture = make_foam_texture(settings, pool);
    std::vector<std::uint16_t> grey(texture.size());
    std::ranges::transform(texture, grey.begin(), [](float value) {
        return static_cast<std::uint16_t>(std::lround(value * 65535.0f));
    });
    return io::grey_png(settings.size, settings.size, grey);
}

}  // namespace

std::string FolderFile::opening() const {
    // Signature, size, depth and colour of an image; of a text the first line, up to what it
    // counts.
    if (name.ends_with(".png")) return text.substr(0, 33);
    return text.substr(0, text.find_first_of("\n0123456789"));
}

std::vector<FolderFile> povray_folder_files(const BakePlan& plan, const std::vector<int>& frames) {
    const Sea& sea = plan.sea;
    const SeaState state = Ocean(sea.parameters, {.threads = plan.threads}).state();
    const io::PovrayFolder folder{sea,    state,       plan.format->name, plan.maps.resolutions,
                                  frames, plan.sea_id, plan.maps.finer};
    std::vector<FolderFile> files = {
        {"ocean.inc", std::string(kOceanInc)},
        {"ocean_parameters.inc", io::povray_declarations(folder)},
        {"ocean.ini", animation_settings(folder)},
        {"sea.toml", "# The sea of this folder, by `ocean povray`.\n" + plan.sea_text},
        {"scene.pov", std::string(kScenePov), true},
    };
    // Of larger maps the macros make them: the text would be 220 MB at 2048.
    if (plan.format->name == "df3" && plan.resolution <= 1024) {
        files.push_back({"faces.inc", io::povray_faces(io::patch_triangles(plan.resolution))});
    }
    if (plan.format->name == "df3") {
        ThreadPool pool(plan.threads);
        for (const FoamTextureInfo& info : kFoamTextures) {
            files.push_back(
                {"foam_" + std::string(info.name) + ".png", foam_image(info.kind, pool)});
        }
    }
    return files;
}

}  // namespace ocean
