// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Terrain_Height(X, Z), Terrain_Normal(X, Z), Terrain_Hazed(Texture): posts that stand on the ground,
// a disc at the foot of each that lies on it.
// ocean povray preset:tujunga -o land --resolution 512 && povray terrain_height.pov +Lland
#version 3.7;
#include "terrain.inc"
global_settings { assumed_gamma 1.0 }
Terrain_Load("land")
#declare Eye = <15040, Terrain_Height(15040, 14464) + 45, 14464>;
camera { location Eye right x*image_width/image_height angle 50
         look_at Eye + <-0.34, -0.2, -0.94> }
#declare Terrain_Visibility = 60000;
Terrain_Eye_At(Eye, 50)
Terrain_Sun(35, -20)
Terrain_Sky(0.2)
#declare Tile = Terrain_Height_Field()
object { Terrain_Around(Tile, Eye, 90000) Terrain_Material(9000) }
#declare White = texture { pigment { rgb 0.8 } finish { ambient rgb Terrain_Sky_Light diffuse 1 } }
#declare Red = texture { pigment { rgb <0.6, 0.03, 0.02> } finish { ambient rgb Terrain_Sky_Light diffuse 1 } }
#for (I, 0, 14)
    #local X = Eye.x - 60*(I + 2) - 40*mod(I, 2);
    #local Z = Eye.z - 150*(I + 2);
    #local Foot = <X, Terrain_Height(X, Z), Z>;
    #local Up = Terrain_Normal(X, Z);
    cylinder { Foot, Foot + 45*y, 4 Terrain_Hazed(White) }
    cylinder { Foot - 6*Up, Foot + 3*Up, 26 Terrain_Hazed(Red) }
#end
