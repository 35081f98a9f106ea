// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The water or the ground under the mouse.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "live_scene.hpp"
#include "ocean/internal/preview/probe.hpp"

namespace ocean::app {

/// Returns the point of the sea that the line of sight through a place of the picture meets, by a
/// few steps of the query, and its height and normal; nothing if it meets none. The place is 0 .. 1
/// from the left and from the top; aspect = width/height. Throws Error.
struct PickedWater {
    WorldPoint point;
    QuerySample sample;
};
std::optional<PickedWater> pick_water(LiveSea& sea, const preview::Camera& camera,
                                      const std::array<double, 2>& place, double aspect);

/// Returns lines for a person: place, height [m], normal, and the share of foam that is drawn
/// there. Changes the bound framebuffer and the viewport. Throws Error.
std::string describe(const PickedWater& picked, preview::Renderer& renderer,
                     const preview::DrawnSea& shown, const preview::Camera& camera, int cascade);

/// Returns the first point of the ground that a line of sight through a place of the picture meets,
/// within a hundred tiles; nothing if it meets none. The place and aspect are those of pick_water.
std::optional<WorldPoint> pick_ground(const preview::DrawnLand& land, const preview::Camera& camera,
                                      const std::array<double, 2>& place, double aspect);

/// Returns lines for a person: place, height [m], slope and normal by a query of the land. Throws
/// Error.
std::string describe(const WorldPoint& point, LiveLand& land);

}  // namespace ocean::app
