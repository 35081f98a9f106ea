// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "clipmap.hpp"

#include <algorithm>
#include <cmath>

#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

const void* offset_of(int index) {
    return reinterpret_cast<const void*>(static_cast<std::size_t>(index) * sizeof(unsigned));
}

}  // namespace

Frustum::Frustum(const glm::mat4& clip_from_world, double eye_height) {
    const glm::dmat4 m(glm::transpose(clip_from_world));  // its rows are columns now
    // The matrix expects positions relative to the eye itself.
    const auto lifted = [&](glm::dvec4 plane) {
        plane.w -= plane.z * eye_height;
        return plane;
    };
    planes = {lifted(m[3] + m[0]), lifted(m[3] - m[0]), lifted(m[3] + m[1]), lifted(m[3] - m[1])};
}

bool Frustum::touches(const glm::dvec3& min, const glm::dvec3& max) const {
    return std::ranges::all_of(planes, [&](const glm::dvec4& plane) {
        const glm::dvec3 farthest(plane.x > 0.0 ? max.x : min.x, plane.y > 0.0 ? max.y : min.y,
                                  plane.z > 0.0 ? max.z : min.z);
        return glm::dot(glm::dvec3(plane), farthest) + plane.w >= 0.0;
    });
}

Clipmap::Clipmap(int cells) : cells_(cells) {
    std::vector<glm::vec2> grid;
    for (int j = -cells; j <= cells; ++j) {
        for (int i = -cells; i <= cells; ++i) grid.emplace_back(i, j);
    }
    std::vector<unsigned> indices;
    whole_ = add_blocks(indices, false, 0, 0);
    for (int n = 0; n < 4; ++n) {
        ring_[static_cast<std::size_t>(n)] = add_blocks(indices, true, n % 2, n / 2);
    }

    array_ = gl::make_vertex_array();
    vertices_ = gl::make_buffer();
    indices_ = gl::make_buffer();
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(grid.size() * sizeof(glm::vec2)),
                 grid.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(unsigned)), indices.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(glm::vec2), nullptr);
    glBindVertexArray(0);
}

Clipmap::Blocks Clipmap::add_blocks(std::vector<unsigned>& indices, bool hole, int x, int y) const {
    const int side = 2 * cells_;
    const int block_cells = side / kBlocks;
    const auto in_hole = [&](int i, int j) {  // of the cell with its lower corner at (i, j)
        const int half = cells_ / 2;
        return hole && i - x >= -half && i - x < half && j - y >= -half && j - y < half;
    };
    const auto vertex = [&](int i, int j) {
        return static_cast<unsigned>((j + cells_) * (side + 1) + i + cells_);
    };
    Blocks blocks;
    for (int b = 0; b < kBlocks * kBlocks; ++b) {
        const int first = static_cast<int>(indices.size());
        const int left = -cells_ + b % kBlocks * block_cells;
        const int lower = -cells_ + b / kBlocks * block_cells;
        for (int j = lower; j < lower + block_cells; ++j) {
            for (int i = left; i < left + block_cells; ++i) {
                if (in_hole(i, j)) continue;
                for (const unsigned corner :
                     {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j),
                      vertex(i + 1, j + 1), vertex(i, j + 1)}) {
                    indices.push_back(corner);
                }
            }
        }
        blocks[static_cast<std::size_t>(b)] = {first, static_cast<int>(indices.size()) - first};
    }
    return blocks;
}

std::size_t Clipmap::draw(gl::ShaderProgram& program, const glm::dvec3& eye, double finest,
                          const Frustum& frustum, const Reach& reach, bool only_lines) const {
    glBindVertexArray(array_.name());
    // No water is nearer than still water below the eye. A level that would be morphed all over
    // equals the next one, and is skipped.
    const double nearest = std::abs(eye.z);
    // Morphing begins outside the level inside, wherever that lies, and is complete before the
    // edge: up to there the same vertices draw the water wherever the eye goes.
    const double begin = std::max(cells_ / 2 + 1, 3 * cells_ / 4), end = cells_ - 2;
    program.set("morph", static_cast<float>(begin), static_cast<float>(1.0 / (end - begin)),
                static_cast<float>(nearest), only_lines ? 1.0f : 0.0f);
    double cell = finest;
    while (end * cell <= nearest) cell *= 2.0;

    std::size_t triangles = 0;
    std::vector<GLsizei> counts;
    std::vector<const void*> firsts;
    glm::dvec2 inner(0.0);
    for (bool innermost = true; innermost || 0.5 * cells_ * cell < reach.farthest;
         innermost = false, cell *= 2.0) {
        const glm::dvec2 centre = glm::floor(glm::dvec2(eye) / (2.0 * cell)) * (2.0 * cell);
        const glm::dvec2 place = centre - glm::dvec2(eye);
        const glm::dvec2 hole = (inner - centre) / cell;
        const Blocks& blocks =
            innermost
                ? whole_
                : ring_[static_cast<std::size_t>(std::lround(hole.x) + 2 * std::lround(hole.y))];
        inner = centre;

        counts.clear();
        firsts.clear();
        const double side = 2.0 * cells_ / kBlocks * cell;
        for (int b = 0; b < kBlocks * kBlocks; ++b) {
            const Block& block = blocks[static_cast<std::size_t>(b)];
            if (block.indices == 0) continue;
            const glm::dvec2 corner =
                place - cells_ * cell + side * glm::dvec2(b % kBlocks, b / kBlocks);
            const glm::dvec2 away = glm::max(glm::abs(corner), glm::abs(corner + side));
            const double drop = wave::double_precision::earth_drop(glm::length(away));
            if (!frustum.touches(glm::dvec3(corner - reach.sideways, -reach.up - drop),
                                 glm::dvec3(corner + side + reach.sideways, reach.up))) {
                continue;
            }
            counts.push_back(block.indices);
            firsts.push_back(offset_of(block.first_index));
            triangles += static_cast<std::size_t>(block.indices) / 3;
        }
        if (counts.empty()) continue;
        program.set("level", static_cast<float>(place.x), static_cast<float>(place.y),
                    static_cast<float>(cell), 0.0f);
        glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, firsts.data(),
                            static_cast<GLsizei>(counts.size()));
    }
    glBindVertexArray(0);
    return triangles;
}

}  // namespace ocean::preview
