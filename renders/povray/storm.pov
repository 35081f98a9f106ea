// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A strong gale in the evening: waves of 7 m run towards us, the sun lights foam and buoy from the
// side; the buoy is 4 m high.
//   ocean povray renders/povray/storm.toml -o build/storm
//   povray renders/povray/storm.pov +Lbuild/storm +W960 +H540 +A0.1 +AM2 +R2
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }
Ocean_Load("sea_0001")

// In a trough, 70 m before the highest crest of the period.
#declare Eye = <782, 2.6, 214>;
#declare Target = Eye + <1, 0.045, 0.10>;
camera { location Eye right x*image_width/image_height angle 44 look_at Target }
Ocean_Sun(12, 80)

// A lid of cloud that ends before the horizon.
#declare Lid = function { pattern { wrinkles turbulence 0.65 octaves 7 omega 0.58 lambda 2.1 } }
#declare Overhead = function(x, y, z) { Lid(0.9*x/(max(y, 0) + 0.06), 1.3, 1.5*z/(max(y, 0) + 0.06)) }
#declare Sun_X = Ocean_Sun_Direction.x;
#declare Sun_Y = Ocean_Sun_Direction.y;
#declare Sun_Z = Ocean_Sun_Direction.z;
#declare Toward = function(x, y, z) { max(0, x*Sun_X + y*Sun_Y + z*Sun_Z) }
sky_sphere {
    pigment {
        function { min(max(0.1 + 0.9*y, 0), 0.9999) }
        color_map {
            [0.09 rgb <0.10, 0.09, 0.09>]
            [0.10 rgb <0.95, 0.50, 0.22>]
            [0.15 rgb <0.75, 0.45, 0.30>]
            [0.24 rgb <0.33, 0.30, 0.34>]
            [0.50 rgb <0.16, 0.18, 0.24>]
            [1.00 rgb <0.10, 0.12, 0.17>]
        }
    }
    pigment {  // the glow is the sun's, not the whole horizon's
        function { pow(Toward(x, y, z), 3) }
        color_map { [0 rgbt <0.20, 0.21, 0.26, 0.15>] [1 rgbt <0.20, 0.21, 0.26, 1>] }
    }
    pigment {
        function { Overhead(x, y, z)*min(1, max(0, 9*(y - 0.035))) }
        color_map {
            [0.15 rgbt <0.30, 0.24, 0.23, 1>]
            [0.45 rgbt <0.15, 0.14, 0.17, 0.35>]
            [0.80 rgbt <0.07, 0.075, 0.095, 0.05>]
        }
    }
    pigment {
        function { 0.15*pow(Toward(x, y, z), 40) + 0.15*pow(Toward(x, y, z), 1500)
                   + 0.7*pow(Toward(x, y, z), 40000) }
        color_map { [0 rgbt <1.5, 0.8, 0.35, 1>] [1 rgbt <2.4, 1.5, 0.7, 0>] }
    }
}
#declare Ocean_Sky_Light = <0.20, 0.19, 0.20>;
object { Ocean_View(Eye, Target, 44, 1.6) Ocean_Material("jerlov_iii") no_reflection }

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
    pigment { rgb <0.55, 0.30, 0.02> }
    finish { diffuse 0.7 ambient 0 emission 0.7*Ocean_Sky_Light specular 0.3 roughness 0.03 }
}
object { Ocean_Float(Buoy, 824, 226, 30, 2.5, 2.5) }
