// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What is measured: a subject makes frames of one sea, of one kind, with so many threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/simd/simd_level.hpp"
#include "ocean/surface.hpp"
#include "ocean/thread_pool.hpp"
#include "rival_modes.hpp"

namespace ocean::bench {

/// vertices: displacement and normal, three components each, of five linear fields (the normal of
/// the surface before it is displaced, so that slopes are enough). planar: eight linear fields.
enum class FrameKind { vertices, planar };
const char* frame_name(FrameKind kind);
/// height, displacement, slope; planar: the gradients as well.
std::vector<Linear> fields_of(FrameKind kind);

/// One table cell: what all its subjects have in common.
struct Cell {
    std::shared_ptr<const Sea> sea;
    std::shared_ptr<const RivalSea> rivals;
    FrameKind kind;
    int threads;
    SimdLevel level;

    int resolution() const { return sea->modes.lattice.resolution; }
};

/// Where the last frame left a linear field: factor * data[j * row + i * step].
struct FieldView {
    const float* data = nullptr;
    std::ptrdiff_t row = 0;
    std::ptrdiff_t step = 1;
    double factor = 1.0;
};

struct Subject {
    std::string library;  // "ours", "FFTW3f", "MKL", "Blender's scheme", "radix-2"
    std::string variant;
    /// Two fields share one complex map: planes are not what is left.
    bool pairs = false;
    /// rms over the rms of the field.
    double allowed_error = 2e-6;
    std::function<void(double time)> frame;
    /// Slopes of a frame of vertices lie in the normal alone: data is null then.
    std::function<FieldView(Linear field)> field;
    std::function<FieldView(Channel channel)> normal;
};

/// How a subject comes to be, once for each cell.
struct SubjectMaker {
    std::string library;
    std::string variant;
    int least_threads;
    /// Without `frame` where the library refuses.
    std::function<Subject(const Cell& cell)> make;
};

Subject make_ours(const Cell& cell);
/// Every variant of FFTW3f, and of MKL if its module is there.
std::vector<SubjectMaker> rival_makers(SimdLevel level);
/// A double-precision scheme as in Blender's ocean modifier, and the radix-2 of the posts that this
/// library began with. Frames of vertices.
Subject make_blender_scheme(const Cell& cell);
Subject make_radix2(const Cell& cell);

}  // namespace ocean::bench
