// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "workload.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "command.hpp"
#include "ocean/error.hpp"
#include "ocean/gl/backend.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "picture_list.hpp"
#include "user_files.hpp"

namespace ocean::app {
namespace {

/// Max samples of maps and of a coast's windows, cells of the mesh, steps of a shadow and share of
/// the pixels along a side for a software GPU.
constexpr int kSoftwareMap = 256;
constexpr int kSoftwareFoamMap = 512;
constexpr int kSoftwareCoast = 128;
constexpr int kSoftwareCells = 64;
constexpr int kSoftwareShadowSteps = 12;
constexpr double kSoftwareScale = 0.5;
/// Direct sums are N^3 work.
constexpr int kMaxDft = 64;

bool has_compute(const gl::ContextInfo& context) {
    return context.major > 4 || (context.major == 4 && context.minor >= 3);
}

struct SampledModel {
    const char* models;   // "seas"
    const char* section;  // of its resolution
    int resolution;
};

std::string why_not(const Backend& backend, const SampledModel& model,
                    const gl::ContextInfo& context) {
    if (computes_by_shaders(backend) && !has_compute(context)) {
        return "needs OpenGL 4.3; this is " + std::to_string(context.major) + "." +
               std::to_string(context.minor);
    }
    if (backend == Backend::dft && model.resolution > kMaxDft) {
        return "takes " + std::string(model.models) + " of at most " + std::to_string(kMaxDft) +
               " samples a side; " + model.section + ".resolution is " +
               std::to_string(model.resolution);
    }
    return "";
}

}  // namespace

std::span<const Backend> preview_backends() {
    static const std::array<Backend, 5> backends = {gl::kBackend, Backend::cpu, Backend::radix2,
                                                    Backend::dft, gl::kThesisBackend};
    return backends;
}

std::optional<Backend> preview_backend(const std::string& name) {
    if (name == "auto") return std::nullopt;
    for (const Backend& backend : preview_backends()) {
        if (backend.name == name) return backend;
    }
    refuse("there is no backend '" + name + "'");
}

bool computes_by_shaders(const Backend& backend) {
    return backend == gl::kBackend || backend == gl::kThesisBackend;
}

std::string why_not(const Backend& backend, const Sea& sea, const gl::ContextInfo& context) {
    if (sea.parameters.water.bed && backend != Backend::cpu && backend != gl::kBackend) {
        return "knows no bed (water.seabed); cpu and gl do";
    }
    return why_not(backend, {"seas", "grid", sea.parameters.grid.resolution}, context);
}

std::string why_not(const Backend& backend, const TerrainModel& terrain,
                    const gl::ContextInfo& context) {
    return why_not(backend, {"terrains", "terrain", terrain.resolution}, context);
}

const Backend& best_backend(const gl::ContextInfo& context) {
    return has_compute(context) && !context.software ? gl::kBackend : Backend::cpu;
}

const Backend& ChosenBackend::fitting(const std::string& why_not) {
    if (why_not.empty()) return chosen;
    const std::string name(chosen.name);
    if (!fell_back) refuse("backend " + name + ": " + why_not);
    chosen = best_backend(info);
    fell_back(name + " " + why_not);
    return chosen;
}

Computing computing_for(const Backend& backend, const PreviewOptions& options, const Sea& sea,
                        const gl::ContextInfo& context) {
    ChosenBackend{backend, context}.fitting(why_not(backend, sea, context));
    Computing computing{backend, {}};
    preview::SeaMapsOptions& maps = computing.maps;
    // The GPU's own maps are linear: those of second order are made as other backends make them.
    maps.compute = backend == gl::kBackend && !sea.parameters.surface.second_order;
    maps.live = true;
    maps.detail = options.detail;
    const Grid& grid = sea.parameters.grid;
    if (context.software) {
        maps.cascade_resolution = std::min(grid.resolution, kSoftwareMap);
        maps.foam_resolution = std::min(default_map_resolution(grid), kSoftwareFoamMap);
        maps.coast.samples = kSoftwareCoast;
    }
    if (options.map) maps.cascade_resolution = *options.map;
    if (options.foam_map) maps.foam_resolution = *options.foam_map;
    if (backend == Backend::dft) {
        maps.cascade_resolution = grid.resolution;
        maps.foam_resolution = kMaxDft;
    }
    return computing;
}

int land_map_for(const PreviewOptions& options, const TerrainModel& terrain,
                 const gl::ContextInfo& context, bool live) {
    return options.map.value_or(preview::land_map_resolution(terrain, live && context.software));
}

/// Returns the place of the renderer's textures in the user's cache. A disk that refuses them costs
/// the next run the time of making them again.
preview::KeptTextures textures_in_cache() {
    const std::string path = cache_file("foam_pattern");
    if (path.empty()) return {};
    const auto read = [path]() -> std::string {
        constexpr std::size_t kMaxBytes = std::size_t{32} << 20;
        try {
            return text::read_file(path, kMaxBytes);
        } catch (const Error&) {
            return "";
        }
    };
    const auto write = [path](std::string_view bytes) {
        try {
            io::write_output(path, bytes);
        } catch (const Error&) {
            return;
        }
    };
    return {read, write};
}

preview::RendererOptions renderer_for(const PreviewOptions& options, const gl::ContextInfo& context,
                                      bool live) {
    preview::RendererOptions renderer;
    if (context.software) renderer.cells = kSoftwareCells;
    if (context.software && live) {
        renderer.shadow_steps = kSoftwareShadowSteps;
        renderer.land_detail = false;
    }
    if (options.cells) renderer.cells = *options.cells;
    renderer.kept_textures = textures_in_cache();
    return renderer;
}

int live_samples(const PreviewOptions& options, const gl::ContextInfo& context) {
    return options.samples.value_or(context.software ? 1 : kSamples);
}

double pixel_scale(const gl::ContextInfo& context) {
    return context.software ? kSoftwareScale : 1.0;
}

}  // namespace ocean::app
