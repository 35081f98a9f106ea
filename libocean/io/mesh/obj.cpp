// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_header.hpp"
#include "ocean/io/mesh_files.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/io/text_writer.hpp"

namespace ocean::io {
namespace {

constexpr std::string_view kMagic = "# The surface of a sea at one time, by libocean\n";
constexpr std::string_view kComment = "#";
constexpr std::string_view kObject = "\no sea\n";

void write_vector(TextWriter& out, std::string_view word, const float* v) {
    out << word;
    for (int i = 0; i < 3; ++i) (out << " ").number(v[i]);
}

}  // namespace

void write_obj(const Mesh& mesh, std::span<const HeaderString> strings, const std::string& path) {
    OutputFile file(path);
    TextWriter out(file);
    out << kMagic << comment_lines(strings, kComment) << kObject.substr(1);
    for (std::size_t v = 0; v < mesh.positions.size() / 3; ++v) {
        write_vector(out, "v", &mesh.positions[3 * v]);
        if (!mesh.foam.empty()) {
            for (int i = 0; i < 3; ++i) (out << " ").number(mesh.foam[v]);
        }
        out << "\n";
    }
    for (std::size_t v = 0; v < mesh.normals.size() / 3; ++v) {
        write_vector(out, "vn", &mesh.normals[3 * v]);
        out << "\n";
    }
    for (std::size_t corner = 0; corner < mesh.triangles.size(); ++corner) {
        out << (corner % 3 == 0 ? "f " : " ");
        const int vertex = mesh.triangles[corner] + 1;
        out.number(vertex);
        if (!mesh.normals.empty()) (out << "//").number(vertex);
        if (corner % 3 == 2) out << "\n";
    }
    out.flush();
    file.commit();
}

std::vector<HeaderString> read_obj_header(const std::string& path) {
    return read_comments(path, kMagic, kObject, kComment);
}

std::uint64_t most_obj_bytes(std::uint64_t vertices, std::uint64_t floats,
                             std::uint64_t triangles) {
    // "-1.2345678e-05 ", "2147483647//2147483647 ", and the words of the lines.
    constexpr std::uint64_t kHead = 1024, kNumber = 15, kCorner = 23, kLine = 4;
    return kHead + vertices * (floats * kNumber + 2 * kLine) + triangles * (3 * kCorner + kLine);
}

}  // namespace ocean::io
