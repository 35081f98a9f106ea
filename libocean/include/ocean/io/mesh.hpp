// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A surface as triangles, for renderers without displacement.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/domain.hpp"
#include "ocean/surface.hpp"

namespace ocean::io {

/// Numbers at each vertex, for every writer: how a format spells a name stands in one table.
struct Attribute {
    std::string name;  // "uv", or a product's: "foam", "velocity"
    int components = 1;
    std::vector<float> values = {};  // `components` of each vertex
    bool vector = false;             // x, y, z in the world: it turns with the mesh
};

/// Where the label of a vertex lies in its domain, 0 .. 1 along each side.
inline constexpr std::string_view kUv = "uv";

/// Triangles with a normal at each vertex, z up, metres.
struct Mesh {
    std::vector<float> positions;            // x, y, z of each vertex
    std::vector<float> normals = {};         // likewise, or none
    std::vector<Attribute> attributes = {};  // each name once
    std::vector<int> triangles = {};    // three vertex numbers each, counter-clockwise from above
    std::optional<Domain> domain = {};  // of the maps that it shows all of; nothing for a view

    std::size_t vertices() const { return positions.size() / 3; }
    /// Returns the attribute of that name, or null.
    const Attribute* find(std::string_view name) const;
};

/// none: what frames do not share alone, for files that have the faces and uv elsewhere.
enum class Faces { none, triangles };

/// Returns the displaced surface over its domain, with the normal, uv, and each of `products` that
/// it was evaluated with, in their order. Needs height; a surface without dx and dy rises straight
/// above its samples. Throws Error invalid_value for one without height or with fewer than two
/// samples a side.
///
/// A domain that wraps has (N + 1)^2 vertices with the seam closed. They lie on a grid of a power
/// of two (2^-16 m, coarser for large patches), which keeps the seam of copies that lie a period
/// apart free of cracks when the period lies on it too, as every whole number does. Of one that
/// does not wrap the vertices are its samples.
Mesh make_patch_mesh(const Surface& surface, Faces faces = Faces::triangles,
                     std::span<const Product> products = product_table());

/// y up instead of z: (x, z, -y).
void turn_y_up(Mesh& mesh);

/// Returns how many vertices a patch mesh has along x and along y.
std::array<int, 2> patch_vertices(const Domain& domain);
/// Returns its triangles alone, which are the same for all maps of so many samples.
std::vector<int> patch_triangles(const Domain& domain);
std::vector<int> patch_triangles(int resolution);
/// Returns its uv alone, two numbers a vertex: 0 at the first, 1 at the last of a side.
std::vector<float> patch_uv(const Domain& domain);

}  // namespace ocean::io
