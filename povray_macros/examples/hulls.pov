// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// A ferry of 30 m at 8 m/s, from 14 m over its quarter. Its water line is that of the sea file.
// ocean povray ferry.toml -o ferry --region -160,-60,70,110 --cell 0.5 && povray hulls.pov +Lferry
#version 3.7;
#include "coast.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }
Ocean_Load(Ocean_Frame_Name(frame_number))
#declare Eye = <-75, 14, -22>;
#declare Target = <8, 0, 24>;
camera { location Eye right x*image_width/image_height angle 50 look_at Target }
Ocean_Eye_At(Eye, 50)
Ocean_Sun(24, 65)
Ocean_Sky(0.4)
Ocean_Hulls(Eye, Target, 50, 0.7, "jerlov_ii")

// The hull is where the track has it at this frame; its plan is two parabolas, as the sea's is.
#macro Side(X) 3*(1 - pow(X/15, 2)) #end
#macro Plan(Bottom, Top, Out)
    prism {
        linear_spline Bottom, Top, 81
        #for (I, -20, 19) <0.75*I, Out + Side(0.75*I)>, #end
        #for (I, -20, 19) <-0.75*I, -Out - Side(0.75*I)>, #end
        <-15, Out>
    }
#end
union {
    object { Plan(-1.8, 1.9, 0.05) pigment { rgb <0.02, 0.05, 0.12> } }
    object { Plan(1.9, 2.1, 0.15) pigment { rgb <0.6, 0.58, 0.52> } }
    box { <-9, 2, -2.1>, <5, 4.6, 2.1> pigment { rgb 0.75 } }
    box { <-5, 4.6, -1.6>, <3.5, 6.6, 1.6> pigment { rgb 0.75 } }
    box { <3.4, 5.2, -1.5>, <3.6, 6.2, 1.5> pigment { rgb 0.05 } }
    cylinder { <-3, 6.6, 0>, <-3.4, 8.6, 0>, 0.8 pigment { rgb <0.5, 0.05, 0.03> } }
    finish { ambient 0.12 diffuse 0.8 }
    translate <8*Ocean_Time, 0, 20>
}
