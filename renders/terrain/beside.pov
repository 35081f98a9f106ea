// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A view of renders/terrain/views.toml, as ocean-preview shows it: the same land, sky, sun and camera.
//   ocean povray LAND -o PARTS && renders/terrain/lands.py povray VIEW > PARTS/view.inc
//   povray renders/terrain/beside.pov +LPARTS +FE +W640 +H360 +A0.1
// With Declare=Only_Sky=1 it is the sky alone, all around: what Blender's world shows.
#version 3.7;
#include "terrain.inc"
#include "view.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }

#ifdef(Only_Sky)
    camera { spherical angle 360 180 location View_Eye look_at View_Eye + x }
    Terrain_Eye_At(View_Eye, View_Angle)
    Terrain_Sun(View_Sun_Altitude, View_Sun_Bearing)
    Terrain_Sky(0)
#else
    Terrain_Load("land")
    camera {
        location View_Eye
        right x*image_width/image_height
        angle View_Angle
        look_at View_Target
    }
    Terrain_Eye_At(View_Eye, View_Angle)
    Terrain_Sun(View_Sun_Altitude, View_Sun_Bearing)
    Terrain_Sky(0)
    object { Terrain_View(View_Eye, View_Target, View_Angle, 1) Terrain_Material(View_Snow_Line) }
    #if (Terrain_Lowest < Terrain_Water_Level)
        object { Terrain_Water(Terrain_Water_Level) Terrain_Water_Material() no_shadow }
    #end
#end
