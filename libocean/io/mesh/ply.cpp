// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "attribute_names.hpp"
#include "mesh_header.hpp"
#include "ocean/io/mesh.hpp"
#include "ply_writer.hpp"

namespace ocean::io {
namespace {

constexpr std::uint64_t kFaceBytes = 1 + 3 * sizeof(std::int32_t);

/// Consecutive numbers of each vertex.
struct Column {
    const std::vector<float>& values;
    std::size_t components;
};

PlyHeader header_of(const Mesh& mesh, std::span<const HeaderString> strings) {
    PlyHeader header(strings);
    header.element("vertex", mesh.vertices());
    header.properties("float", {"x", "y", "z"});
    if (!mesh.normals.empty()) header.properties("float", ply_names(normal_attribute()));
    for (const Attribute& attribute : mesh.attributes) {
        header.properties("float", ply_names(attribute));
    }
    header.element("face", mesh.triangles.size() / 3);
    header.properties("list uchar int", {"vertex_indices"});
    return header;
}

}  // namespace

void write_ply(const Mesh& mesh, std::span<const HeaderString> strings, const std::string& path) {
    std::vector<Column> columns = {{mesh.positions, 3}};
    if (!mesh.normals.empty()) columns.push_back({mesh.normals, 3});
    for (const Attribute& attribute : mesh.attributes) {
        columns.push_back({attribute.values, static_cast<std::size_t>(attribute.components)});
    }
    PlyWriter out(path, header_of(mesh, strings));
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        for (const auto& [values, components] : columns) {
            out.put(&values[components * v], components);
        }
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
    return kMaxPlyHead + vertices * floats * sizeof(float) + triangles * kFaceBytes;
}

}  // namespace ocean::io
