// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Volume(Centre, Radius, Depth, Detail): a solid disc of sea, seen from within.
// Folder: open
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 max_trace_level 8 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <30, -6, 30> right x*image_width/image_height angle 95 look_at <37, 1, 36> }
Ocean_Sun(48, 60)
Ocean_Sky(0.1)
object { Ocean_Volume(<30, 0, 30>, 120, 30, 0.5) Ocean_Underwater("jerlov_ia", 1) }
plane { y, -29 pigment { rgb <0.7, 0.62, 0.45> } finish { diffuse 0.8 ambient 0 } }
