// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea of one frame under an afternoon sky. "sea_0001.inc" declares the surface and the camera
// that it was made for. Lengths are metres, x east, y up, z north.
//   scripts/pictures buoy_41010/buoy_41010.jpg
#version 3.7;
#include "sea_0001.inc"
global_settings { assumed_gamma 1.0 max_trace_level 6 }

// ---- Camera ----------------------------------------------------------------------------------
// Pitched down so that the horizon lies 3/10 below the top of a 16:9 picture.
camera {
    location Ocean_Eye
    right x*image_width/image_height
    angle Ocean_View_Angle
    look_at Ocean_Eye + Ocean_Forward - 0.13*y
}

// ---- Sun -------------------------------------------------------------------------------------
#declare Ocean_Right = vcross(y, Ocean_Forward);
#declare Sun_Altitude = 24;  // degrees
#declare Sun_Bearing = 14;   // degrees to the right of the view
#declare Sun = vnormalize((Ocean_Forward*cos(radians(Sun_Bearing))
                           + Ocean_Right*sin(radians(Sun_Bearing)))*cos(radians(Sun_Altitude))
                          + y*sin(radians(Sun_Altitude)));
light_source { Ocean_Eye + Sun*1e6 rgb <1.9, 1.7, 1.4> parallel point_at Ocean_Eye }

// ---- Sky -------------------------------------------------------------------------------------
// Three layers: clear air, thin cloud on a plane overhead, the sun's glow.
#declare Cloud_Pattern = function { pattern { wrinkles turbulence 0.5 octaves 7 omega 0.55 } }
#declare Cloud_Plane = function(X, Y, Z) { Cloud_Pattern(1.7*X/(max(Y, 0) + 0.10), 3.7,
                                                         1.7*Z/(max(Y, 0) + 0.10)) }
#declare Sun_X = Sun.x;  // functions know no vectors
#declare Sun_Y = Sun.y;
#declare Sun_Z = Sun.z;
#declare Toward_Sun = function(X, Y, Z) { max(0, X*Sun_X + Y*Sun_Y + Z*Sun_Z) }
sky_sphere {
    pigment {
        function { min(max(0.1 + 0.9*y, 0), 0.9999) }
        color_map {
            [0.09 rgb <0.10, 0.17, 0.21>]  // below the horizon: other waves
            [0.10 rgb <0.62, 0.70, 0.76>]
            [0.15 rgb <0.46, 0.60, 0.74>]
            [0.32 rgb <0.21, 0.38, 0.64>]
            [0.64 rgb <0.09, 0.21, 0.48>]
            [1.00 rgb <0.05, 0.13, 0.36>]
        }
    }
    pigment {
        function { Cloud_Plane(x, y, z) }
        color_map {
            [0.42 rgbt <0.80, 0.84, 0.88, 1.0>]
            [0.72 rgbt <0.86, 0.87, 0.88, 0.50>]
            [1.00 rgbt <0.95, 0.94, 0.92, 0.10>]
        }
    }
    pigment {
        function { 0.25*pow(Toward_Sun(x, y, z), 24) + 0.75*pow(Toward_Sun(x, y, z), 600) }
        color_map {
            [0.0 rgbt <1.0, 0.92, 0.78, 1.0>]
            [1.0 rgbt <2.6, 2.3, 1.8, 0.0>]
        }
    }
}

// ---- Water -----------------------------------------------------------------------------------
// What one sees of water is its Fresnel reflection of the sky and, where one looks steeply, the
// light that comes back out of the deep: blue-green and dark.
// Ripples of a hand's breadth are finer than the mesh. They matter near the eye only; farther off
// the mesh's normals already hold the mean of what they would show.
#declare Ripple_Range = 45;  // m
#declare Sea_Water = texture {
    pigment { rgb <0.010, 0.062, 0.075> }
    normal {
        spherical
        normal_map {
            [0.0 bumps 0]
            [0.7 bumps 0.22 scale 0.10/Ripple_Range]
            [1.0 bumps 0.22 scale 0.10/Ripple_Range]
        }
        scale Ripple_Range
        translate Ocean_Eye
    }
    finish {
        ambient 0
        emission 0.45
        diffuse 0.35
        specular 0.7
        roughness 0.002
        reflection { 0, 1 fresnel on }
        conserve_energy
    }
}
// Mirrors show the sky only: a reflected ray that leaves almost along the water would meet the flat
// triangles behind the smooth normals and speckle. Rays that go down see the sky's lower half.
object { Ocean_Surface texture { Sea_Water } interior { ior 1.333 } no_reflection }
