// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Material(Type): deep water of Jerlov's types I, 1C and 9C.
// ocean povray open.toml -o open && povray material.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <190, 190, -110> right x*image_width/image_height angle 66 look_at <190, 0, 62> }
Ocean_Sun(40, 200)
Ocean_Sky(0.2)
#declare Tile = Ocean_Mesh()
#declare Types = array[3] { "jerlov_i", "jerlov_1c", "jerlov_9c" }
#for (I, 0, 2)
    object { Tile Ocean_Material(Types[I]) translate 130*I*x }
#end
plane { y, -6 pigment { rgb 0.6 } finish { diffuse 0.6 emission 0.15 ambient 0 } }
