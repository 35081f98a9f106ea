// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes as POV-Ray include files.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ocean/io/horizon_mesh.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/io/provenance.hpp"

namespace ocean::io {

/// Triangles as the face_indices of a mesh2.
std::string povray_faces(std::span<const int> triangles);
/// What a mesh2 may have beside its triangles.
struct Mesh2Extras {
    const View* view = nullptr;  // the camera that it was made for
    std::string_view u = {};     // the attribute, of one component, that is the u of its uv
};

/// Writes a POV-Ray include file that declares `Ocean_Surface` as a mesh2 in POV-Ray's axes
/// (x, z, y), and Ocean_Time, Ocean_Frame_Number and Ocean_Period, or of a domain that is no tile
/// Ocean_Origin and Ocean_Size; with a view also its camera: Ocean_Eye, Ocean_Forward,
/// Ocean_View_Angle. Other subjects have a prefix of their own. Throws Error output, and
/// invalid_value for a mesh without normals or a provenance without a domain.
void write_mesh2(const Mesh& mesh, const Provenance& provenance, const std::string& path,
                 const Mesh2Extras& extras = {});

}  // namespace ocean::io
