// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A mesh as a POV-Ray include file. POV-Ray is left-handed with y up: y and z are swapped in points
// and normals. A number is the shortest text that reads back as the same float, so that common
// vertices stay common.
#include "ocean/internal/io/mesh2.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/povray_declarations.hpp"
#include "ocean/internal/io/subject_words.hpp"
#include "ocean/internal/io/text_writer.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/version.hpp"

namespace ocean::io {
namespace {

// Writes a number from -1 to 1. Four decimals are 0.003 degrees; ".1234" instead of "0.1234" saves
// a tenth of the file.
TextWriter& write_unit(TextWriter& out, float value) {
    const long scaled = std::lround(value * 10000.0f);
    if (scaled < 0) out << "-";
    const long magnitude = std::labs(scaled);
    if (magnitude >= 10000) return out << "1";
    char text[] = {'.', '0', '0', '0', '0'};
    long digits = magnitude;
    for (int place = 4; place > 0; --place, digits /= 10) {
        text[place] = static_cast<char>('0' + digits % 10);
    }
    return out << std::string_view(text, sizeof text);
}

/// Writes a pair as <east, north>.
void write_pair(TextWriter& out, std::array<double, 2> pair) {
    out << "<";
    out.number(pair[0]) << ", ";
    out.number(pair[1]) << ">";
}

void write_domain(TextWriter& out, const std::string& prefix, const Domain& domain) {
    if (domain.is_tile()) {
        out << "#declare " << prefix << "Period = ";
        out.number(domain.size[0]) << ";  // m, in both directions\n";
        return;
    }
    write_pair(out << "#declare " << prefix << "Origin = ", domain.origin);
    write_pair(
        out << ";  // m, of its first vertex, <east, north>\n#declare " << prefix << "Size = ",
        domain.size);
    out << ";  // m\n";
}

void write_head(TextWriter& out, const Mesh& mesh, const Provenance& provenance,
                std::string file_name) {
    const SubjectWords words = subject_words(provenance.kind);
    const std::string prefix = words.prefix();
    // A line break in the name would end the comment.
    std::replace_if(
        file_name.begin(), file_name.end(),
        [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; }, '?');
    out << "//   Persistence of Vision Ray Tracer Include File\n//   File: " << file_name
        << "\n//   Vers: 3.7\n//   Desc: " << words.phrase()
        << (provenance.kind == kSeaKind && provenance.time ? " at one time" : "")
        << ", by libocean " OCEAN_VERSION << "\n//         " << prefix << "Surface: mesh2 of ";
    out.number(mesh.positions.size() / 3) << " vertices with normals, metres, <east, up, north>.\n";
    // The file has no include guard: a frame that is loaded again becomes the current one.
    out << "#declare " << prefix << "Mesh_Inc_Temp = version;\n#version 3.7;\n\n";
    out << povray_frame_declarations(provenance);
    write_domain(out, prefix, *provenance.domain);
}

// Declares the camera that the mesh was made for, so that a scene need not look past its edge.
void write_view(TextWriter& out, const std::string& prefix, const View& view) {
    const double heading = view.heading * kPi / 180.0;
    out << "// The camera that this mesh was made for.\n#declare " << prefix << "Eye = <";
    out.number(view.x) << ", ";
    out.number(view.height) << ", ";
    out.number(view.y) << ">;\n#declare " << prefix << "Forward = <";
    out.number(std::cos(heading)) << ", 0, ";
    out.number(std::sin(heading)) << ">;\n#declare " << prefix << "View_Angle = ";
    out.number(view.field_of_view) << ";  // degrees, horizontal\n";
}

void write_vectors(TextWriter& out, const Mesh& mesh, const Attribute* u) {
    const std::size_t count = mesh.positions.size() / 3;
    out << "vertex_vectors { ";
    out.number(count);
    for (std::size_t v = 0; v < count; ++v) {
        const float* p = &mesh.positions[3 * v];
        out << ",\n<";
        out.number(p[0]) << ",";
        out.number(p[2]) << ",";
        out.number(p[1]) << ">";
    }
    out << "\n}\nnormal_vectors { ";
    out.number(count);
    for (std::size_t v = 0; v < count; ++v) {
        const float* n = &mesh.normals[3 * v];
        write_unit(out << ",\n<", n[0]) << ",";
        write_unit(out, n[2]) << ",";
        write_unit(out, n[1]) << ">";
    }
    out << "\n}\n";
    if (u == nullptr) return;
    out << "uv_vectors { ";
    out.number(count);
    for (const float share : u->values) {
        write_unit(out << ",\n<", share) << ",0>";
    }
    out << "\n}\n";
}

void write_faces(TextWriter& out, std::span<const int> triangles) {
    const std::size_t count = triangles.size() / 3;
    out << "face_indices { ";
    out.number(count);
    for (std::size_t f = 0; f < count; ++f) {
        const int* corner = &triangles[3 * f];
        out << ",\n<";
        out.number(corner[0]) << ",";
        out.number(corner[1]) << ",";
        out.number(corner[2]) << ">";
    }
    out << "\n}\n";
}

}  // namespace

std::string povray_faces(std::span<const int> triangles) {
    TextWriter out;
    write_faces(out, triangles);
    return out.text();
}

void write_mesh2(const Mesh& mesh, const Provenance& provenance, const std::string& path,
                 const Mesh2Extras& extras) {
    if (mesh.positions.empty() || mesh.normals.size() != mesh.positions.size() ||
        mesh.triangles.empty()) {
        throw Error(ErrorKind::invalid_value, "a mesh2 needs vertices, as many normals, triangles");
    }
    if (!provenance.domain) {
        throw Error(ErrorKind::invalid_value, "a mesh2 of POV-Ray needs a place and a size");
    }
    const std::string prefix = subject_words(provenance.kind).prefix();
    OutputFile file(path);
    TextWriter out(file);
    write_head(out, mesh, provenance, utf8_path(path).filename().string());
    if (extras.view != nullptr) write_view(out, prefix, *extras.view);
    out << "\n#declare " << prefix << "Surface = mesh2 {\n";
    write_vectors(out, mesh, mesh.find(extras.u));
    write_faces(out, mesh.triangles);
    // A sheet is not a solid, but an inside_vector lets it cut other objects. It is off the axis,
    // so that the test ray does not pass along vertices and edges.
    out << "inside_vector <0.0131, 1, 0.0073>\n}\n\n#version " << prefix << "Mesh_Inc_Temp;\n";
    out.flush();
    file.commit();
}

}  // namespace ocean::io
