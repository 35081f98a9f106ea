// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes as POV-Ray include files.
#pragma once

#include <span>
#include <string>

#include "ocean/io/horizon_mesh.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/io/provenance.hpp"

namespace ocean::io {

/// Triangles as the face_indices of a mesh2.
std::string povray_faces(std::span<const int> triangles);
/// A POV-Ray include file that declares `Ocean_Surface` as a mesh2 in POV-Ray's axes (x, z, y), and
/// Ocean_Time, Ocean_Period, Ocean_Frame_Number; foam is the u of its uv. With a view also its
/// camera: Ocean_Eye, Ocean_Forward, Ocean_View_Angle. Throws Error output.
void write_mesh2(const Mesh& mesh, const Provenance& provenance, const std::string& path,
                 const View* view = nullptr);

}  // namespace ocean::io
