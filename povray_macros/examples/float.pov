// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Float(Object, X, Z, Heading, Length, Width): rafts lie as the waves do.
// ocean povray open.toml -o open && povray float.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
#declare Eye = <10, 7, -4>;
camera { location Eye right x*image_width/image_height angle 55 look_at <26, 0, 13> }
Ocean_Eye_At(Eye, 55)
Ocean_Sun(32, 90)
Ocean_Sky(0.3)
object { Ocean_View(Eye, <26, 0, 13>, 55, 0.5) Ocean_Material("jerlov_ii") no_reflection }
#declare Raft = union {
    #for (I, -3, 3) cylinder { <-2, 0.05, 0.4*I>, <2, 0.05, 0.4*I>, 0.2 } #end
    box { <-1.6, 0.2, -1.4>, <-1.3, 0.3, 1.4> }
    box { <1.3, 0.2, -1.4>, <1.6, 0.3, 1.4> }
    cylinder { 0.2*y, 2.6*y, 0.05 }
    pigment { rgb <0.45, 0.28, 0.13> }
    finish { ambient 0 emission 0.15 diffuse 0.7 }
}
#for (I, 0, 5)
    object { Ocean_Float(Raft, 19 + 7*mod(I, 3), 6 + 9*int(I/3), 40*I, 4, 2.8) }
#end
