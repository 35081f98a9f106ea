// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A storm with the crest of 7.2 m that its file asks for, before a buoy of 4 m.
//   ocean povray renders/crests/hero.toml --set start=20 -o build/hero
//   povray renders/crests/hero.pov +Lbuild/hero +W720 +H300 +A0.1 +AM2 +R2
// scripts/pictures crests/hero_povray.jpg
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }
Ocean_Load("sea_0001")

#declare Eye = <338, 3.2, 258>;
#declare Target = <400, 4.4, 300>;
camera { location Eye right x*image_width/image_height angle 50 look_at Target }
Ocean_Eye_At(Eye, 50)
Ocean_Sun(22, 75)
Ocean_Sky(0.5)
#declare Ocean_Visibility = 20000;
object { Ocean_View(Eye, Target, 50, 1.5) Ocean_Material("jerlov_ii") no_reflection }

#declare Buoy = union {
    sphere { 0, 1 scale <1.25, 0.55, 1.25> translate -0.05*y }
    cylinder { 0.30*y, 0.55*y, 0.95 }
    #for (Turn, 0, 3)
        cylinder { <0.85, 0.5, 0>, <0.25, 3.0, 0>, 0.045 rotate 90*Turn*y }
    #end
    torus { 0.56, 0.035 translate 1.7*y }
    torus { 0.36, 0.035 translate 2.6*y }
    cone { 3.1*y, 0.45, 3.9*y, 0 }
    sphere { 4.0*y, 0.09 pigment { rgb <0.9, 0.7, 0.3> } }
    pigment { rgb <0.62, 0.30, 0.02> }
    finish { diffuse 0.75 ambient 0 emission 0.15 specular 0.25 roughness 0.02 }
}
object { Ocean_Float(Buoy, 396, 304, 30, 2.5, 2.5) }
