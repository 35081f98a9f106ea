// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Values of the preview's textures.
#pragma once

#include <epoxy/gl.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "ocean/internal/preview/sea_maps.hpp"

namespace ocean::test {

/// Returns the texels of one layer of an array texture, `components` floats each.
inline std::vector<float> layer_texels(unsigned array, int layer, int level, GLenum format,
                                       std::size_t components) {
    GLint width = 0, height = 0, layers = 0;
    glBindTexture(GL_TEXTURE_2D_ARRAY, array);
    glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, level, GL_TEXTURE_WIDTH, &width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, level, GL_TEXTURE_HEIGHT, &height);
    glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, level, GL_TEXTURE_DEPTH, &layers);
    const std::size_t size =
        components * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::vector<float> all(size * static_cast<std::size_t>(layers));
    glGetTexImage(GL_TEXTURE_2D_ARRAY, level, format, GL_FLOAT, all.data());
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(size) * layer;
    return {begin, begin + static_cast<std::ptrdiff_t>(size)};
}

/// Heights of the shown maps on `resolution` samples along a side of the sea's period: the sum over
/// its cascades, each wrapped round its own. They need as many samples.
inline std::vector<float> shown_heights(const preview::DrawnSea& sea, int resolution) {
    const auto side = static_cast<std::size_t>(resolution);
    std::vector<float> heights(side * side);
    for (const preview::DrawnCascade& cascade : sea.cascades) {
        if (cascade.maps.resolution != resolution) return {};
        const std::vector<float> texels =
            layer_texels(cascade.maps.displacement, cascade.layer, 0, GL_RGBA, 4);
        const auto periods = static_cast<std::size_t>(std::lround(sea.period / cascade.period));
        for (std::size_t y = 0; y < side; ++y) {
            for (std::size_t x = 0; x < side; ++x) {
                const std::size_t from = (y * periods % side) * side + x * periods % side;
                heights[y * side + x] += static_cast<float>(cascade.weight) * texels[4 * from + 2];
            }
        }
    }
    return heights;
}

/// Returns the mean square slope of the shown maps, by the last level of their second moments.
inline double map_slope(const preview::DrawnSea& sea) {
    double sum = 0.0;
    for (const preview::DrawnCascade& cascade : sea.cascades) {
        const int level = static_cast<int>(std::lround(std::log2(cascade.maps.resolution)));
        const std::vector<float> last =
            layer_texels(cascade.maps.moments, cascade.layer, level, GL_RGBA, 4);
        sum += cascade.weight * cascade.weight * static_cast<double>(last[0] + last[1]);
    }
    return sum;
}

}  // namespace ocean::test
