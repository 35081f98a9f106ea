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

// A low sun behind the crests' lee side, and the sky's light from everywhere.
light_source { <-3, 1.6, -2>*1e6 rgb <1.75, 1.55, 1.25> parallel point_at <0, 0, 0> }

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
        pigment {
            pigment_pattern { Whitecaps }
            color_map {
                [0.00 rgb <0.010, 0.050, 0.075>]
                [1.00 rgb <0.85, 0.89, 0.90>]
            }
        }
        finish { ambient rgb <0.7, 0.9, 1.1> diffuse 0.8 specular 0.7 roughness 0.04 }
    }
}
