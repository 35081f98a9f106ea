// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast_block.hpp"

namespace ocean::preview {

CoastBlock make_coast_block(const DrawnCoast& coast, const Camera& camera) {
    CoastBlock block;
    for (std::size_t w = 0; w < coast.windows.size(); ++w) {
        const CoastWindow& window = coast.windows[w].window;
        const auto place = [&](std::size_t axis) {
            return camera.eye[axis] / window.cell - static_cast<double>(window.corner[axis]);
        };
        block.window[w] = glm::vec4(place(0), place(1), 1.0 / window.cell, window.samples);
    }
    const Domain& bed = coast.bed->domain;
    const double west = bed.origin[0] - camera.eye[0], south = bed.origin[1] - camera.eye[1];
    block.edge = glm::vec4(west, south, west + bed.size[0], south + bed.size[1]);
    block.count = glm::ivec4(static_cast<int>(coast.windows.size()), 0, 0, 0);
    return block;
}

}  // namespace ocean::preview
