// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast_sums.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "checks.hpp"
#include "modes_on_gpu.hpp"
#include "ocean/error.hpp"
#include "ocean/query.hpp"

namespace ocean::gl {
namespace {

constexpr std::size_t kGroup = 64;  // local_size_x

/// The buffer Coast of the shader, in the layout std430, before its pairs.
struct CoastBlock {
    double delay_origin[2], energy_origin[2];
    double delays_per_metre, energies_per_metre;
    std::int32_t delay_samples[2], energy_samples[2];
    std::int32_t pair_count;
    std::int32_t depth_count;
    float first_log;
    float per_log;
};
struct PairBlock {
    double cells_per_metre[2];
    double half_turns[2];
    std::uint32_t mask[2];
    std::uint32_t pitch;
    std::uint32_t values, rates;
    std::int32_t band;
    float centre;
    float open_displacement;
};
static_assert(sizeof(CoastBlock) == 80 && sizeof(PairBlock) == 64);

std::string parts_define(std::size_t parts) {
    return "#define PARTS " + std::to_string(parts) + "\n";
}

}  // namespace

void CoastSums::load(const QuadMaps& maps, Layers& layers) const {
    if (layers.texture && layers.owner == maps.owner) return;
    const std::array<int, 2> samples = maps.domain.samples;
    if (std::ranges::max(samples) > limits_.texture_size) {
        throw Error(ErrorKind::unsupported, "the bed has " + std::to_string(samples[0]) + " x " +
                                                std::to_string(samples[1]) +
                                                " samples, and this GPU's textures at most " +
                                                std::to_string(limits_.texture_size) +
                                                " along a side; the backend cpu has no such limit");
    }
    layers.texture = generate<Texture, &glGenTextures>();
    glBindTexture(GL_TEXTURE_2D_ARRAY, layers.texture.name());
    glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, GL_RGBA32F, samples[0], samples[1],
                   static_cast<GLsizei>(maps.maps.size()));
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    GLint layer = 0;
    for (const float* const map : maps.maps) {
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer++, samples[0], samples[1], 1, GL_RGBA,
                        GL_FLOAT, map);
    }
    require_no_error("uploading a coast");
    layers.owner = maps.owner;
}

void CoastSums::load_signals(const CoastWaves& waves, bool rates) {
    CoastBlock block{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        block.delay_origin[axis] = waves.delays.domain.origin[axis];
        block.energy_origin[axis] = waves.energy.domain.origin[axis];
        block.delay_samples[axis] = waves.delays.domain.samples[axis];
        block.energy_samples[axis] = waves.energy.domain.samples[axis];
    }
    block.delays_per_metre = 1.0 / waves.delays.domain.step(0);
    block.energies_per_metre = 1.0 / waves.energy.domain.step(0);
    block.pair_count = static_cast<std::int32_t>(waves.pairs.size());
    block.depth_count = static_cast<std::int32_t>(waves.displacement.size() / 4);
    block.first_log = waves.first_log;
    block.per_log = waves.per_log;

    std::vector<PairBlock> pairs;
    std::vector<std::span<const float>> pieces;
    std::size_t floats = 0;
    const auto add = [&](std::span<const float> piece) {
        pieces.push_back(piece);
        const std::size_t first = floats / 2;
        floats += piece.size();
        return static_cast<std::uint32_t>(first);
    };
    for (const CoastBandSector& of : waves.pairs) {
        PairBlock& pair = pairs.emplace_back();
        for (std::size_t axis = 0; axis < 2; ++axis) {
            pair.cells_per_metre[axis] = of.cells_per_metre[axis];
            pair.half_turns[axis] = of.half_turns[axis];
            pair.mask[axis] = of.mask[axis];
        }
        pair.pitch = static_cast<std::uint32_t>(of.pitch);
        pair.values = add(of.values);
        pair.rates = rates ? add(of.rates) : 0;
        pair.band = of.band;
        pair.centre = of.centre;
        pair.open_displacement = of.open_displacement;
    }
    const std::size_t bytes = floats * sizeof(float);
    if (bytes > static_cast<std::size_t>(limits_.storage_block_bytes)) {
        throw Error(ErrorKind::unsupported, "the signals of this coast are " +
                                                std::to_string(bytes) +
                                                " bytes, and a buffer of this GPU at most " +
                                                std::to_string(limits_.storage_block_bytes) +
                                                "; the backend cpu has no such limit");
    }
    resize_storage(coefficients_, bytes, nullptr);
    GLintptr at = 0;
    for (const std::span<const float> piece : pieces) {
        const auto size = static_cast<GLsizeiptr>(piece.size_bytes());
        glBufferSubData(GL_SHADER_STORAGE_BUFFER, at, size, piece.data());
        at += size;
    }
    resize_storage(coast_, sizeof block + pairs.size() * sizeof(PairBlock), nullptr);
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof block, &block);
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, sizeof block,
                    static_cast<GLsizeiptr>(pairs.size() * sizeof(PairBlock)), pairs.data());
    resize_storage(depths_, waves.displacement.size_bytes(), waves.displacement.data());
}

void CoastSums::write(const CoastRequest& request) {
    const CoastWaves& waves = request.waves;
    const std::size_t count = request.labels.size();
    glActiveTexture(GL_TEXTURE0);
    load(waves.delays, delays_);
    load(waves.energy, energy_);
    if (request.begins) load_signals(waves, request.parts == 4);
    static_assert(sizeof(WorldPoint) == 2 * sizeof(double));
    resize_storage(labels_, request.labels.size_bytes(), request.labels.data());
    resize_storage(sums_, request.sums.size_bytes(), nullptr);

    ComputeProgram& program = programs_[request.parts == 1 ? 0 : request.parts - 2];
    if (program.name() == 0) {
        program = ComputeProgram("compute/coast_waves.comp", parts_define(request.parts));
    }
    program.use();
    program.set("label_count", static_cast<int>(count));
    const Buffer* const buffers[] = {&labels_, &coefficients_, &coast_, &depths_, &sums_};
    GLuint binding = 0;
    for (const Buffer* const buffer : buffers) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding++, buffer->name());
    }
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D_ARRAY, energy_.texture.name());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, delays_.texture.name());
    glDispatchCompute(static_cast<GLuint>((count + kGroup - 1) / kGroup), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, sums_.name());
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
                       static_cast<GLsizeiptr>(request.sums.size_bytes()), request.sums.data());
    require_no_error("summing the waves of a coast");
}

}  // namespace ocean::gl
