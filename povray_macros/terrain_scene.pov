// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The terrain of this folder from its highest place to the horizon, at noon. Change it as you like:
// an export never writes over it. All macros are explained in terrain.inc.
//   povray terrain.ini
//   povray scene.pov +W1280 +H720 +A0.1
#version 3.7;
#include "terrain.inc"
global_settings { assumed_gamma 1.0 }

Terrain_Load("land")
#declare Relief = Terrain_Highest - Terrain_Lowest;

// The highest of some places of the tile, and the camera above it.
#declare Eye = <0, -1e9, 0>;
#for (J, 0, 127)
    #for (I, 0, 127)
        #declare Place = Terrain_Period/128*<I, 0, J>;
        #declare Ground = Terrain_Height(Place.x, Place.z);
        #if (Ground > Eye.y) #declare Eye = Place + Ground*y; #end
    #end
#end
#declare Eye = Eye + 0.06*Relief*y;
#declare View_Angle = 60;
#declare Target = Eye + <1, -0.14, 0.3>;
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }

// The haze hides the end of the land.
#declare Distance = 10*Terrain_Period;
#declare Terrain_Visibility = Distance;
Terrain_Eye_At(Eye, View_Angle)
Terrain_Sun(48, -60)  // high in the south
Terrain_Sky(0.35)

#if (strcmp(Terrain_Format, "mesh2") = 0)
    #declare Tile = Terrain_Mesh()
#else
    #declare Tile = Terrain_Height_Field()
#end
object { Terrain_Around(Tile, Eye, Distance) Terrain_Material(Terrain_Highest + Relief) }
