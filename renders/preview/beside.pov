// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A view of views.toml, as ocean-preview shows it: the same sea, sky, sun, water and camera.
//   ocean povray SEA -o PARTS && renders/preview/hosts.py povray VIEW > PARTS/view.inc
//   povray renders/preview/beside.pov +LPARTS +FE +W960 +H540 -A
// With Declare=Only_Sky=1 it is the sky alone, all around: what Blender's world shows.
#version 3.7;
#include "ocean.inc"
#include "view.inc"
#ifdef(View_Coast) #include "coast.inc" #end
global_settings { assumed_gamma 1.0 max_trace_level 6 }

#ifdef(Only_Sky)
    camera { spherical angle 360 180 location View_Eye look_at View_Eye + x }
    Ocean_Eye_At(View_Eye, View_Angle)
    Ocean_Sun(View_Sun_Altitude, View_Sun_Bearing)
    Ocean_Sky(0)
#else
    Ocean_Load(Ocean_Frame_Name(0))
    #declare Ocean_Glint_Limit = 0;  // the other two have none
    camera {
        location View_Eye
        right x*image_width/image_height
        angle View_Angle
        look_at View_Target
    }
    Ocean_Eye_At(View_Eye, View_Angle)
    Ocean_Sun(View_Sun_Altitude, View_Sun_Bearing)
    Ocean_Sky(0)
    #declare Painted = finish { diffuse 1 ambient 0 emission Ocean_Sky_Light }
    #ifdef(View_Coast)
        Terrain_Load("land")
        Ocean_Coast(View_Eye, View_Target, View_Angle, 1, View_Water)
    #else
        View_Floats()
        object {
            Ocean_View(View_Eye, View_Target, View_Angle, 2)
            Ocean_Material(View_Water)
            no_reflection
        }
    #end
#end
