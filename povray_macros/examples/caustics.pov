// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Caustics(): photons through the waves of a pool.
// ocean povray pool.toml -o pool --near-only && povray caustics.pov +Lpool
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 10 photons { count 250000 autostop 0 jitter 0.4 } }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <2.2, 3.4, 0.5> right x*image_width/image_height angle 60 look_at <6, -1.4, 6> }
light_source { <-25, 60, 42> rgb 1.1 parallel point_at 0 photons { refraction on reflection off } }
intersection {
    object { Ocean_Block(3) }
    box { <1, -1.6, 1>, <11, 1, 11> }
    Ocean_Clear_Material("jerlov_i")
    Ocean_Caustics()
}
box { <-20, -2, -20>, <40, -1.59, 40> pigment { checker rgb <0.6, 0.68, 0.70> rgb <0.5, 0.6, 0.64> scale 0.4 } finish { ambient 0 emission 0.06 diffuse 0.85 } }
