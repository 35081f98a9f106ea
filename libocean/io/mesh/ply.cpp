// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cstring>

#include "mesh_header.hpp"
#include "ocean/error.hpp"
#include "ocean/io/mesh_files.hpp"
#include "ocean/io/output_file.hpp"

namespace ocean::io {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t kPiece = std::size_t{1} << 20;
constexpr std::string_view kComment = "comment";
constexpr std::uint64_t kFaceBytes = 1 + 3 * sizeof(std::int32_t);

/// Bytes on their way to a file.
class ByteWriter {
  public:
    explicit ByteWriter(OutputFile& file) : file_(file) { buffer_.reserve(kPiece + 64); }

    template <typename Value>
    void put(const Value* values, std::size_t count) {
        buffer_.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
        if (buffer_.size() >= kPiece) flush();
    }
    void flush() {
        file_.write(buffer_);
        buffer_.clear();
    }

  private:
    OutputFile& file_;
    std::string buffer_;
};

std::string header(const Mesh& mesh, std::span<const HeaderString> strings) {
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    text += comment_lines(strings, kComment);
    const auto properties = [&](std::initializer_list<const char*> names) {
        for (const char* name : names) text += "property float " + std::string(name) + "\n";
    };
    text += "element vertex " + std::to_string(mesh.positions.size() / 3) + "\n";
    properties({"x", "y", "z"});
    if (!mesh.normals.empty()) properties({"nx", "ny", "nz"});
    if (!mesh.foam.empty()) properties({"foam"});
    if (!mesh.velocities.empty()) properties({"vx", "vy", "vz"});
    text += "element face " + std::to_string(mesh.triangles.size() / 3) + "\n";
    return text + "property list uchar int vertex_indices\nend_header\n";
}

}  // namespace

void write_ply(const Mesh& mesh, std::span<const HeaderString> strings, const std::string& path) {
    OutputFile file(path);
    file.write(header(mesh, strings));
    ByteWriter out(file);
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
    out.flush();
    file.commit();
}

std::vector<HeaderString> read_ply_header(const std::string& path) {
    return read_comments(path, "ply\n", "\nend_header\n", kComment);
}

std::uint64_t ply_bytes(std::uint64_t vertices, std::uint64_t floats, std::uint64_t triangles) {
    constexpr std::uint64_t kHead = 1024;
    return kHead + vertices * floats * sizeof(float) + triangles * kFaceBytes;
}

}  // namespace ocean::io
