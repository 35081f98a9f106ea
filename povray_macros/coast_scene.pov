// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The coast of this folder from some metres over a beach, along the shore and out to the sea. Change
// it as you like: an export never writes over it. All macros are explained in coast.inc.
//   povray ocean.ini                      all frames
//   povray scene.pov +W1280 +H720 +A0.1 -J   the first one
#version 3.7;
#include "coast.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }

Ocean_Load(Ocean_Frame_Name(frame_number))
Terrain_Load("land")

// A place to stand: of some places of the map a beach 1 to 4 m over the water, as much open water
// before it as there is.
#declare Place = Ocean_Coast_Corner + Ocean_Coast_Extent/2;
#declare Best = -1;
#for (J, 4, 60)
    #for (I, 4, 60)
        #declare Here = Ocean_Coast_Corner + Ocean_Coast_Extent*<I, 0, J>/64;
        #declare Ground = Terrain_Height(Here.x, Here.z);
        #if (Ground > 1 & Ground < 4)
            #declare Down = -vnormalize(<Terrain_Slope_X(Here.x, Here.z), 0, Terrain_Slope_Z(Here.x, Here.z)> + 1e-6*x);
            #declare Wet = Terrain_Beach(Here.x, Here.z);
            #for (K, 1, 12)
                #declare There = Here + 25*K*Down;
                #declare Wet = Wet + (Terrain_Height(There.x, There.z) < 0 ? 0.1 : -0.1);
            #end
            #if (Wet > Best)
                #declare Best = Wet;
                #declare Place = Here;
                #declare Seaward = Down;
            #end
        #end
    #end
#end
#if (Best < 0) #declare Seaward = vnormalize(-vrotate(x, -Ocean_Direction*y)); #end

// Half of the way between out to the sea and along the shore, to the side of the waves' left.
#declare Along = vcross(Seaward, y);
#declare Eye = <Place.x, max(Terrain_Height(Place.x, Place.z), Ocean_Hs) + 4, Place.z>;
#declare Target = Eye + Seaward + 0.7*Along - 0.13*y;
#declare View_Angle = 60;
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }

Ocean_Eye_At(Eye, View_Angle)
Ocean_Sun(38, degrees(atan2(Seaward.z, Seaward.x)) + 100)
Ocean_Sky(0.35)
#declare Ocean_Visibility = 40000;

#if (Ocean_Maps > 1)
    Ocean_Coast(Eye, Target, View_Angle, 1, "jerlov_3c")
#else
    Ocean_Coast_Land()
    object { Ocean_Coast_Water(Eye, Target, View_Angle, 1) Ocean_Coast_Material("jerlov_3c") no_reflection }
#end
