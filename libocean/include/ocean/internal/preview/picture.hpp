// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The camera, the light and the view of a picture of a sea or of land.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/preview/environment.hpp"

namespace ocean::preview {

struct Camera {
    std::array<double, 3> eye = {0.0, 0.0, 8.0};  // [m]; z above still water
    double heading = 0.0;         // [degrees] counter-clockwise from +x, of the line of sight
    double pitch = -4.0;          // [degrees] above the horizontal, -90 .. 90
    double field_of_view = 60.0;  // [degrees], horizontal

    /// Turns the camera towards a point [m].
    void look_at(const std::array<double, 3>& point);
    /// Returns the unit vector of the line of sight through a place of the picture, which is 0 .. 1
    /// from the left and from the top; aspect = width/height.
    std::array<double, 3> line_of_sight(double from_left, double from_top, double aspect) const;
    /// Returns the point [m] where the line of sight through a place of the picture meets a level
    /// [m] over still water, or nothing. The place is 0 .. 1 from the left and from the top; aspect
    /// = width/height.
    std::optional<std::array<double, 2>> meet_level(double from_left, double from_top,
                                                    double aspect, double level) const;

  private:
    /// A line of sight along the heading, to its right and up.
    struct Sight {
        double ahead, right, rise;
    };
    Sight sight(double from_left, double from_top, double aspect) const;
};

/// physical: the sea to its horizon under its sky. seed: ten by ten periods as a flat mesh in plain
/// light and fog, as drawn by the teaching programs that the library continues. Of Look it uses the
/// sun's direction alone.
enum class LookKind { physical, seed };
std::vector<std::string> look_names();
/// Returns the look of that name. Throws Error invalid_value.
LookKind look_of(std::string_view name);

/// The kinds of scenes that the renderer draws.
enum class SceneKind { sea, land };

/// land: by height, slope and exposure, with a snow line. seed: the teaching programs' two-colour
/// ramp over the height.
enum class LandColours { land, seed };
std::vector<std::string> land_colour_names();
/// Returns the colours of that name. Throws Error invalid_value.
LandColours land_colours_of(std::string_view name);

/// The light, the air, the water body and the colours of land; the waves are described elsewhere.
struct Look {
    LookKind kind = LookKind::physical;
    double sun_altitude = 35.0;  // [degrees]
    double sun_bearing = 70.0;   // [degrees] counter-clockwise from +x, of the direction to it
    /// A sky with its sun in place of the computed one. The renderer keeps the last environment.
    std::shared_ptr<const Environment> environment = nullptr;
    double environment_turn = 0.0;  // [degrees] counter-clockwise, seen from above
    double exposure = 1.0;
    double visibility = 60e3;  // [m], the distance that leaves 2 % of contrasts; 0: no haze
    std::string water_type = "jerlov_ii";
    double crest_light = 1.0;  // factor of the sun's light through crests; 0: none
    double foam_amount = 1.0;
    bool repeats = false;  // one period repeats to the horizon, without copies that hide it
    LandColours land_colours = LandColours::land;
    /// Height above which snow lies on level ground [m]; unset: by cover_lines().
    std::optional<double> snow_line = std::nullopt;
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
    numbers,       // for probes: four numbers of the water in each pixel
    foam_numbers,  // for tests: four numbers of the foam
};
/// Returns the names of a scene's views as users type them: "shaded", "displacement_x" ... A view
/// is an enumerator and a row of libocean/preview/view_table.hpp.
std::vector<std::string> view_names(SceneKind kind = SceneKind::sea);
/// Returns the view of that name. Throws Error invalid_value.
View view_of(std::string_view name, SceneKind kind = SceneKind::sea);

}  // namespace ocean::preview
