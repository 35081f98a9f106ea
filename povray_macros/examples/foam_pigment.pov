// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Foam_Pigment(): the foam alone, over any pigment of yours.
// ocean povray open.toml -o open && povray foam_pigment.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <60, 120, -30> right x*image_width/image_height angle 55 look_at <60, 0, 55> }
Ocean_Sun(55, 200)
object { Ocean_Mesh() texture { pigment { rgb <0.01, 0.05, 0.12> } finish { ambient 0 emission 0.5 diffuse 0.5 } }
         texture { Ocean_Foam_Pigment() finish { ambient 0 emission 0.65 diffuse 0.05 } } }
plane { y, -6 pigment { rgb 0.6 } finish { diffuse 0.6 emission 0.15 ambient 0 } }
