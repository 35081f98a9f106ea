// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The transform of [Fluegge 2017] and the backend of it; see thesis_frame.hpp.
#include "thesis_frame.hpp"

#include <bit>

#include "checks.hpp"
#include "frame_plan.hpp"
#include "gpu_function.hpp"
#include "map_frame.hpp"
#include "ocean/gl/backend.hpp"
#include "ocean/page_vector.hpp"
#include "write_quantity.hpp"

namespace ocean::gl {

namespace {

std::string define(const char* name, int value) {
    return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}

void bind_image(GLuint unit, const Texture& texture, GLenum access, GLenum format) {
    glBindImageTexture(unit, texture.name(), 0, GL_FALSE, 0, access, format);
}

Texture make_butterflies(int resolution, int octaves) {
    GLuint name = 0;
    glGenTextures(1, &name);
    Texture texture(name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, octaves, resolution);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    const Buffer roots = make_roots(resolution);
    ComputeProgram program("compute/thesis/butterfly.comp",
                           define("N", resolution) + define("STAGES", octaves));
    program.use();
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kRootsBinding, roots.name());
    bind_image(0, texture, GL_WRITE_ONLY, GL_RGBA32F);
    glDispatchCompute(static_cast<GLuint>(octaves), static_cast<GLuint>(resolution) / 16, 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
    return texture;
}

class ThesisMaps {
  public:
    explicit ThesisMaps(const ContextInfo& limits) : limits_(limits) {}

    bool write(const MapRequest& request, ThreadPool& pool) {
        const int resolution = request.modes.resolution;
        auto found = frames_.find(resolution);
        if (found == frames_.end()) {
            found = frames_.emplace(resolution, ThesisFrame(resolution, limits_)).first;
        }
        ThesisFrame& frame = found->second;
        const bool uploaded = frame.load(request, pool);
        texels_.resize(Lattice{resolution, 1.0}.size());
        const LinearSet fields = fields_of(request.outputs);
        for (const Linear field : kLinears) {
            if (!fields.contains(field)) continue;
            frame.transform(field, request);
            glBindTexture(GL_TEXTURE_2D, frame.field().name());
            glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, texels_.data());
            require_no_error("reading a field back");
            write_quantity(request, field, texels_.data(), 1, pool);
        }
        return uploaded;
    }

  private:
    ContextInfo limits_;
    std::map<int, ThesisFrame> frames_;
    PageVector<float> texels_;
};

std::uint64_t thesis_bytes(const Grid&, LinearSet, int resolution) {
    return Lattice{resolution, 1.0}.size() * (20 + 2 * 8 + 4 + 4);
}

/// Returns the fitness of `gl`, but never fast: `thesis` is always slower than `gl`.
BackendFitness thesis_fitness(int resolution) {
    BackendFitness fitness = kBackend.fitness(resolution);
    fitness.fast = false;
    return fitness;
}

}  // namespace

ThesisFrame::ThesisFrame(int resolution, const ContextInfo& limits)
    : resolution_(resolution),
      octaves_(std::countr_zero(static_cast<unsigned>(resolution))),
      stage_("compute/thesis/stage.comp", ""),
      permutation_("compute/thesis/permutation.comp", "") {
    require_limits(resolution, limits);
    butterflies_ = make_butterflies(resolution, octaves_);
    for (Texture& texture : ping_pong_) texture = make_texture(GL_RG32F, resolution);
    field_ = make_texture(GL_R32F, resolution);
    require_no_error("preparing the transform by stages");
}

bool ThesisFrame::load(const MapRequest& request, ThreadPool& pool) {
    return modes_.load(request.modes, pool);
}

ComputeProgram& ThesisFrame::spectrum_program(Linear field) {
    const auto found = spectrum_.find(field);
    if (found != spectrum_.end()) return found->second;
    return spectrum_
        .emplace(field, ComputeProgram("compute/thesis/spectrum.comp",
                                       define("N", resolution_) + "#define COEFFICIENT " +
                                           coefficient(field) + "\n"))
        .first->second;
}

void ThesisFrame::run_tiles() const {
    dispatch_texels(resolution_);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

void ThesisFrame::transform_stages(Linear field, const MapRequest& request, int stages) {
    ComputeProgram& spectrum = spectrum_program(field);
    spectrum.use();
    modes_.bind();
    set_time(spectrum, request.modes);
    newest_ = 0;
    bind_image(0, ping_pong_[0], GL_WRITE_ONLY, GL_RG32F);
    run_tiles();

    stage_.use();
    bind_image(0, butterflies_, GL_READ_ONLY, GL_RGBA32F);
    for (int stage = 0; stage < stages; ++stage) {
        stage_.set("stage", stage % octaves_);
        stage_.set("vertical", stage >= octaves_ ? 1 : 0);
        bind_image(1, ping_pong_[newest_], GL_READ_ONLY, GL_RG32F);
        newest_ = 1 - newest_;
        bind_image(2, ping_pong_[newest_], GL_WRITE_ONLY, GL_RG32F);
        run_tiles();
    }
    require_no_error("transforming by stages");
}

void ThesisFrame::transform(Linear field, const MapRequest& request) {
    transform_stages(field, request, stages());
    permutation_.use();
    bind_image(0, complex(), GL_READ_ONLY, GL_RG32F);
    bind_image(1, field_, GL_WRITE_ONLY, GL_R32F);
    run_tiles();
    require_no_error("transforming by stages");
}

const Backend kThesisBackend = {"thesis",
                                {},
                                [] { return MapFunction(GpuFunction<ThesisMaps>()); },
                                thesis_bytes,
                                thesis_fitness};

}  // namespace ocean::gl
