// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A fairway to the horizon: buoys 4 m high, every 90 m, red to the left and green to the right.
//   ocean povray renders/povray/open_sea.toml -o build/open_sea
//   povray renders/povray/open_sea.pov +Lbuild/open_sea +W1280 +H720 +A0.08 +AM2 +R3
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }
Ocean_Load("sea_0001")

#declare Eye = <0, 6.2, 0>;
#declare Target = Eye + <1, -0.085, 0.03>;
camera { location Eye right x*image_width/image_height angle 52 look_at Target }
Ocean_Eye_At(Eye, 52)
Ocean_Sun(21, 38)
Ocean_Sky(0.45)
object { Ocean_View(Eye, Target, 52, 1.6) Ocean_Material("jerlov_ii") no_reflection }

#declare Painted = finish { diffuse 0.75 ambient 0 emission 0.18 specular 0.25 roughness 0.02 }
#macro Buoy(Colour, Top)
    union {
        sphere { 0, 1 scale <1.25, 0.55, 1.25> translate -0.05*y }
        cylinder { 0.30*y, 0.55*y, 0.95 }
        cone { 0.5*y, 0.55, 3.2*y, 0.2 }
        #for (Turn, 0, 3)
            cylinder { <0.85, 0.5, 0>, <0.2, 2.9, 0>, 0.035 rotate 90*Turn*y }
        #end
        torus { 0.34, 0.05 translate 2.3*y }
        object { Top translate 3.0*y }
        sphere { 4.15*y, 0.11 pigment { rgb <1, 0.95, 0.8> } finish { emission 1 } }
        pigment { rgb Colour }
        finish { Painted }
    }
#end
#declare Red = Buoy(<0.62, 0.03, 0.02>, cylinder { 0.15*y, 0.95*y, 0.36 })
#declare Green = Buoy(<0.02, 0.26, 0.10>, cone { 0.1*y, 0.46, 1.05*y, 0 })

#for (Pair, 0, 7)
    #local X = 34 + 90*Pair;
    object { Ocean_Float(Red, X, 9 + 2*Pair, 20, 2.5, 2.5) }
    object { Ocean_Float(Green, X + 14, -13 + 2*Pair, 20, 2.5, 2.5) }
#end
