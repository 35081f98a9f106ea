// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes as POV-Ray include files.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ocean/internal/io/horizon_mesh.hpp"
#include "ocean/internal/io/provenance.hpp"
#include "ocean/io/mesh.hpp"

namespace ocean::io {

/// Returns triangles as the face_indices of a mesh2.
std::string povray_faces(std::span<const int> triangles);
/// Optional parts of a mesh2.
struct Mesh2Extras {
    const View* view = nullptr;  // the camera of a horizon mesh
    std::string_view u = {};     // name of the one-component attribute that becomes u
};

/// Writes a POV-Ray include file that declares `Ocean_Surface` as a mesh2 in POV-Ray's axes
/// (x, z, y), and Ocean_Time, Ocean_Frame_Number and Ocean_Period, or Ocean_Origin and Ocean_Size
/// for a domain that does not wrap; with a view also its camera: Ocean_Eye, Ocean_Forward,
/// Ocean_View_Angle. The names of other subjects have their own prefix. Throws Error output, and
/// invalid_value for a mesh without normals or a provenance without a domain.
void write_mesh2(const Mesh& mesh, const Provenance& provenance, const std::string& path,
                 const Mesh2Extras& extras = {});

}  // namespace ocean::io
