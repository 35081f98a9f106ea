// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_header.hpp"
#include "ocean/io/mesh_files.hpp"
#include "ply_writer.hpp"

namespace ocean::io {
namespace {

constexpr std::uint64_t kFaceBytes = 1 + 3 * sizeof(std::int32_t);

PlyHeader header_of(const Mesh& mesh, std::span<const HeaderString> strings) {
    PlyHeader header(strings);
    header.element("vertex", mesh.positions.size() / 3);
    header.properties("float", {"x", "y", "z"});
    if (!mesh.normals.empty()) header.properties("float", {"nx", "ny", "nz"});
    if (!mesh.foam.empty()) header.properties("float", {"foam"});
    if (!mesh.velocities.empty()) header.properties("float", {"vx", "vy", "vz"});
    header.element("face", mesh.triangles.size() / 3);
    header.properties("list uchar int", {"vertex_indices"});
    return header;
}

}  // namespace

void write_ply(const Mesh& mesh, std::span<const HeaderString> strings, const std::string& path) {
    PlyWriter out(path, header_of(mesh, strings));
    for (std::size_t v = 0; v < mesh.positions.size() / 3; ++v) {
        out.put(&mesh.positions[3 * v], 3);
        if (!mesh.normals.empty()) out.put(&mesh.normals[3 * v], 3);
        if (!mesh.foam.empty()) out.put(&mesh.foam[v], 1);
        if (!mesh.velocities.empty()) out.put(&mesh.velocities[3 * v], 3);
    }
    constexpr std::uint8_t kCorners = 3;
    for (std::size_t corner = 0; corner < mesh.triangles.size(); corner += kCorners) {
        out.put(&kCorners, 1);
        out.put(&mesh.triangles[corner], kCorners);
    }
    out.commit();
}

std::vector<HeaderString> read_ply_header(const std::string& path) {
    return read_comments(path, "ply\n", "\nend_header\n", kPlyComment);
}

std::uint64_t ply_bytes(std::uint64_t vertices, std::uint64_t floats, std::uint64_t triangles) {
    return kMostPlyHead + vertices * floats * sizeof(float) + triangles * kFaceBytes;
}

}  // namespace ocean::io
