// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Mesh(): one period of the sea, as a mesh with normals and foam.
// ocean povray open.toml -o open && povray mesh.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <-60, 62, -80> right x*image_width/image_height angle 50 look_at <62, -4, 50> }
Ocean_Sun(35, 120)
Ocean_Sky(0.2)
object { Ocean_Mesh() Ocean_Material("jerlov_ii") }
plane { y, -8 pigment { rgb <0.75, 0.72, 0.66> } finish { diffuse 0.7 emission 0.2 ambient 0 } }
