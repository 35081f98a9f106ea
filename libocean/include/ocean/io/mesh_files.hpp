// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes as the files that most programs read. Each says by comments which sea it is and when.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "ocean/io/mesh.hpp"
#include "ocean/io/provenance.hpp"

namespace ocean::io {

/// Writes binary PLY, little-endian: vertices x, y, z with nx, ny, nz and all attributes that the
/// mesh has (s, t; foam; vx, vy, vz ...), faces vertex_indices. Throws Error output.
void write_ply(const Mesh& mesh, std::span<const HeaderString> strings, const std::string& path);
/// Of such a file. Throws Error bad_file.
std::vector<HeaderString> read_ply_header(const std::string& path);

/// Writes Wavefront OBJ: v, with the first attribute of one component as its grey; vt, vn, f, where
/// the mesh has them. Throws Error output.
void write_obj(const Mesh& mesh, std::span<const HeaderString> strings, const std::string& path);
/// Of such a file. Throws Error bad_file.
std::vector<HeaderString> read_obj_header(const std::string& path);

/// Bytes of such files, at most, without their comments.
std::uint64_t ply_bytes(std::uint64_t vertices, std::uint64_t floats, std::uint64_t triangles);
std::uint64_t most_obj_bytes(std::uint64_t vertices, std::uint64_t floats, std::uint64_t triangles);

}  // namespace ocean::io
