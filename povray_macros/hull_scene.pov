// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The wakes of this folder from a mast's height, over the south-western quarter of their map to its
// middle. Put your hull into it, and change it as you like: an export never writes over it. All
// macros are explained in coast.inc.
//   povray ocean.ini                      all frames
//   povray scene.pov +W1280 +H720 +A0.1 -J   the first one
#version 3.7;
#include "coast.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }

Ocean_Load(Ocean_Frame_Name(frame_number))

#declare Middle = Ocean_Coast_Corner + Ocean_Coast_Extent/2;
#declare Eye = Ocean_Coast_Corner + Ocean_Coast_Extent/5 + (15 + 2*Ocean_Hs)*y;
#declare Target = Middle;
#declare View_Angle = 60;
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }

Ocean_Eye_At(Eye, View_Angle)
Ocean_Sun(24, degrees(atan2(Target.z - Eye.z, Target.x - Eye.x)) + 25)
Ocean_Sky(0.4)

#if (Ocean_Maps > 1)
    Ocean_Hulls(Eye, Target, View_Angle, 1, "jerlov_ii")
#else
    object { Ocean_Coast_Water(Eye, Target, View_Angle, 1) Ocean_Coast_Material("jerlov_ii") no_reflection }
#end
