// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Block(Depth): the same as a solid, here of clear water over sand.
// Folder: open
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 8 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <-62, 45, -75> right x*image_width/image_height angle 50 look_at <60, -10, 52> }
Ocean_Sun(40, 120)
Ocean_Sky(0.2)
object { Ocean_Block(14) Ocean_Clear_Material("jerlov_ia") }
box { <-3, -17, -3>, <123, -14.01, 123> pigment { rgb <0.76, 0.66, 0.48> } finish { diffuse 0.8 emission 0.1 ambient 0 } }
plane { y, -18 pigment { rgb 0.65 } finish { diffuse 0.7 emission 0.15 ambient 0 } }
