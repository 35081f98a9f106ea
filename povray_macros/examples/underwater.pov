// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Underwater(Type, Light), with Ocean_God_Rays: a buoy and its chain from below; type III.
// ocean povray open.toml -o open && povray underwater.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }
Ocean_Load(Ocean_Frame_Name(frame_number))
#declare Eye = <30, -9, 30>;
camera { location Eye right x*image_width/image_height angle 80 look_at Eye + <10, 8.5, 5> }
Ocean_Eye_At(Eye, 80)
Ocean_Sun(48, 24)
Ocean_Sky(0.1)
#declare Ocean_God_Rays = 2;
object { Ocean_Volume(<30, 0, 30>, 150, 16, 0.5) Ocean_Underwater("jerlov_iii", 1) }
plane { y, -15.5 pigment { rgb <0.75, 0.66, 0.48> } finish { diffuse 0.9 ambient 0 } normal { wrinkles 0.6 scale 2 } }
#declare Painted = finish { diffuse 0.8 ambient 0 emission 0.12 }
#declare Buoy = union {
    sphere { 0, 1 scale <1.25, 0.7, 1.25> pigment { rgb <0.62, 0.05, 0.03> } }
    cone { 0.4*y, 0.5, 2.6*y, 0.2 pigment { rgb <0.62, 0.05, 0.03> } }
    #for (I, 0, 40)
        torus { 0.16, 0.05 scale <1, 1, 0.6> rotate <90, 90*I, 0> translate -(0.7 + 0.33*I)*y pigment { rgb 0.12 } }
    #end
    finish { Painted }
}
object { Ocean_Float(Buoy, 36, 36, 0, 2.5, 2.5) }
