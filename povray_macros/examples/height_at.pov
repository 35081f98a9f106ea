// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Height_At(X, Z), Ocean_Normal_At, Ocean_Foam_At: a line of floats at given places.
// ocean povray open.toml -o open && povray height_at.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
#declare Eye = <10, 6, -6>;
camera { location Eye right x*image_width/image_height angle 55 look_at <26, 0, 14> }
Ocean_Eye_At(Eye, 55)
Ocean_Sun(30, 170)
Ocean_Sky(0.3)
object { Ocean_View(Eye, <26, 0, 14>, 55, 0.5) Ocean_Material("jerlov_ii") no_reflection }
#for (I, 0, 60)
    #local X = 14 + 0.5*I;
    #local Z = 4 + 6*sin(0.12*I);
    sphere { <X, Ocean_Height_At(X, Z), Z>, 0.22 pigment { rgb <0.9, 0.35, 0.02> } finish { ambient 0 emission 0.2 diffuse 0.7 } }
#end
