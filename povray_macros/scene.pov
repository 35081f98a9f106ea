// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea of this folder to the horizon, under an afternoon sky. Change it as you like: an export
// never writes over it. All macros are explained in ocean.inc.
//   povray ocean.ini                      all frames
//   povray scene.pov +W1280 +H720 +A0.1 -J   the first one
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }

Ocean_Load(Ocean_Frame_Name(frame_number))

#declare Eye = <0, 5 + Ocean_Hs, 0>;
#declare Target = Eye + <cos(radians(Ocean_Direction)), -0.12, sin(radians(Ocean_Direction))>;
#declare View_Angle = 60;
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }

Ocean_Eye_At(Eye, View_Angle)
Ocean_Sun(24, Ocean_Direction + 14)
Ocean_Sky(0.4)

#if (strcmp(Ocean_Format, "df3") = 0 & Ocean_Maps > 1)
    object { Ocean_View(Eye, Target, View_Angle, 1) Ocean_Material("jerlov_ii") no_reflection }
#else
    #if (strcmp(Ocean_Format, "height_field") = 0)
        #declare Tile = Ocean_Height_Field()
    #else
        #declare Tile = Ocean_Mesh()
    #end
    object {
        Ocean_Tiles(Tile, 60, 60)
        translate -30*Ocean_Period*(x + z)
        Ocean_Material("jerlov_ii")
        no_reflection
    }
#end
