// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Clear_Material(Type): posts of 1 m bands, seen through a pool of type 1C.
// ocean povray pool.toml -o pool --near-only && povray clear_material.pov +Lpool
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 8 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <6, 5, -4> right x*image_width/image_height angle 55 look_at <6, -1.5, 6> }
Ocean_Sun(50, 130)
Ocean_Sky(0.1)
object { Ocean_Block(5) Ocean_Clear_Material("jerlov_1c") }
#for (I, 0, 4)
    cylinder { <2 + 2*I, -5, 5 + mod(I, 2)>, <2 + 2*I, 1, 5 + mod(I, 2)>, 0.18
               pigment { gradient y color_map { [0.5 rgb <0.8, 0.05, 0.03>] [0.5 rgb 0.9] } scale 2 }
               finish { ambient 0 emission 0.25 diffuse 0.7 } }
#end
box { <-20, -5.2, -20>, <40, -5.01, 40> pigment { rgb <0.8, 0.75, 0.6> } finish { ambient 0 emission 0.25 diffuse 0.7 } }
