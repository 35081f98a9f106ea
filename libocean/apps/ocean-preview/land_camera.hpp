// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The first camera over solid ground, which may lie at any height.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "ocean/domain.hpp"
#include "preview_options.hpp"
#include "scene.hpp"

namespace ocean::app {

inline constexpr double kEyeHeight = 1.7;  // [m], of a person who stands, or sits in a boat

/// Puts the eye of `options` over solid ground: --eye X,Y at a person's height, without --eye as
/// high as the ground says, over its middle or where the ground has an outlook, and --eye X,Y,Z
/// where it is, but not in the ground. Returns a warning if the eye was raised, else "".
std::string place_on_ground(const PreviewOptions& options, const CameraGround& ground,
                            preview::Camera& camera);

/// Returns the middle of a domain that exists once [m].
std::optional<std::array<double, 2>> middle_of(const Domain& domain);

}  // namespace ocean::app
