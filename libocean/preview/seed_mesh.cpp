// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "seed_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ocean::preview {
namespace {

constexpr int kMaxCells = 64;  // keeps a hundred tiles fast enough

}  // namespace

SeedMesh::Tile SeedMesh::make_tile(int cells) {
    std::vector<glm::vec2> grid;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i)
            grid.push_back(glm::vec2(i, j) / static_cast<float>(cells));
    }
    std::vector<unsigned> indices;
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const auto a = static_cast<unsigned>(j * (cells + 1) + i);
            const auto b = a + static_cast<unsigned>(cells + 1);
            for (const unsigned corner : {a, a + 1, b + 1, a, b + 1, b}) indices.push_back(corner);
        }
    }
    Tile tile{gl::make_buffer(), gl::make_buffer(), gl::make_vertex_array(),
              static_cast<GLsizei>(indices.size())};
    glBindVertexArray(tile.array.name());
    glBindBuffer(GL_ARRAY_BUFFER, tile.vertices.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(grid.size() * sizeof(glm::vec2)),
                 grid.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, tile.indices.name());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(unsigned)), indices.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(glm::vec2), nullptr);
    return tile;
}

void SeedMesh::draw(gl::ShaderProgram& program, const glm::dvec3& eye, double period,
                    double finest) {
    const int cells = std::clamp(static_cast<int>(std::lround(period / finest)), 1, kMaxCells);
    auto known = tiles_.find(cells);
    if (known == tiles_.end()) known = tiles_.emplace(cells, make_tile(cells)).first;
    const Tile& tile = known->second;
    const double corner = -0.5 * kSeedTiles * period;
    program.set("tiles", static_cast<float>(corner - eye.x), static_cast<float>(corner - eye.y),
                static_cast<float>(period), static_cast<float>(period / cells));
    glBindVertexArray(tile.array.name());
    glDrawElementsInstanced(GL_TRIANGLES, tile.count, GL_UNSIGNED_INT, nullptr,
                            kSeedTiles * kSeedTiles);
    glBindVertexArray(0);
}

}  // namespace ocean::preview
