// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sky that was photographed or painted instead of the one that is computed.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ocean::preview {

/// The sun of an environment, as the water mirrors it: a glitter, and no texels.
struct EnvironmentSun {
    std::array<double, 3> direction;  // to it, a unit vector
    std::array<double, 3> colour;     // what a white surface that faces it sends: irradiance/pi
};

/// Light of the sky above the horizon, over longitude and latitude, without its sun. A value of
/// make_environment.
struct Environment {
    int width = 0;           // all around; the middle looks along +x, what is right of it clockwise
    int height = 0;          // from the horizon to the zenith
    std::vector<float> rgb;  // radiance, row after row, that over the horizon first
    std::optional<EnvironmentSun> sun;
    std::array<double, 3> light = {};  // of the rest on a level white surface: irradiance/pi
};

/// Of a picture of the whole sphere, its bottom row, the nadir, first: the upper half is taken, for
/// the sea hides the other. What is brighter than 4 times its surroundings where they are brightest
/// is cut off there, and is the sun if it gives at least 1/100 of all light. Throws Error
/// invalid_value unless the width is twice the height, which is even, and the light finite and not
/// negative.
Environment make_environment(int width, int height, std::span<const float> rgb);

}  // namespace ocean::preview
