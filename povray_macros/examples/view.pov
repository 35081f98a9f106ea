// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_View(Eye, Look_At, Angle, Detail): all that a camera sees, to the horizon.
// ocean povray open.toml -o open && povray view.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
#declare Eye = <0, 4, 0>;
#declare Target = <20, 2.4, 12>;
camera { location Eye right x*image_width/image_height angle 60 look_at Target }
Ocean_Eye_At(Eye, 60)
Ocean_Sun(22, 44)
Ocean_Sky(0.4)
object { Ocean_View(Eye, Target, 60, 0.6) Ocean_Material("jerlov_ii") no_reflection }
