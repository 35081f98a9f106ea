// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A valley in steep mountains at noon, from a ridge: preset:tujunga with waves down to 16 m, repeated
// to the horizon.
//   ocean povray preset:tujunga --set resolution=2048 -o build/terrain_noon
//   povray renders/povray/terrain_noon.pov +Lbuild/terrain_noon +W1280 +H720 +A0.08 +AM2 +R3
#version 3.7;
#include "terrain.inc"
global_settings { assumed_gamma 1.0 }

Terrain_Load("land")
#declare Eye = <10592, Terrain_Height(10592, 15552) + 30, 15552>;
#declare Target = Eye + <cos(radians(24)), -0.15, sin(radians(24))>;
#declare View_Angle = 56;
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }

#declare Distance = 130000;
#declare Terrain_Visibility = 90000;
#declare Terrain_Tree_Line = 1250;
Terrain_Eye_At(Eye, View_Angle)
Terrain_Sun(56, -80)
Terrain_Sky(0.42)

#declare Tile = Terrain_Height_Field()
object { Terrain_Around(Tile, Eye, Distance) Terrain_Material(Terrain_Highest + 1000) }
