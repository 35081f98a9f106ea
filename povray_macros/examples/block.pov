// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Block(Depth): the same as a solid. Its walls move with the waves; a box cuts straight ones.
// ocean povray open.toml -o open && povray block.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 8 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <16, 17, 8> right x*image_width/image_height angle 50 look_at <57, -3.5, 54> }
Ocean_Sun(40, 120)
Ocean_Sky(0.2)
intersection {
    object { Ocean_Block(14) }
    box { <40, -6, 40>, <76, 10, 76> }
    Ocean_Clear_Material("jerlov_ia")
}
box { <38, -8, 38>, <78, -6.01, 78> pigment { rgb <0.76, 0.66, 0.48> } finish { diffuse 0.8 emission 0.1 ambient 0 } }
plane { y, -8.01 pigment { rgb 0.65 } finish { diffuse 0.7 emission 0.15 ambient 0 } }
