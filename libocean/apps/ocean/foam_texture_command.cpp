// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean foam-texture`: writes textures of foam as images for other renderers.
#include "ocean/internal/foam_texture.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/io/exr.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean::app {
namespace {

constexpr std::string_view kFoamTextureKind = "foam_texture";

struct FoamTextureOptions {
    std::string kind;
    int size = FoamTextureSettings().size;
    std::string seed = std::to_string(FoamTextureSettings().seed);
    std::string output;
    std::string type;
};

std::uint32_t seed_of(const std::string& text) {
    std::uint32_t seed = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, seed);
    if (error == std::errc() && rest == end) return seed;
    refuse("--seed " + text + ": allowed is a whole number, 0 .. 4294967295");
}

/// Returns the type of an EXR file's samples that --type requests.
io::PixelType pixel_type(const std::string& type) {
    if (type.empty() || type == "half") return io::PixelType::half_float;
    if (type == "float") return io::PixelType::full_float;
    constexpr std::string_view kTypes[] = {"half", "float"};
    refuse("--type " + type + ": allowed are half, float" + did_you_mean(type, kTypes));
}

/// Returns true if the output is an EXR file, false for a PNG file.
bool is_exr(const FoamTextureOptions& options) {
    const std::filesystem::path extension = utf8_path(options.output).extension();
    if (extension == ".exr") return true;
    if (extension != ".png") {
        refuse("-o " + options.output + ": allowed are NAME.png and NAME.exr");
    }
    if (options.type.empty()) return false;
    refuse("--type " + options.type + ": only EXR files have it; a PNG file has 16 bits of grey");
}

io::Image image_of(const FoamTextureOptions& options, const FoamTextureSettings& settings,
                   const std::vector<float>& texture) {
    const FoamTextureInfo& info = foam_texture_info(settings.kind);
    const Domain domain = Domain::tile(info.period, settings.size);
    return {.width = settings.size,
            .height = settings.size,
            .domain = domain,
            .planes = {{.name = "Y", .type = pixel_type(options.type), .samples = texture}},
            .provenance = {.kind = std::string(kFoamTextureKind),
                           .text = std::string(info.name),
                           .domain = domain},
            .strings = {{"ocean:seed", std::to_string(settings.seed)}, {"ocean:unit", "1"}}};
}

void write_png(const io::Image& image, const std::string& path) {
    const std::span<const float> texture = image.planes.front().samples;
    std::vector<std::uint16_t> grey(texture.size());
    std::ranges::transform(texture, grey.begin(), [](float value) {
        return static_cast<std::uint16_t>(std::lround(value * 65535.0f));
    });
    const std::string png = io::grey_png(image.width, image.height, grey);
    io::write_file_atomically(path, io::with_png_strings(png, image.header_strings()));
}

bool is_foam_texture(const std::string& path) {
    try {
        const auto provenance = io::read_provenance(path);
        return provenance && provenance->kind == kFoamTextureKind;
    } catch (const Error&) {
        return false;
    }
}

void run(const FoamTextureOptions& options, const Context& context) {
    const FoamTextureSettings settings{find_foam_texture(options.kind), options.size,
                                       seed_of(options.seed)};
    require_foam_texture_size(settings.size);
    const bool exr = is_exr(options);
    pixel_type(options.type);
    const std::string folder = utf8_path(options.output).parent_path().string();
    io::require_folder(folder);
    io::refuse_to_replace_foreign_file(options.output, "`ocean foam-texture`",
                                       [&] { return is_foam_texture(options.output); });
    ThreadPool pool(context.options.threads);
    const std::vector<float> texture = make_foam_texture(settings, pool);
    const io::Image image = image_of(options, settings, texture);
    const auto hold = context.interrupts.hold();
    io::make_folder(folder);
    if (exr) {
        io::write_exr(image, options.output, io::ExrCompression::zip, context.options.threads);
    } else {
        write_png(image, options.output);
    }
    if (!context.options.quiet) context.console.data(options.output + "\n");
}

std::string footer() {
    std::string text =
        "Values are 0 .. 1: a point is white where the texture is below the cover of its\n"
        "foam. `texture < cover` holds on exactly the share `cover` of the area, with the\n"
        "bilinear interpolation of renderers as well; low values vanish last. Each kind\n"
        "has a tile of its own size, which repeats without a seam:\n";
    for (const FoamTextureInfo& info : kFoamTextures) {
        text += format_text("  %-8s %4s m  %s\n", std::string(info.name).c_str(),
                            shortest_text(info.period).c_str(), std::string(info.help).c_str());
    }
    return text +
           "Read it as data, not as a colour. The bottom row of the image is the south of\n"
           "the tile. The header has kind, tile, seed and version.";
}

}  // namespace

Command foam_texture_command() {
    auto options = std::make_shared<FoamTextureOptions>();
    return {
        .name = "foam-texture",
        .summary = "Write a texture of foam that tiles: lace, bubbles or streaks",
        .options = {{"Texture",
                     {{"KIND", &options->kind, "", "lace, bubbles or streaks", kRequired},
                      {"--size", &options->size, "N",
                       "Texels along a side, a power of two, 64 .. 4096; default 1024"},
                      {"--seed", &options->seed, "S", "Random seed, 0 .. 4294967295; default 1"}}},
                    {"Output",
                     {{"-o,--output", &options->output, "FILE",
                       "NAME.png (16 bits of grey) or NAME.exr (channel Y)", kRequired},
                      {"--type", &options->type, "TYPE",
                       "Sample type of EXR files: half (default) or float"}}},
                    run_options("")},
        .footer = footer(),
        .run = [options](const Context& context) { run(*options, context); },
    };
}

}  // namespace ocean::app
