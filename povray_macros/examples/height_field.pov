// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Height_Field(): one period from a 16-bit picture.
// ocean povray open.toml -o field --format height_field && povray height_field.pov +Lfield
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <-60, 62, -80> right x*image_width/image_height angle 50 look_at <62, -4, 50> }
Ocean_Sun(35, 120)
Ocean_Sky(0.2)
object { Ocean_Height_Field() pigment { rgb <0.02, 0.10, 0.14> }
         finish { ambient 0 emission 0.3 diffuse 0.6 specular 0.6 roughness 0.01 reflection { 0, 1 fresnel } conserve_energy }
         interior { ior 1.333 } }
plane { y, -8 pigment { rgb <0.75, 0.72, 0.66> } finish { diffuse 0.7 emission 0.2 ambient 0 } }
