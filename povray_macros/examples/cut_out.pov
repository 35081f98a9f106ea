// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Cut_Out(Water, Hull): an open boat floats, and stays dry.
// ocean povray open.toml -o open && povray cut_out.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
#declare Eye = <10, 7, -2>;
camera { location Eye right x*image_width/image_height angle 50 look_at <20, 0.4, 9> }
Ocean_Eye_At(Eye, 50)
Ocean_Sun(38, 100)
Ocean_Sky(0.3)
// Its outside, 4.4 m long, waterline at y = 0; the boat is that less its room.
#declare Hull = intersection {
    sphere { 0, 1 scale <2.9, 1.6, 1.15> }
    box { <-2.2, -0.5, -2>, <2.9, 0.55, 2> }
}
#declare Boat = union {
    difference {
        object { Hull }
        intersection { sphere { 0, 1 scale <2.75, 1.5, 1.05> } box { <-2.1, -0.35, -2>, <2.9, 1, 2> } }
    }
    box { <-1.1, 0.15, -0.95>, <-0.8, 0.2, 0.95> }
    box { <0.5, 0.15, -0.9>, <0.8, 0.2, 0.9> }
    pigment { rgb <0.55, 0.30, 0.12> }
    finish { ambient 0 emission 0.15 diffuse 0.7 }
}
object { Ocean_Float(Boat, 20, 9, 150, 4.4, 2) }
object {
    Ocean_Cut_Out(object { Ocean_View(Eye, <20, 0.4, 9>, 50, 0.5) },
                  object { Ocean_Float(Hull, 20, 9, 150, 4.4, 2) })
    Ocean_Material("jerlov_ii")
    no_reflection
}
