// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A pool of 9 m by 9 m, 1.8 m deep, in the morning sun: the waves gather light on its floor.
//   ocean povray renders/povray/pool.toml -o build/pool --near-only
//   povray renders/povray/pool.pov +Lbuild/pool +W1280 +H720 +A0.2 +AM2 +R2
#version 3.7;
#include "ocean.inc"
global_settings {
    assumed_gamma 1.0
    max_trace_level 12
    photons { count 1500000 autostop 0 jitter 0.4 }
}
Ocean_Load("sea_0001")

#declare Low = 1.5;    // the basin in the period of 12 m
#declare High = 10.5;
#declare Depth = 1.8;
camera {
    location <0.6, 2.9, -0.9>
    right x*image_width/image_height
    angle 62
    look_at <5.9, -1.0, 5.6>
}
light_source {
    <-25, 60, 42> rgb <1.25, 1.2, 1.08>
    parallel point_at 0
    photons { refraction on reflection off }
}
sky_sphere {
    pigment {
        gradient y
        color_map { [0 rgb <0.62, 0.72, 0.80>] [0.3 rgb <0.36, 0.55, 0.78>] [1 rgb <0.14, 0.30, 0.60>] }
    }
}

intersection {
    object { Ocean_Block(4) }
    // The basin's walls lie within the water: a gap of air would be a mirror.
    box { <Low, -Depth, Low> - 0.01, <High, 1, High> + 0.01 }
    Ocean_Clear_Material("jerlov_ib")
    Ocean_Caustics()
}

// Tiles of 15 cm with joints.
#declare Tiled = texture {
    pigment {
        boxed
        color_map { [0.06 rgb 0.34] [0.09 rgb <0.60, 0.72, 0.74>] [1 rgb <0.66, 0.78, 0.80>] }
        scale 0.5
        translate 0.5
        warp { repeat x }
        warp { repeat y }
        warp { repeat z }
        scale 0.15
        translate 0.075  // the basin's faces cut tiles in their middle
    }
    finish { diffuse 0.8 ambient 0 emission 0.10 }
}
#declare Stone = texture {
    pigment { granite color_map { [0 rgb <0.62, 0.57, 0.50>] [1 rgb <0.74, 0.70, 0.64>] } scale 0.4 }
    finish { diffuse 0.75 ambient 0 emission 0.16 }
}
difference {
    box { <Low - 0.4, -Depth - 0.3, Low - 0.4>, <High + 0.4, 0.16, High + 0.4> }
    box { <Low, -Depth, Low>, <High, 1, High> }
    texture { Tiled }
}
difference {
    box { <-12, -0.3, -12>, <26, 0.165, 26> }
    box { <Low - 0.39, -1, Low - 0.39>, <High + 0.39, 1, High + 0.39> }
    texture { Stone }
}
difference {
    box { <Low - 0.5, 0.15, Low - 0.5>, <High + 0.5, 0.21, High + 0.5> }
    box { <Low, 0, Low>, <High, 1, High> }
    texture { pigment { rgb <0.80, 0.78, 0.73> } finish { diffuse 0.8 ambient 0 emission 0.16 } }
}

// A ball of 40 cm, a third of it under water.
#declare Ball = union {
    #for (Part, 0, 5)
        intersection {
            sphere { 0, 0.2 }
            plane { -z, 0 rotate -60*Part*y }
            plane { z, 0 rotate -60*(Part + 1)*y }
            pigment { rgb (mod(Part, 2) = 0 ? <0.85, 0.83, 0.78> : (mod(Part, 3) = 0 ? <0.05, 0.20, 0.60> : <0.75, 0.06, 0.04>)) }
        }
    #end
    finish { diffuse 0.8 ambient 0 emission 0.12 specular 0.5 roughness 0.01 }
    rotate <35, 20, 15>
    translate 0.07*y
}
object { Ocean_Float(Ball, 4.1, 3.7, 30, 0.4, 0.4) }
