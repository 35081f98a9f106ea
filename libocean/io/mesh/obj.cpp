// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "mesh_header.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/subject_words.hpp"
#include "ocean/internal/io/text_writer.hpp"
#include "ocean/io/mesh.hpp"

namespace ocean::io {
namespace {

constexpr std::string_view kMagic = "# The surface of ";
constexpr std::string_view kComment = "#";
constexpr std::string_view kObject = "\no ";

void write_head(TextWriter& out, std::span<const HeaderString> strings) {
    const SubjectWords words = subject_words(strings);
    out << "# " << words.phrase();
    if (std::ranges::find(strings, "ocean:time", &HeaderString::name) != strings.end()) {
        out << " at one time";
    }
    out << ", by libocean\n" << comment_lines(strings, kComment);
    out << kObject.substr(1) << words.kind << "\n";
}

void write_numbers(TextWriter& out, std::string_view word, std::span<const float> values) {
    out << word;
    for (const float value : values) (out << " ").number(value);
}

/// Returns the attribute that is stored as grey, the only place for one number in OBJ.
const Attribute* find_grey(const Mesh& mesh) {
    const auto grey = std::ranges::find(mesh.attributes, 1, &Attribute::components);
    return grey == mesh.attributes.end() ? nullptr : &*grey;
}

void write_vertices(TextWriter& out, const Mesh& mesh) {
    const Attribute* grey = find_grey(mesh);
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        write_numbers(out, "v", {&mesh.positions[3 * v], 3});
        if (grey != nullptr) {
            const float value = grey->values[v];
            write_numbers(out, "", std::array{value, value, value});
        }
        out << "\n";
    }
}

void write_lines(TextWriter& out, std::string_view word, std::span<const float> values,
                 std::size_t components) {
    for (std::size_t at = 0; at < values.size(); at += components) {
        write_numbers(out, word, values.subspan(at, components));
        out << "\n";
    }
}

void write_faces(TextWriter& out, const Mesh& mesh, bool has_uv) {
    for (std::size_t corner = 0; corner < mesh.triangles.size(); ++corner) {
        out << (corner % 3 == 0 ? "f " : " ");
        const int vertex = mesh.triangles[corner] + 1;
        out.number(vertex);
        if (has_uv) (out << "/").number(vertex);
        if (!mesh.normals.empty()) (out << (has_uv ? "/" : "//")).number(vertex);
        if (corner % 3 == 2) out << "\n";
    }
}

}  // namespace

void write_obj(const Mesh& mesh, std::span<const HeaderString> strings, const std::string& path) {
    OutputFile file(path);
    TextWriter out(file);
    write_head(out, strings);
    write_vertices(out, mesh);
    const Attribute* uv = mesh.find(kUv);
    if (uv != nullptr) write_lines(out, "vt", uv->values, 2);
    write_lines(out, "vn", mesh.normals, 3);
    write_faces(out, mesh, uv != nullptr);
    out.flush();
    file.commit();
}

std::vector<HeaderString> read_obj_header(const std::string& path) {
    return read_comments(path, kMagic, kObject, kComment);
}

std::uint64_t max_obj_bytes(std::uint64_t vertices, std::uint64_t floats, std::uint64_t triangles) {
    // The longest numbers are "-1.2345678e-05 " and "2147483647/2147483647/2147483647 "; lines have
    // keywords as well.
    constexpr std::uint64_t kHead = 1024, kNumber = 15, kCorner = 33, kLine = 4;
    return kHead + vertices * (floats * kNumber + 3 * kLine) + triangles * (3 * kCorner + kLine);
}

}  // namespace ocean::io
