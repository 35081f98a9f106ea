// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Surf from 2.5 m over the beach of a bay, towards its headland: scripts/pictures coast/beach.jpg.
// It was judged by this list, which is older than the picture:
//   horizon     a line at the height of the eye; no step where the map of the coast ends
//   scale       breakers of a man's height at 40 m, foam in cells below a metre, ripples near the eye
//   light       one sun and one sky on sand, hill, water and foam; no black spots in ripples
//   repetition  none in crests, foam or sand
//   edges       water meets sand in a closed line; wet sand above it; surf at the foot of the headland
#version 3.7;
#include "coast.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }

Ocean_Load(Ocean_Frame_Name(frame_number))
Terrain_Load("land")

#declare Eye = <905, Terrain_Height(905, 640) + 2.5, 640>;
#declare Target = Eye + <0.6, -0.09, 0.8>;
#declare View_Angle = 60;
camera { location Eye right x*image_width/image_height angle View_Angle look_at Target }

Ocean_Eye_At(Eye, View_Angle)
Ocean_Sun(42, 175)
Ocean_Sky(0.35)
#declare Ocean_Visibility = 40000;
Ocean_Coast(Eye, Target, View_Angle, 1, "jerlov_1c")
