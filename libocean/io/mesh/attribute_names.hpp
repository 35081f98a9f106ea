// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The spellings of a mesh's attributes in files: the names that readers know, and a rule for all
// others.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ocean/io/mesh.hpp"

namespace ocean::io {

inline constexpr std::string_view kNormal = "normal";

/// Returns a property for each component: "s", "t" of uv, which Blender and MeshLab read; "foam";
/// "slope_x", "slope_y".
std::vector<std::string> ply_names(const Attribute& attribute);

struct UsdName {
    std::string name;          // "primvars:foam"
    std::string type;          // "float[]"
    bool interpolated = true;  // its interpolation must be declared
};
UsdName usd_name(const Attribute& attribute);

/// Returns the normals of a mesh as one of its attributes, without their values.
Attribute normal_attribute();

}  // namespace ocean::io
