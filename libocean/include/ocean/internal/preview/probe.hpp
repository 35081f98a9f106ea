// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers of the drawn water or land, read back from the drawing itself.
#pragma once

#include <array>
#include <optional>

#include "ocean/internal/preview/renderer.hpp"

namespace ocean::preview {

/// The drawn water at a place of the world; where water is folded, its highest sheet.
struct Probe {
    double mesh_height;      // of the triangle at that place [m]
    double map_height;       // of the maps at its label, as the pixel's light uses it [m]
    double shown_slope;      // square of the slope that the pixel shows
    double handed_on_slope;  // mean square slope that the light receives as roughness
    double cover;            // share of the pixel that is foam
};

/// Returns the numbers at a place [m] of the mesh that the camera sees, or nothing where no water
/// is drawn. cascade: as in DrawOptions. Changes the bound framebuffer and the viewport. Throws
/// Error.
std::optional<Probe> probe(Renderer& renderer, const DrawnSea& sea, const Camera& camera,
                           const std::array<double, 2>& place, int cascade = -1);

/// The drawn land at a place of the world.
struct LandProbe {
    double mesh_height;  // of the triangle at that place [m]
    double map_height;   // of the map's cubic patch, which the mesh follows near the eye [m]
    double shown_slope;  // square of the slope that the pixel shows
};

/// Returns the numbers of land at a place [m], as probe() does for a sea.
std::optional<LandProbe> probe(Renderer& renderer, const DrawnLand& land, const Camera& camera,
                               const std::array<double, 2>& place);

}  // namespace ocean::preview
