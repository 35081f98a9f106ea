// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Isosurface(Lowest, Highest): smooth however near the camera comes.
// ocean povray open.toml -o open && povray isosurface.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <1, 2.8, 1> right x*image_width/image_height angle 60 look_at <6, 1.5, 5> }
Ocean_Sun(30, 60)
Ocean_Sky(0.3)
object { Ocean_Isosurface(<-20, -4, -20>, <80, 4, 80>) pigment { rgb <0.01, 0.06, 0.08> }
         finish { ambient 0 emission 0.35 diffuse 0.5 specular 0.5 roughness 0.003 reflection { 0, 1 fresnel } conserve_energy }
         interior { ior 1.333 } no_reflection }
