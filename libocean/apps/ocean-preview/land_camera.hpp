// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The first camera of a land or a coast, whose ground may lie at any height.
#pragma once

#include <string>

#include "ocean/internal/preview/coast_maps.hpp"
#include "ocean/internal/preview/land_maps.hpp"
#include "preview_options.hpp"

namespace ocean::app {

inline constexpr double kEyeHeight = 1.7;  // [m], of a person who stands, or sits in a boat

/// Returns the lowest eye over a ground that it does not cut [m]: a part of the eye's height, or of
/// the finest cell of the mesh where that is wide.
double lowest_eye(const preview::DrawnLand& land);
double lowest_eye(const preview::DrawnCoast& coast);

/// Puts the eye of `options` over the ground: --eye X,Y at a person's height, without --eye a
/// quarter of the rms height above it, of land that exists once over its middle, and --eye X,Y,Z
/// where it is, but not in the ground. Returns a warning if the eye was raised, else "".
std::string place_on_land(const PreviewOptions& options, const preview::DrawnLand& land,
                          preview::Camera& camera);
/// Puts the eye over the ground and the water of a coast as place_on_land() does, without --eye
/// over the middle of its bed.
std::string place_on_coast(const PreviewOptions& options, const preview::DrawnCoast& coast,
                           preview::Camera& camera);
/// Returns the place that place_on_coast() gives the eye before it knows the water.
std::array<double, 3> eye_on_coast(const PreviewOptions& options, const SeaBed& bed);

}  // namespace ocean::app
