// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The plan of a frame: what it computes, and the lines of #define that make the two passes compute
// it. Both follow from the tables of linear fields and channels, so that no shader repeats them.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <vector>

#include "ocean/surface.hpp"

namespace ocean::gl {

/// The shape of the two passes for maps of a resolution, within the limits of a GPU.
struct PassShape {
    int resolution = 0;
    int columns = 4;        // per workgroup of pass two
    int rows_padding = 31;  // a free place every 2^padding; 31: none
    int columns_padding = 31;
    bool split = false;  // real and imaginary parts exchanged one after the other

    int threads() const { return resolution / 8; }  // per line
};
/// Throws Error no_gpu if a workgroup cannot hold a line.
PassShape pass_shape(int resolution, int shared_bytes, int workgroup_threads);

/// Two linear fields that share a complex transform. A field always has the same partner, so that
/// its bits do not depend on the other requested fields. Each rounds the other, so both must be of
/// similar size; gradient_xy is therefore multiplied by ModesOnGpu::gradient_scale during the
/// transform, which makes it as large as the height.
struct FieldPair {
    Linear real;
    Linear imaginary;
};
inline constexpr FieldPair kFieldPairs[] = {
    {Linear::height, Linear::gradient_xy},
    {Linear::displacement_x, Linear::displacement_y},
    {Linear::slope_x, Linear::slope_y},
    {Linear::gradient_xx, Linear::gradient_yy},
    {Linear::displacement_x_rate, Linear::displacement_y_rate},
    {Linear::height_rate, Linear::height_rate},
};

/// Returns the GLSL of the coefficient of a pair, the first field's plus i times the second's, of
/// the variables h, h_rate, kx, ky, u and gradient_scale.
std::string coefficients(const FieldPair& pack);

/// Up to four quantities in one texture.
struct MapTexture {
    std::vector<Quantity> quantities;

    int components() const;       // of the texture: 1, 2 or 4
    GLenum format() const;        // GL_R32F, GL_RG32F or GL_RGBA32F
    GLenum pixel_format() const;  // GL_RED, GL_RG or GL_RGBA
};

struct FramePlan {
    PassShape shape;
    std::vector<FieldPair> packs;
    std::vector<MapTexture> maps;
    bool foam = false;  // a channel reads the past

    std::string rows_defines() const;
    std::string columns_defines() const;
};

/// Returns a field's coefficient for the shaders, by the table of fields: "times_i(h) * (-1.0 * kx
/// * u)".
std::string coefficient(Linear field);

/// Returns the plan for these quantities, without repetition. flat: choppiness 0.
FramePlan make_frame_plan(const PassShape& shape, std::vector<Quantity> quantities, bool flat);

}  // namespace ocean::gl
