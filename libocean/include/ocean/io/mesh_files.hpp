// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes as PLY and OBJ, with their provenance in comments.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "ocean/io/mesh.hpp"
#include "ocean/provenance.hpp"

namespace ocean::io {

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
