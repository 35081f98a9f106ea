// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// A region of an island, 2 m above a beach: masks of the land paint sand, rock and streambeds.
// ocean povray island.toml -o beach --region 800,5000,3400,6800 --cell 3 && povray terrain_beach.pov +Lbeach
#version 3.7;
#include "terrain.inc"
global_settings { assumed_gamma 1.0 }
Terrain_Load("land")
#declare Eye = <1714, Terrain_Height(1714, 5871) + 2, 5871>;
#declare Target = Eye + <-0.75, -0.05, -0.65>;
camera { location Eye right x*image_width/image_height angle 66 look_at Target }
#declare Terrain_Visibility = 40000;
Terrain_Eye_At(Eye, 66)
Terrain_Sun(40, -60)
Terrain_Sky(0.3)
object { Terrain_View(Eye, Target, 66, 2) Terrain_Material(9000) }
object { Terrain_Water(Terrain_Water_Level) Terrain_Water_Material() no_shadow }
