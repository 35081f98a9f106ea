// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers of what is drawn, read back from the drawing itself.
#pragma once

#include <array>
#include <optional>

#include "ocean/preview/renderer.hpp"

namespace ocean::preview {

/// At a place of the world, of the top sheet.
struct Probe {
    double mesh_height;      // m, of the triangle that is drawn there
    double map_height;       // m, of the maps at its label, as the fragment's light has it
    double shown_slope;      // square of the slope that the fragment shows
    double handed_on_slope;  // mean square slope that it gives to the light as roughness
    double cover;            // share of it that is foam
};

/// Of the mesh that the camera sees; nothing where it draws nothing. cascade: as in DrawOptions.
std::optional<Probe> probe(Renderer& renderer, const ShownSea& sea, const Camera& camera,
                           const std::array<double, 2>& place, int cascade = -1);

}  // namespace ocean::preview
