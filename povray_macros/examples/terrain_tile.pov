// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Terrain_Mesh(), Terrain_Height_Field(): one tile.
// ocean povray preset:tujunga -o land --resolution 512 && povray terrain_tile.pov +Lland
#version 3.7;
#include "terrain.inc"
global_settings { assumed_gamma 1.0 }
Terrain_Load("land")
#declare Eye = <-0.55, 0.75, -0.75>*Terrain_Period;
camera { location Eye right x*image_width/image_height angle 40
         look_at <0.47, 0.04, 0.4>*Terrain_Period }
Terrain_Eye_At(Eye, 40)
Terrain_Sun(38, -20)
Terrain_Sky(0.1)
object { Terrain_Height_Field() Terrain_Material(9000) }
