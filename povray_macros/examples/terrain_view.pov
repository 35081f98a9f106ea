// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Terrain_View(Location, Look_At, Angle, Pixel), Terrain_Water(Level): land and sea to the horizon.
// ocean povray island.toml -o island && povray terrain_view.pov +Lisland
#version 3.7;
#include "terrain.inc"
global_settings { assumed_gamma 1.0 }
Terrain_Load("land")
#declare Eye = <1500, 1500, 300>;
#declare Target = <5200, 0, 6000>;
camera { location Eye right x*image_width/image_height angle 62 look_at Target }
#declare Terrain_Visibility = 120000;
Terrain_Eye_At(Eye, 62)
Terrain_Sun(38, -75)
Terrain_Sky(0.3)
object { Terrain_View(Eye, Target, 62, 2) Terrain_Material(9000) }
object { Terrain_Water(Terrain_Water_Level) Terrain_Water_Material() no_shadow }
