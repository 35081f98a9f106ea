// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
// Ocean_Point(X, Z), Ocean_Normal(X, Z), Ocean_Foam(X, Z): pins on the samples, red in foam.
// ocean povray open.toml -o open && povray point.pov +Lopen
#version 3.7;
#include "ocean.inc"
global_settings { assumed_gamma 1.0 }
Ocean_Load(Ocean_Frame_Name(frame_number))
camera { location <8, 9, -2> right x*image_width/image_height angle 50 look_at <22, 0, 17> }
Ocean_Sun(40, 120)
Ocean_Sky(0.2)
object { Ocean_Mesh() pigment { rgb <0.05, 0.20, 0.28> } finish { ambient 0 emission 0.3 diffuse 0.6 } }
#for (I, 0, 40)
    #for (K, 0, 40)
        #local At = Ocean_Point(1.5*I, 1.5*K);
        #local Foam = Ocean_Foam(1.5*I, 1.5*K);
        cylinder { At, At + 0.9*Ocean_Normal(1.5*I, 1.5*K), 0.06
                   pigment { rgb <0.9, 0.85 - 0.8*Foam, 0.7 - 0.65*Foam> } finish { ambient 0 emission 0.3 diffuse 0.6 } }
    #end
#end
