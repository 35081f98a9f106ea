// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The two dispatches of a frame; see map_frame.hpp.
#include "map_frame.hpp"

#include <array>
#include <cmath>

#include "checks.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::gl {

namespace {

constexpr GLuint kFirstPackBinding = 4;
constexpr std::size_t kMaxPacks = 6;

struct Split {
    float high;
    float low;
};

Split split(double value) {
    const auto high = static_cast<float>(value);
    return {high, static_cast<float>(value - static_cast<double>(high))};
}

}  // namespace

void require_limits(int resolution, const ContextInfo& limits) {
    const auto require = [&](const char* what, long long has, long long needed) {
        if (has >= needed) return;
        throw Error(ErrorKind::no_gpu,
                    format_text("maps of %d samples need %lld %s, and %s allows %lld", resolution,
                                needed, what, limits.renderer.c_str(), has));
    };
    if (limits.major * 10 + limits.minor < 43) {
        throw Error(ErrorKind::no_gpu, "OpenGL 4.3 is required; available: " + limits.text());
    }
    constexpr int kBlocks = static_cast<int>(kFirstPackBinding + kMaxPacks);
    require("storage blocks a shader", limits.storage_blocks, kBlocks);
    require("bytes in a storage block", limits.storage_block_bytes, 8LL * resolution * resolution);
    require("texels along a texture's side", limits.texture_size, resolution);
}

Buffer make_roots(int resolution) {
    std::vector<std::array<float, 2>> roots(static_cast<std::size_t>(resolution));
    for (std::size_t k = 0; k < roots.size(); ++k) {
        const double angle = kTwoPi * static_cast<double>(k) / resolution;
        roots[k] = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
    }
    Buffer buffer;
    resize_storage(buffer, roots.size() * sizeof roots[0], roots.data());
    return buffer;
}

void set_time(ComputeProgram& program, const MapModes& modes) {
    const Split tau = split(modes.tau);
    program.set("tau", tau.high, tau.low);
    program.set("rate_factor", static_cast<float>(kTwoPi * modes.rate_unit));
    program.set("wavenumber_step", static_cast<float>(modes.wavenumber_step()));
}

MapFrame::MapFrame(int resolution, const ContextInfo& limits, Mipmaps mipmaps) : mipmaps_(mipmaps) {
    require_limits(resolution, limits);
    shape_ = pass_shape(resolution, limits.shared_bytes, limits.workgroup_threads);
    roots_ = make_roots(resolution);
}

bool MapFrame::make(const MapRequest& request, std::vector<Quantity> quantities,
                    const Texture* past, ThreadPool& pool) {
    program_ = &programs_for(std::move(quantities), request.settings.choppiness == 0.0);
    hold_packs(program_->plan.packs.size());
    hold_maps(program_->plan);
    const bool uploaded = modes_.load(request.modes, pool);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kRootsBinding, roots_.name());
    for (std::size_t p = 0; p < program_->plan.packs.size(); ++p) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kFirstPackBinding + static_cast<GLuint>(p),
                         packs_[p].name());
    }
    if (mark_) mark_();
    run_rows(request);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    if (mark_) mark_();
    run_columns(request, past);
    if (mark_) mark_();
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    require_no_error("making a frame");
    return uploaded;
}

void MapFrame::exchange_map(std::size_t number, GLenum format, Texture& texture) {
    if (maps_.size() <= number) maps_.resize(number + 1);
    if (formats_.size() <= number) formats_.resize(number + 1, GL_NONE);
    std::swap(maps_[number], texture);
    formats_[number] = maps_[number] ? format : GL_NONE;
}

MapFrame::Programs& MapFrame::programs_for(std::vector<Quantity> quantities, bool flat) {
    std::pair<std::vector<int>, bool> key{{}, flat};
    for (const Quantity quantity : quantities) key.first.push_back(quantity.id);
    const auto found = programs_.find(key);
    if (found != programs_.end()) return found->second;
    FramePlan plan = make_frame_plan(shape_, std::move(quantities), flat);
    ComputeProgram rows("compute/rows.comp", plan.rows_defines());
    ComputeProgram columns("compute/columns.comp", plan.columns_defines());
    return programs_
        .emplace(std::move(key), Programs{std::move(plan), std::move(rows), std::move(columns)})
        .first->second;
}

void MapFrame::hold_packs(std::size_t count) {
    const auto width = static_cast<std::size_t>(shape_.resolution);
    while (packs_.size() < count) {
        resize_storage(packs_.emplace_back(), width * width * 2 * sizeof(float), nullptr);
    }
}

void MapFrame::hold_maps(const FramePlan& plan) {
    if (formats_.size() < plan.maps.size()) formats_.resize(plan.maps.size(), GL_NONE);
    if (maps_.size() < plan.maps.size()) maps_.resize(plan.maps.size());
    for (std::size_t m = 0; m < plan.maps.size(); ++m) {
        const GLenum format = plan.maps[m].format();
        if (formats_[m] == format) continue;
        maps_[m] = make_texture(format, shape_.resolution, mipmaps_);
        formats_[m] = format;
    }
}

void MapFrame::run_rows(const MapRequest& request) {
    ComputeProgram& rows = program_->rows;
    modes_.bind();
    rows.use();
    set_time(rows, request.modes);
    rows.set("gradient_scale", modes_.gradient_scale());
    glDispatchCompute(static_cast<GLuint>(shape_.resolution), 1, 1);
}

void MapFrame::run_columns(const MapRequest& request, const Texture* past) {
    const FramePlan& plan = program_->plan;
    ComputeProgram& columns = program_->columns;
    columns.use();
    for (std::size_t m = 0; m < plan.maps.size(); ++m) {
        glBindImageTexture(static_cast<GLuint>(m), maps_[m].name(), 0, GL_FALSE, 0, GL_WRITE_ONLY,
                           formats_[m]);
    }
    const SurfaceSettings& settings = request.settings;
    columns.set("gradient_scale", modes_.gradient_scale());
    columns.set("choppiness", static_cast<float>(settings.choppiness));
    columns.set("whitecap_threshold_and_width", static_cast<float>(settings.foam_threshold),
                static_cast<float>(settings.foam_width));
    if (plan.foam) {
        columns.set("foam_fade_and_cutoff", past != nullptr ? request.foam.fade : 0.0f,
                    request.foam.cutoff);
        columns.set("foam_alone", request.foam.alone);
        if (past == nullptr && !no_past_) {
            no_past_ = make_texture(GL_R32F, 1);
            const float nothing = 0.0f;
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RED, GL_FLOAT, &nothing);
        }
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, (past != nullptr ? *past : no_past_).name());
    }
    glDispatchCompute(static_cast<GLuint>(shape_.resolution / shape_.columns), 1, 1);
}

}  // namespace ocean::gl
