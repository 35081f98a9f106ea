// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The ridge of beside.jpg in POV-Ray: preset:tujunga, one tile repeated, with the eye and the sun
// that the preview and Blender have in the other columns.
//   ocean povray preset:tujunga -o build/beside 
//   povray renders/terrain/beside.pov +Lbuild/beside +W640 +H360 +A0.1 +AM2 Declare=Altitude=58 Declare=Bearing=75
#version 3.7;
#include "terrain.inc"
global_settings { assumed_gamma 1.0 }
#ifndef (Altitude) #declare Altitude = 58; #end
#ifndef (Bearing) #declare Bearing = 75; #end

Terrain_Load("land")
#declare Eye = <16352, Terrain_Height(16352, 15040) + 1.7, 15040>;
#declare Target = Eye + <cos(radians(352)), -tan(radians(5)), sin(radians(352))>;
#declare View_Angle = 50;
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }

#declare Terrain_Visibility = 90000;
Terrain_Eye_At(Eye, View_Angle)
Terrain_Sun(Altitude, Bearing)
Terrain_Sky(0)

#declare Tile = Terrain_Mesh()
object { Terrain_Around(Tile, Eye, 100000) Terrain_Material(1640) }
