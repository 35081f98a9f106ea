// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Terrain_Around(Object, Centre, Distance): copies of one tile to the horizon, in haze.
// ocean povray preset:tujunga -o land --resolution 512 && povray terrain_around.pov +Lland
#version 3.7;
#include "terrain.inc"
global_settings { assumed_gamma 1.0 }
Terrain_Load("land")
#declare Eye = <5984, Terrain_Height(5984, 9024) + 40, 9024>;
camera { location Eye right x*image_width/image_height angle 60
         look_at Eye + <-0.17, -0.13, -0.98> }
#declare Terrain_Visibility = 60000;
Terrain_Eye_At(Eye, 60)
Terrain_Sun(14, 190)
Terrain_Sky(0.4)
#declare Tile = Terrain_Height_Field()
object { Terrain_Around(Tile, Eye, 90000) Terrain_Material(9000) }
