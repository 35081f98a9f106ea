// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the preview's textures hold.
#pragma once

#include <epoxy/gl.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "ocean/preview/sea_maps.hpp"

namespace ocean::test {

/// Heights of the shown maps on `resolution` samples along a side of the sea's period: the sum over
/// its cascades, each wrapped round its own. They need as many samples.
inline std::vector<float> shown_heights(const preview::ShownSea& sea, int resolution) {
    const auto side = static_cast<std::size_t>(resolution);
    std::vector<float> heights(side * side);
    for (const preview::ShownCascade& cascade : sea.cascades) {
        if (cascade.resolution != resolution) return {};
        std::vector<float> texels(4 * side * side);
        glBindTexture(GL_TEXTURE_2D, cascade.displacement);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, texels.data());
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

/// Mean square slope that the shown maps have: of the last level of their second moments.
inline double map_slope(const preview::ShownSea& sea) {
    double sum = 0.0;
    for (const preview::ShownCascade& cascade : sea.cascades) {
        float last[4] = {};
        glBindTexture(GL_TEXTURE_2D, cascade.moments);
        const int level = static_cast<int>(std::lround(std::log2(cascade.resolution)));
        glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_FLOAT, last);
        sum += cascade.weight * cascade.weight * static_cast<double>(last[0] + last[1]);
    }
    return sum;
}

}  // namespace ocean::test
