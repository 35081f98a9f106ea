// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A photographed or painted sky in place of the computed one.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ocean::preview {

/// The sun of an environment. The water mirrors it as glitter, not as texels.
struct EnvironmentSun {
    std::array<double, 3> direction;  // towards the sun, a unit vector
    std::array<double, 3> colour;     // radiance of a white surface that faces it: irradiance/pi
};

/// Light of the sky above the horizon, over longitude and latitude, without its sun; made by
/// make_environment.
struct Environment {
    int width = 0;   // a full turn: the middle column lies along +x, columns right of it clockwise
    int height = 0;  // from the horizon to the zenith
    std::vector<float> rgb;  // radiance, row after row, the row at the horizon first
    std::optional<EnvironmentSun> sun;
    std::array<double, 3> light =
        {};  // light of the sky, sun left out, on a level white surface: irradiance/pi
};

/// Returns the environment of a picture of the whole sphere, with its bottom row, the nadir, first.
/// Only the upper half counts, because the sea hides the lower one. Light at the brightest place
/// above 4 times its surroundings is cut off, and becomes the sun if it is at least 1/100 of all
/// light. Throws Error invalid_value unless the width is twice the height, the height even, and the
/// light finite and not negative.
Environment make_environment(int width, int height, std::span<const float> rgb);

}  // namespace ocean::preview
