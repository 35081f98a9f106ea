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

}  // namespace ocean::test
