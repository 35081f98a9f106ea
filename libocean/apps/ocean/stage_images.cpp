// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Stages of the transform as EXR files; see stage_images.hpp.
#include "stage_images.hpp"

#include <filesystem>

#include "console.hpp"
#include "ocean/error.hpp"
#include "ocean/gl/stages.hpp"
#include "ocean/io/exr.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/ocean.hpp"
#include "ocean/platform.hpp"
#include "ocean/text.hpp"
#include "ocean/version.hpp"

namespace ocean::app {
namespace {

io::Image image_of(const gl::StageImage& stage, std::vector<std::vector<float>>& planes) {
    io::Image image;
    image.width = stage.width;
    image.height = stage.height;
    planes.resize(stage.channels.size());
    for (std::size_t c = 0; c < planes.size(); ++c) {
        planes[c].clear();
        for (std::size_t i = c; i < stage.texels.size(); i += planes.size()) {
            planes[c].push_back(stage.texels[i]);
        }
        image.planes.push_back({.name = stage.channels[c], .samples = planes[c]});
    }
    return image;
}

/// What others wrote stays.
void require_own(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(utf8_path(path), ignored)) return;
    bool own = false;
    try {
        for (const io::HeaderString& string : io::read_exr_header(path)) {
            own = own || string.name == "ocean:stage";
        }
    } catch (const Error&) {
        own = false;
    }
    if (own) return;
    throw Error(
        ErrorKind::invalid_value,
        "'" + path + "' is there and is no stage that ocean wrote: it stays; take another -o");
}

}  // namespace

void bake_stage(const BakePlan& plan, const std::string& stage, const Context& context) {
    Ocean ocean(plan.sea, {.threads = plan.threads});
    io::make_folder(plan.pattern.folder());
    gl::StageMaker stages;
    std::vector<std::vector<float>> planes;
    for (const int frame : plan.frames) {
        const double time = plan.sea.time_of(frame);
        const MapModes modes = map_modes(ocean.modes(time), time, plan.resolution);
        io::Image image = image_of(stages.make(modes, stage, ocean.pool()), planes);
        image.strings = {{"ocean:frame", std::to_string(frame)},
                         {"ocean:sea", plan.sea_text},
                         {"ocean:stage", stage},
                         {"ocean:time", format_text("%.17g", time)},
                         {"ocean:version", OCEAN_VERSION}};
        const std::string path = plan.pattern.file(frame);
        require_own(path);
        io::write_exr(image, path, io::ExrCompression::none, plan.threads);
        context.console.data(path + "\n");
    }
}

}  // namespace ocean::app
