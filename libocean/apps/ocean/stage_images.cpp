// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See stage_images.hpp.
#include "stage_images.hpp"

#include <algorithm>
#include <string_view>

#include "console.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/gl/stages.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/io/exr.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"

namespace ocean::app {
namespace {

constexpr std::string_view kStageString = "ocean:stage";

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

bool is_stage(const std::string& path) {
    try {
        const auto header = io::read_exr_header(path);
        return std::ranges::any_of(header,
                                   [](const auto& string) { return string.name == kStageString; });
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

void bake_stage(const BakePlan& plan, const std::string& stage, const Context& context) {
    const Sea& sea = sea_of(*plan.subject);
    Ocean ocean(sea, {.threads = plan.threads});
    io::make_folder(plan.pattern.folder());
    gl::StageMaker stages;
    std::vector<std::vector<float>> planes;
    for (const int frame : plan.frames) {
        const double time = sea.time_of(frame);
        const MapModes modes = map_modes(ocean.modes(time), time, plan.resolution);
        io::Image image = image_of(stages.make(modes, stage, ocean.pool()), planes);
        image.provenance = provenance_of(plan, frame);
        image.strings = {{std::string(kStageString), stage}};
        const std::string path = plan.pattern.file(frame);
        io::refuse_to_replace_foreign_file(path, "`ocean bake --stage`",
                                           [&] { return is_stage(path); });
        io::write_exr(image, path, io::ExrCompression::none, plan.threads);
        context.console.data(path + "\n");
    }
}

}  // namespace ocean::app
