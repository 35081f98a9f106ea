// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Binary PLY files of meshes and of points.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "attribute_names.hpp"
#include "mesh_header.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/provenance.hpp"
#include "ocean/io/mesh.hpp"
#include "turn_vectors.hpp"

namespace ocean::io {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view kPlyComment = "comment";
/// An upper bound of the header's size without its comments [bytes].
constexpr std::uint64_t kMaxPlyHead = 1024;

class PlyHeader {
  public:
    explicit PlyHeader(std::span<const HeaderString> strings)
        : text_("ply\nformat binary_little_endian 1.0\n" + comment_lines(strings, kPlyComment)) {}

    void element(const char* name, std::size_t count) {
        text_ += "element " + std::string(name) + " " + std::to_string(count) + "\n";
    }
    /// Adds a property to the last element.
    void properties(const std::string& type, const std::vector<std::string>& names) {
        for (const std::string& name : names) text_ += "property " + type + " " + name + "\n";
    }
    std::string text() const { return text_ + "end_header\n"; }

  private:
    std::string text_;
};

/// Throws Error output.
class PlyWriter {
  public:
    PlyWriter(const std::string& path, const PlyHeader& header) : file_(path) {
        file_.write(header.text());
        buffer_.reserve(kPiece + 64);
    }

    template <typename Value>
    void put(const Value* values, std::size_t count) {
        buffer_.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
        if (buffer_.size() >= kPiece) flush();
    }
    void commit() {
        flush();
        file_.commit();
    }

  private:
    static constexpr std::size_t kPiece = std::size_t{1} << 20;

    void flush() {
        file_.write(buffer_);
        buffer_.clear();
    }

    OutputFile file_;
    std::string buffer_;
};

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

void turn_y_up(Points& points) {
    turn_vectors_y_up(points.positions);
    turn_vectors_y_up(points.velocities);
}

void write_ply(const Points& points, std::span<const HeaderString> strings,
               const std::string& path) {
    PlyHeader header(strings);
    header.element("vertex", points.size());
    header.properties("float", {"x", "y", "z", "vx", "vy", "vz", "age", "life", "radius"});
    header.properties("uint", {"id_low", "id_high"});
    PlyWriter out(path, header);
    for (std::size_t i = 0; i < points.size(); ++i) {
        out.put(&points.positions[3 * i], 3);
        out.put(&points.velocities[3 * i], 3);
        const float scalars[] = {points.ages[i], points.lives[i], points.radii[i]};
        out.put(scalars, std::size(scalars));
        out.put(&points.ids[i], 1);  // little-endian, so the low half comes first
    }
    out.commit();
}

std::uint64_t points_ply_bytes(std::uint64_t count) {
    return kMaxPlyHead + points_bytes(count);
}

}  // namespace ocean::io
