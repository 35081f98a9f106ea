// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Underwater(Type, Light): the water itself glows; types IB.
// Folder: open
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 8 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <30, -7, 30> right x*image_width/image_height angle 70 look_at <50, -8.5, 45> }
Ocean_Sun(55, 60)
Ocean_Sky(0.1)
object { Ocean_Volume(<30, 0, 30>, 150, 16, 0.5) Ocean_Underwater("jerlov_ib", 1) }
plane { y, -15.5 pigment { rgb <0.75, 0.66, 0.48> } finish { diffuse 0.9 ambient 0 } normal { wrinkles 0.6 scale 2 } }
#for (I, 0, 7)
    sphere { 0, 1 scale <1.6, 1, 1.2> translate <42 + 6*I, -15.3, 36 + 5*I + 6*mod(I, 2)>
             pigment { rgb <0.35, 0.28, 0.22> } finish { diffuse 0.8 ambient 0 } }
#end
