// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A surface as triangles and spray as points, for renderers without displacement mapping; and their
// files, PLY and OBJ, with their provenance in comments.
//
//     const Surface surface = ocean.evaluate(12.0, kEveryChannel, 512);
//     io::Mesh mesh = io::make_patch_mesh(surface);
//     const Provenance provenance{.kind = "sea", .text = write_sea(sea), .time = 12.0};
//     io::write_ply(mesh, provenance_strings(provenance), "sea.ply");
//     io::turn_y_up(mesh);
//     io::write_obj(mesh, {}, "sea.obj");
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/domain.hpp"
#include "ocean/provenance.hpp"
#include "ocean/surface.hpp"

namespace ocean::io {

/// Values at each vertex, for all writers; attribute_names.cpp has the formats' spellings of names.
struct Attribute {
    std::string name;  // "uv", or a product's name: "foam", "velocity"
    int components = 1;
    std::vector<float> values = {};  // `components` for each vertex
    bool vector = false;             // world x, y, z; turns with the mesh
};

/// The position of a vertex's label in its domain, 0 .. 1 along each side.
inline constexpr std::string_view kUv = "uv";

/// Triangles with a normal at each vertex, z up, in metres.
struct Mesh {
    std::vector<float> positions;            // x, y, z of each vertex
    std::vector<float> normals = {};         // x, y, z of each vertex; or empty
    std::vector<Attribute> attributes = {};  // with distinct names
    std::vector<int> triangles = {};    // three vertex indices each, counter-clockwise from above
    std::optional<Domain> domain = {};  // the covered domain; absent for a horizon mesh

    std::size_t vertices() const { return positions.size() / 3; }
    /// Returns the attribute of that name, or null.
    const Attribute* find(std::string_view name) const;
};

/// none: the mesh has neither triangles nor uv, because all frames share one file of them.
enum class Faces { none, triangles };

/// Returns the displaced surface over its domain, with normals, uv, and each product of `products`
/// for which the surface has all channels, in their order. Needs height; without dx and dy vertices
/// lie straight above their samples. Throws Error invalid_value for a surface without height or
/// with fewer than two samples along a side.
///
/// A domain that wraps has (N + 1)^2 vertices, which close the seam. They are rounded to a grid of
/// a power of two (2^-16 m, coarser for large patches); copies a period apart then have no cracks
/// if the period is on the grid too, as every whole number is. The vertices of a domain that does
/// not wrap are its samples.
Mesh make_patch_mesh(const Surface& surface, Faces faces = Faces::triangles,
                     std::span<const Product> products = product_table());

/// Turns positions, normals and vectors from z up to y up: (x, y, z) becomes (x, z, -y).
void turn_y_up(Mesh& mesh);

/// Returns the number of vertices of a patch mesh along x and along y.
std::array<int, 2> patch_vertices(const Domain& domain);
/// Return the triangles of a patch mesh, which depend on the number of samples only.
std::vector<int> patch_triangles(const Domain& domain);
std::vector<int> patch_triangles(int resolution);
/// Removes from the triangles of a patch mesh the squares of which no end of the diagonal lies
/// where `dry`, the mask's value at each vertex, is below 0.5: the water inside of hulls.
void cut_dry_squares(const Domain& domain, std::span<const float> dry, std::vector<int>& triangles);
/// Returns the uv of a patch mesh, two numbers for each vertex: 0 at the first vertex of a side, 1
/// at the last.
std::vector<float> patch_uv(const Domain& domain);

// ---- Points

/// Points as parallel arrays, z up, in metres and seconds.
struct Points {
    std::vector<float> positions;    // x, y, z [m]
    std::vector<float> velocities;   // x, y, z [m/s]
    std::vector<float> ages;         // time since birth [s]
    std::vector<float> lives;        // age at death [s]
    std::vector<float> radii;        // [m]
    std::vector<std::uint64_t> ids;  // the same in every frame

    std::size_t size() const { return ids.size(); }
};
/// Returns the memory of `count` points [bytes].
constexpr std::uint64_t points_bytes(std::uint64_t count) {
    constexpr std::uint64_t kFloats = 9;
    return count * (kFloats * sizeof(float) + sizeof(std::uint64_t));
}
/// Turns positions and velocities from z up to y up: (x, y, z) becomes (x, z, -y).
void turn_y_up(Points& points);

/// Writes binary PLY, little-endian: vertices x, y, z, vx, vy, vz, age, life, radius as floats, and
/// id_low and id_high as uints, because PLY has no 64-bit integers: id = id_high 2^32 + id_low.
/// read_ply_header reads the header. Throws Error output.
void write_ply(const Points& points, std::span<const HeaderString> strings,
               const std::string& path);
/// Returns an upper bound of the size of a PLY file of points without its comments [bytes].
std::uint64_t points_ply_bytes(std::uint64_t count);

// ---- Files

/// Writes binary PLY, little-endian: vertices x, y, z with nx, ny, nz and all attributes of the
/// mesh (s, t; foam; vx, vy, vz ...), faces vertex_indices. Throws Error output.
void write_ply(const Mesh& mesh, std::span<const HeaderString> strings, const std::string& path);
/// Returns the header strings of a PLY file. Throws Error bad_file.
std::vector<HeaderString> read_ply_header(const std::string& path);

/// Writes Wavefront OBJ: v, with the first attribute of one component as its grey; vt, vn and f if
/// the mesh has them. Throws Error output.
void write_obj(const Mesh& mesh, std::span<const HeaderString> strings, const std::string& path);
/// Returns the header strings of an OBJ file. Throws Error bad_file.
std::vector<HeaderString> read_obj_header(const std::string& path);

/// Return upper bounds of the sizes of PLY and OBJ files without their comments [bytes].
std::uint64_t ply_bytes(std::uint64_t vertices, std::uint64_t floats, std::uint64_t triangles);
std::uint64_t max_obj_bytes(std::uint64_t vertices, std::uint64_t floats, std::uint64_t triangles);

}  // namespace ocean::io
