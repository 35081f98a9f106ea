// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bay and its headlands from 820 m, and the swell that turns into it: scripts/pictures
// coast/headland.jpg. It was judged by this list, which is older than the picture:
//   crests      straight in deep water, turned to the beach in the bay, shorter where it is shallow
//   surf        white lines along the beach and at headlands that face the swell, none in their lees
//   colour      from deep blue to the sand that shines through, without a step
//   light       one sun on hills, sand and water
//   edges       water meets land in a closed line
#version 3.7;
#include "coast.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }

Ocean_Load(Ocean_Frame_Name(frame_number))
Terrain_Load("land")

#declare Eye = <1060, 820, 420>;
#declare Target = <1015, 0, 740>;
#declare View_Angle = 54;
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }

Ocean_Eye_At(Eye, View_Angle)
Ocean_Sun(42, 150)
Ocean_Sky(0.3)
#declare Ocean_Visibility = 40000;
Ocean_Coast(Eye, Target, View_Angle, 1, "jerlov_1c")
