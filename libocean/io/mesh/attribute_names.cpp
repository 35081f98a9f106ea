// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "attribute_names.hpp"

#include <algorithm>
#include <array>

namespace ocean::io {
namespace {

/// The names that readers know.
struct KnownName {
    std::string_view name;
    std::array<std::string_view, 3> ply;
    std::string_view usd, usd_type;
    bool usd_interpolated = true;
};
constexpr std::array kKnownNames = {
    KnownName{kUv, {"s", "t"}, "primvars:st", "texCoord2f[]"},
    KnownName{kNormal, {"nx", "ny", "nz"}, "normals", "normal3f[]"},
    KnownName{"velocity", {"vx", "vy", "vz"}, "velocities", "vector3f[]", false},
};

const KnownName* find_known(const Attribute& attribute) {
    const auto known = std::ranges::find(kKnownNames, attribute.name, &KnownName::name);
    return known == kKnownNames.end() ? nullptr : &*known;
}

}  // namespace

std::vector<std::string> ply_names(const Attribute& attribute) {
    const KnownName* known = find_known(attribute);
    std::vector<std::string> names;
    for (int c = 0; c < attribute.components; ++c) {
        const auto component = static_cast<std::size_t>(c);
        if (known != nullptr) {
            names.emplace_back(known->ply[component]);
        } else if (attribute.components == 1) {
            names.push_back(attribute.name);
        } else {
            names.push_back(attribute.name + '_' + "xyzw"[component]);
        }
    }
    return names;
}

UsdName usd_name(const Attribute& attribute) {
    if (const KnownName* known = find_known(attribute)) {
        return {std::string(known->usd), std::string(known->usd_type), known->usd_interpolated};
    }
    std::string type = "float[]";
    if (attribute.components > 1) type.insert(5, std::to_string(attribute.components));
    return {"primvars:" + attribute.name, attribute.vector ? "vector3f[]" : type};
}

Attribute normal_attribute() {
    return {.name = std::string(kNormal), .components = 3, .vector = true};
}

}  // namespace ocean::io
