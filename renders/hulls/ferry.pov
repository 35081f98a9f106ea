// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// A ferry of 30 m in a turn on the sea of Beaufort 4, from 9 m over its port quarter or, with
// Declare=Above=1, from above.
// scripts/pictures hulls/ferry.jpg hulls/above_povray.jpg
#version 3.7;
#include "coast.inc"
global_settings { assumed_gamma 1.0 max_trace_level 8 }
Ocean_Load(Ocean_Frame_Name(frame_number))
#ifdef (Above)
    #declare Eye = <-60, 150, -110>;
    #declare Target = <50, 0, 25>;
    #declare View_Angle = 66;
#else
    #declare Eye = <74, 9, 66>;
    #declare Target = <126, 1.5, 6>;
    #declare View_Angle = 58;
#end
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }
Ocean_Eye_At(Eye, View_Angle)
Ocean_Sun(32, -15)
Ocean_Sky(0.45)
#declare Ocean_Visibility = 30000;
Ocean_Hulls(Eye, Target, View_Angle, 1.5, "jerlov_ib")

// The hull stands where the track has it at this frame; its plan is two parabolas, as the sea's is.
#declare Paint = texture { pigment { rgb <0.02, 0.05, 0.14> } finish { ambient 0 diffuse 0.8 specular 0.2 roughness 0.03 } }
#declare White = texture { pigment { rgb 0.82 } finish { ambient 0.03 diffuse 0.85 } }
#declare Deck = texture { pigment { rgb <0.35, 0.22, 0.12> } finish { ambient 0.03 diffuse 0.8 } }
#declare Glass = texture { pigment { rgb 0.02 } finish { diffuse 0.3 reflection 0.3 } }
#macro Plan(Bottom, Top, Wider)
    prism {
        linear_spline Bottom, Top, 81
        #for (I, -20, 19) <0.75*I, Wider + 3*(1 - pow(I/20, 2))>, #end
        #for (I, -20, 19) <-0.75*I, -Wider - 3*(1 - pow(I/20, 2))>, #end
        <-15, Wider>
    }
#end
#macro House(West, East, Half, Bottom, Top)
    union {
        box { <West, Bottom, -Half>, <East, Top, Half> texture { White } }
        box { <West - 0.03, Top - 1.5, -Half - 0.03>, <East + 0.03, Top - 0.7, Half + 0.03> texture { Glass } }
    }
#end
union {
    object { Plan(-1.8, 1.7, 0.05) texture { Paint } }
    object { Plan(1.7, 2.0, 0.12) texture { White } }
    object { Plan(2.0, 2.02, 0.0) texture { Deck } }
    House(-10, 6, 2.2, 2, 4.6)
    House(-7, 4.5, 1.8, 4.6, 6.8)
    House(-0.5, 4, 1.5, 6.8, 8.8)
    cylinder { <-4, 6.8, 0>, <-4.4, 9.6, 0>, 0.75 texture { pigment { rgb <0.55, 0.06, 0.03> } finish { ambient 0.03 diffuse 0.8 } } }
    cylinder { <1.5, 8.8, 0>, <1.5, 13, 0>, 0.07 texture { White } }
    rotate 43.8*y  // heading -43.8 degrees
    translate <129.6, 0, 5.8>
}
