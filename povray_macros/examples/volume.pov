// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Volume(Centre, Radius, Depth, Detail): a solid disc of sea, seen from within.
// ocean povray open.toml -o open && povray volume.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 8 }
Ocean_Load(Ocean_Frame_Name(frame_number))
#declare Eye = <30, -6, 30>;
camera { location Eye right x*image_width/image_height angle 95 look_at <37, 0.5, 36> }
Ocean_Eye_At(Eye, 95)
Ocean_Sun(48, 60)
Ocean_Sky(0.1)
object { Ocean_Volume(<30, 0, 30>, 120, 12, 1) Ocean_Underwater("jerlov_ia", 1) }
plane { y, -11 pigment { rgb <0.7, 0.62, 0.45> } finish { diffuse 0.8 ambient 0 } }
