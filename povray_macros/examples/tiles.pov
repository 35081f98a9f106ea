// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Tiles(Object, Columns, Rows): copies that share the memory of one.
// ocean povray open.toml -o open && povray tiles.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <240, 90, -150> right x*image_width/image_height angle 60 look_at <240, 0, 220> }
Ocean_Sun(30, 70)
Ocean_Sky(0.3)
#declare Tile = Ocean_Mesh()
object { Ocean_Tiles(Tile, 4, 4) Ocean_Material("jerlov_ii") no_reflection }
plane { y, -8 pigment { rgb <0.75, 0.72, 0.66> } finish { diffuse 0.7 emission 0.2 ambient 0 } }
