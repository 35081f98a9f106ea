// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a picture of the sea is of: from where, in which light, and which of its fields.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/preview/environment.hpp"

namespace ocean::preview {

struct Camera {
    std::array<double, 3> eye = {0.0, 0.0, 8.0};  // m; z above still water
    double heading = 0.0;         // degrees counter-clockwise from +x, the way that it looks
    double pitch = -4.0;          // degrees above the horizontal, -90 .. 90
    double field_of_view = 60.0;  // degrees, horizontal

    /// Turned towards a point.
    void look_at(const std::array<double, 3>& point);
    /// Where the line of sight through a place of the picture (0 .. 1 from its left and from its
    /// top; aspect = width/height) meets a level, metres over still water; nothing if it does not.
    std::optional<std::array<double, 2>> meet_level(double from_left, double from_top,
                                                    double aspect, double level) const;
};

/// physical: the sea to its horizon under its sky. seed: as the teaching programs drew it that the
/// library continues: ten by ten periods as a flat mesh in plain light, in fog; of all of Look it
/// takes the sun's direction alone.
enum class LookKind { physical, seed };
std::vector<std::string> look_names();
/// Throws Error invalid_value.
LookKind look_of(std::string_view name);

/// The light and the water: nothing of the waves.
struct Look {
    LookKind kind = LookKind::physical;
    double sun_altitude = 35.0;  // degrees
    double sun_bearing = 70.0;   // degrees counter-clockwise from +x, where it stands
    /// Instead of the computed sky, with the sun that is in it; the renderer keeps the last one.
    std::shared_ptr<const Environment> environment = nullptr;
    double environment_turn = 0.0;  // degrees counter-clockwise, seen from above
    double exposure = 1.0;
    double visibility = 60e3;  // m, after which 2 % of contrasts are left; 0: no haze
    std::string water_type = "jerlov_ii";
    double crest_light = 1.0;  // of the sun, through crests; 0: none
    double foam_amount = 1.0;
    bool repeats = false;  // to the horizon, as its one period does
};

enum class View {
    shaded,
    height,
    displacement_x,
    displacement_y,
    normal,
    slope,
    jacobian,
    whitecap,
    foam,
    numbers,  // for probes, see shaders/preview/water.frag
    foam_numbers,
};
/// The names of all that can be shown: "shaded", "displacement_x" ...
std::vector<std::string> view_names();
/// Throws Error invalid_value.
View view_of(std::string_view name);

}  // namespace ocean::preview
