// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A fractal bed whose highest parts are islands, from 480 m: scripts/pictures coast/fractal.jpg. It
// was judged by this list, which is older than the picture:
//   crests      another way behind each island; no kinks in straight lines across the sea
//   surf        along shores that the swell reaches and over shoals, none in lees
//   colour      shoals seen through the water; deep water between islands
//   repetition  none
//   edges       water meets land in closed lines
#version 3.7;
#include "coast.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }

Ocean_Load(Ocean_Frame_Name(frame_number))
Terrain_Load("land")

#declare Eye = <860, 480, -250>;
#declare Target = <810, 0, 560>;
#declare View_Angle = 44;
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }

Ocean_Eye_At(Eye, View_Angle)
Ocean_Sun(32, 120)
Ocean_Sky(0.3)
#declare Ocean_Visibility = 40000;
Ocean_Coast(Eye, Target, View_Angle, 1, "jerlov_ii")
