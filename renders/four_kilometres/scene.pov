// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One whole period of 4 km from straight above: what repeats would show here, from the
// heights and the whitecaps of one frame. Lengths are metres, x east, y up, z north; north is up in
// the picture.
//   scripts/pictures four_kilometres/four_kilometres.jpg
#version 3.7;
global_settings { assumed_gamma 1.0 }

#declare Period = 4000;
#include "sea.png.inc"

camera {
    orthographic
    location <Period/2, 500, Period/2>
    look_at <Period/2, 0, Period/2>
    up 0.998*Period*y  // without the border of the height field
    right 0.998*Period*x
}

// A sun high in the south-west. Water has no shade of its own: what changes from wave to wave is how
// near its slope comes to the one that mirrors the sun, spread by the waves too short for the map.
light_source { <-0.45, 1, -0.30>*1e6 rgb <1.0, 0.96, 0.88> parallel point_at <0, 0, 0> }

#declare Whitecaps = pigment {
    image_map { exr "whitecap.exr" interpolate 2 }
    rotate 90*x
    scale <Period, 1, Period>
}

height_field {
    png "sea.png" smooth
    water_level 0
    scale <Period, Ocean_Scale, Period>
    translate Ocean_Base*y
    texture {
        pigment_pattern { Whitecaps }
        texture_map {
            [0 pigment { rgb <0.006, 0.045, 0.090> }
               finish { ambient 0 emission 1 diffuse 0 specular 0.035 roughness 0.04 }]
            [1 pigment { rgb <0.90, 0.95, 0.97> } finish { ambient 0 emission 1 diffuse 0 }]
        }
    }
}
