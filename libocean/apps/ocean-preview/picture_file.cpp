// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "picture_file.hpp"

#include <array>
#include <filesystem>
#include <system_error>
#include <vector>

#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/preview/canvas.hpp"
#include "ocean/io/exr.hpp"

namespace ocean::app {
namespace {

/// rgba: row after row, the bottom row first.
void write_light(const std::string& path, int width, int height, const std::vector<float>& rgba) {
    io::Image image;
    image.width = width;
    image.height = height;
    std::array<std::vector<float>, 3> channels;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        channels[c].reserve(rgba.size() / 4);
        for (std::size_t i = c; i < rgba.size(); i += 4) channels[c].push_back(rgba[i]);
        image.planes.push_back({.name = std::string(1, "RGB"[c]), .samples = channels[c]});
    }
    io::write_exr(image, path, io::ExrCompression::zip);
}

}  // namespace

void require_picture_name(const std::string& path, const std::string& option) {
    const std::string extension = OutputPattern(path).extension();
    if (extension == ".png" || extension == ".exr") return;
    throw Error(ErrorKind::invalid_value, option + ": '" + path + "' does not end in .png or .exr");
}

void require_picture_folder(const std::string& path) {
    const std::filesystem::path folder = utf8_path(path).parent_path();
    std::error_code unreadable;
    if (folder.empty() || std::filesystem::is_directory(folder, unreadable)) return;
    throw Error(ErrorKind::output,
                "cannot write '" + path + "': there is no folder " + text::to_utf8(folder));
}

void write_picture(const std::string& path, preview::Renderer& renderer, const Scene& scene,
                   const preview::Camera& camera, const preview::Look& look,
                   preview::DrawOptions options, int samples) {
    options.linear = OutputPattern(path).extension() == ".exr";
    const preview::Canvas canvas(options.width, options.height,
                                 options.linear ? GL_RGBA32F : GL_RGBA8, samples);
    if (scene.is_finer_than_pixels()) options.shaded_samples = canvas.samples();
    scene.draw(renderer, camera, look, options);
    if (options.linear) {
        write_light(path, options.width, options.height, canvas.rgba());
    } else {
        io::write_png(path, options.width, options.height, canvas.rgb());
    }
}

}  // namespace ocean::app
