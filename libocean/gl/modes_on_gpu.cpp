// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From the modes of each cascade to those of the map, one lattice of N x N; see modes_on_gpu.hpp.
#include "modes_on_gpu.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "checks.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean::gl {

namespace {

/// Calls set(to, cascade, from) for each mode of each cascade that the map holds. The bands share
/// no mode, but each cascade's arrays cover all of its lattice: `set` sees also the empty ones.
template <typename Set>
void for_each_mode(const MapModes& modes, ThreadPool& pool, const Set& set) {
    for (const CascadeModes& cascade : modes.cascades) {
        const int half = modes.half(cascade);
        const int stride = modes.stride(cascade);
        const int own = cascade.lattice.resolution;
        pool.for_each_range(2 * half - 1, [&](int first, int last) {
            for (int m = first - half + 1; m < last - half + 1; ++m) {
                for (int n = -half + 1; n < half; ++n) {
                    set(mode_index(n * stride, m * stride, modes.resolution), cascade,
                        mode_index(n, m, own));
                }
            }
        });
    }
}

template <typename T>
PageVector<T> zeros(const MapModes& modes, ThreadPool& pool) {
    const auto width = static_cast<std::size_t>(modes.resolution);
    PageVector<T> values(width * width);
    pool.for_each_range(modes.resolution, [&](int first, int last) {
        std::fill(values.begin() + static_cast<std::ptrdiff_t>(first * width),
                  values.begin() + static_cast<std::ptrdiff_t>(last * width), T{});
    });
    return values;
}

}  // namespace

void resize_storage(Buffer& buffer, std::size_t bytes, const void* data) {
    if (!buffer) {
        GLuint name = 0;
        glGenBuffers(1, &name);
        buffer = Buffer(name);
    }
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.name());
    glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
}

PageVector<std::complex<float>> map_amplitudes(const MapModes& modes, ThreadPool& pool) {
    using Amplitude = std::complex<float>;
    auto amplitudes = zeros<Amplitude>(modes, pool);
    for_each_mode(modes, pool, [&](std::size_t to, const CascadeModes& cascade, std::size_t from) {
        const Amplitude h0 = cascade.h0[from];
        if (h0 != Amplitude(0.0f)) amplitudes[to] = h0;
    });
    return amplitudes;
}

bool ModesOnGpu::load(const MapModes& modes, ThreadPool& pool) {
    if (revision_ == modes.revision) return false;
    const bool same_lattice = lattice_revision_ == modes.lattice_revision;
    revision_ = {};
    if (!same_lattice) {
        lattice_revision_ = {};
        load_lattice(modes, pool);
        lattice_revision_ = modes.lattice_revision;
    }
    load_amplitudes(modes, pool);
    gradient_scale_ = find_gradient_scale(modes, pool);
    require_no_error("uploading the modes");
    revision_ = modes.revision;
    return true;
}

void ModesOnGpu::load_lattice(const MapModes& modes, ThreadPool& pool) {
    using Rate = std::array<float, 2>;
    auto rates = zeros<Rate>(modes, pool);
    auto displacements = zeros<float>(modes, pool);
    for_each_mode(modes, pool, [&](std::size_t to, const CascadeModes& cascade, std::size_t from) {
        // Cascades that share a mode of the map have the same two numbers there, to the bit.
        rates[to] = {cascade.rate_high[from], cascade.rate_low[from]};
        displacements[to] = cascade.displacement[from];
    });
    resize_storage(rates_, rates.size() * sizeof(Rate), rates.data());
    resize_storage(displacements_, displacements.size() * sizeof(float), displacements.data());
}

void ModesOnGpu::load_amplitudes(const MapModes& modes, ThreadPool& pool) {
    using Amplitude = std::complex<float>;
    const bool as_it_is = modes.cascades.size() == 1 && modes.stride(modes.cascades[0]) == 1 &&
                          modes.cascades[0].lattice.resolution == modes.resolution &&
                          2 * modes.half(modes.cascades[0]) == modes.resolution;
    if (as_it_is) {
        const auto& h0 = modes.cascades[0].h0;
        resize_storage(amplitudes_, h0.size() * sizeof(Amplitude), h0.data());
        return;
    }
    const auto amplitudes = map_amplitudes(modes, pool);
    resize_storage(amplitudes_, amplitudes.size() * sizeof(Amplitude), amplitudes.data());
}

float ModesOnGpu::find_gradient_scale(const MapModes& modes, ThreadPool& pool) const {
    double height = 0.0;
    double gradient = 0.0;
    for (const CascadeModes& cascade : modes.cascades) {
        const int half = modes.half(cascade);
        const int own = cascade.lattice.resolution;
        std::vector<double> rows(static_cast<std::size_t>(2 * half - 1), 0.0);
        pool.for_each_range(static_cast<int>(rows.size()), [&](int first, int last) {
            for (int row = first; row < last; ++row) {
                double sum = 0.0;
                for (int n = -half + 1; n < half; ++n) {
                    sum += std::norm(cascade.h0[mode_index(n, row - half + 1, own)]);
                }
                rows[static_cast<std::size_t>(row)] = 2.0 * sum;
            }
        });
        for (const double row : rows) height += row;
        for (int s = 0; s < half; ++s) {
            gradient += cascade.shell_covariance[static_cast<std::size_t>(s)].cc;
        }
    }
    if (!(height > 0.0 && gradient > 0.0)) return 1.0f;
    const double octaves = std::round(0.5 * std::log2(height / gradient));
    return std::ldexp(1.0f, static_cast<int>(std::clamp(octaves, -30.0, 30.0)));
}

void ModesOnGpu::bind() const {
    GLuint binding = 0;
    for (const Buffer* buffer : {&amplitudes_, &rates_, &displacements_}) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding++, buffer->name());
    }
}

}  // namespace ocean::gl
