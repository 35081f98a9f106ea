// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Terrain_Material(Snow_Line): grass, forest, scree, rock and snow by height and slope.
// ocean povray preset:tujunga -o land --resolution 512 && povray terrain_material.pov +Lland
#version 3.7;
#include "terrain.inc"
global_settings { assumed_gamma 1.0 }
Terrain_Load("land")
#declare Eye = <11104, Terrain_Height(11104, 4832) + 60, 4832>;
camera { location Eye right x*image_width/image_height angle 50
         look_at Eye + <-0.98, -0.14, -0.17> }
#declare Terrain_Visibility = 90000;
Terrain_Eye_At(Eye, 50)
Terrain_Sun(40, -110)
Terrain_Sky(0.2)
#declare Tile = Terrain_Height_Field()
object { Terrain_Around(Tile, Eye, 130000) Terrain_Material(1300) }
