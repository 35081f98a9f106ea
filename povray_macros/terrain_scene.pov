// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The terrain of this folder at noon, to the horizon: a tile from its highest place, land that exists
// once from above its south-west corner. Change it as you like: an export never writes over it. All
// macros are explained in terrain.inc.
//   povray terrain.ini
//   povray scene.pov +W1280 +H720 +A0.1 -J
#version 3.7;
#include "terrain.inc"
global_settings { assumed_gamma 1.0 }

Terrain_Load("land")
#declare Relief = Terrain_Highest - Terrain_Lowest;
#declare Longer_Side = max(Terrain_Extent.x, Terrain_Extent.z);

// The highest of some places of the map.
#declare Summit = <0, -1e9, 0>;
#for (J, 0, 127)
    #for (I, 0, 127)
        #declare Place = Terrain_Corner + Terrain_Extent/128*<I, 0, J>;
        #declare Ground = Terrain_Height(Place.x, Place.z);
        #if (Ground > Summit.y) #declare Summit = Place + Ground*y; #end
    #end
#end

#declare View_Angle = 60;
#if (Terrain_Repeats)
    #declare Eye = Summit + 0.06*Relief*y;
    #declare Target = Eye + <1, -0.14, 0.3>;
    #declare Terrain_Visibility = 10*Terrain_Period;
    #declare Has_Water = false;
#else
    #declare Middle = Terrain_Corner + Terrain_Extent/2;
    #declare Eye = Middle - 0.6*Terrain_Extent;
    #declare Eye = Eye + (Terrain_Highest + 0.24*Longer_Side)*y;
    #declare Target = Middle + (0.6*Terrain_Water_Level + 0.4*Summit.y)*y;
    #declare Terrain_Visibility = max(40000, 15*Longer_Side);
    #declare Has_Water = (Terrain_Lowest < Terrain_Water_Level);
#end
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }

Terrain_Eye_At(Eye, View_Angle)
Terrain_Sun(48, -60)  // high in the south
Terrain_Sky(0.35)

object { Terrain_View(Eye, Target, View_Angle, 2) Terrain_Material(Terrain_Highest + Relief) }
#if (Has_Water)
    object { Terrain_Water(Terrain_Water_Level) Terrain_Water_Material() no_shadow }
#end
