// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Eye_At(Location, Angle), Ocean_Sun(Altitude, Bearing): twilight, the sun a degree below.
// ocean povray open.toml -o open && povray twilight.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
#declare Eye = <0, 5, 0>;
camera { location Eye right x*image_width/image_height angle 60 look_at <20, 6.4, 12> }
Ocean_Eye_At(Eye, 60)
Ocean_Sun(-1, 38)
Ocean_Sky(0.3)
object { Ocean_View(Eye, <20, 6.4, 12>, 60, 0.5) Ocean_Material("jerlov_ii") no_reflection }
