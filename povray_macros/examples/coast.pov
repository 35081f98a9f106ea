// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// A bay with surf, its land and the open sea beside it, from 6 m over the beach.
// ocean povray beach.toml -o coast --region 850,560,1250,960 --cell 2 && povray coast.pov +Lcoast
// (beach.toml and its bed, bay.toml, lie beside this scene, or in renders/coast of the sources)
#version 3.7;
#include "coast.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }
Ocean_Load(Ocean_Frame_Name(frame_number))
Terrain_Load("land")
#declare Eye = <900, Terrain_Height(900, 620) + 6, 620>;
#declare Target = Eye + <0.7, -0.16, 0.7>;
camera { location Eye right x*image_width/image_height angle 62 look_at Target }
Ocean_Eye_At(Eye, 62)
Ocean_Sun(42, 175)
Ocean_Sky(0.35)
#declare Ocean_Visibility = 40000;
Ocean_Coast(Eye, Target, 62, 0.5, "jerlov_1c")
