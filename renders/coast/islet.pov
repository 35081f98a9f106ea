// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A swell that meets an islet, and the lee behind it, from 420 m: scripts/pictures coast/islet.jpg.
// It was judged by this list, which is older than the picture:
//   crests      bend around the islet from both sides and cross behind it
//   lee         calmer behind the islet, with no hard edge to it
//   surf        on the side of the swell and on both flanks, little behind
//   colour      a belt of shoals that has no edge of its own
//   edges       water meets land in a closed line
#version 3.7;
#include "coast.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }

Ocean_Load(Ocean_Frame_Name(frame_number))
Terrain_Load("land")

#declare Eye = <640, 420, -60>;
#declare Target = <690, 0, 700>;
#declare View_Angle = 42;
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }

Ocean_Eye_At(Eye, View_Angle)
Ocean_Sun(30, 118)
Ocean_Sky(0.3)
#declare Ocean_Visibility = 40000;
Ocean_Coast(Eye, Target, View_Angle, 1, "jerlov_ii")
