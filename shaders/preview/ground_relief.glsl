// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The relief of the covers of land: stones, tufts, tree crowns and drifts that no map has.
//
//     grain of five wavelengths L, each left out where a pixel holds it -> edges of covers
//     grain, steepness of the cover -> slope = sum of steepness L grad grain, light of the hollows
//
// blender_addon/libocean_addon/terrain/ground_relief.py and Terrain_Material of
// povray_macros/terrain.inc.in follow the same rule with the same numbers.
#include "preview/cover_noise.glsl"

const int relief_waves = 5;
const int first_relief = 4;  // of the sizes of the cover noise, whose cells are wavelengths

// Steepness of each cover: of the two longest waves, of that of 1 m, and of the two shortest; and
// the share of its waves that are stones, round above clefts.
const vec4 grass_relief = vec4(0.08, 0.22, 0.40, 0.0);
const vec4 forest_relief = vec4(0.30, 0.30, 0.20, 0.0);
const vec4 scree_relief = vec4(0.20, 0.30, 0.36, 1.0);
const vec4 rock_relief = vec4(0.25, 0.40, 0.40, 0.0);
const vec4 snow_relief = vec4(0.08, 0.05, 0.04, 0.0);
const vec4 sand_relief = vec4(0.02, 0.02, 0.04, 0.0);

// How much each wavelength moves the edges of covers, in shares of a cover.
const float relief_breaks[5] = float[5](0.30, 0.30, 0.25, 0.15, 0.10);
const float relief_dark = 0.7;    // the light that hollows lack, in slopes of the relief
const float relief_straw = 0.45;  // the share of dry grass in the driest grass
// How much the noise of the covers makes relief stronger: of equal strength it would look woven.
const float relief_uneven = 0.8;
// How much the next longer wave moves the clefts between stones, which would lie in rows else.
const float relief_cleft = 0.6;
const float relief_round = 1.6;  // the slope of stones, in slopes of the grain
// The grain has a deviation of 0.6, and its gradient times the wavelength one of 1.7 along an axis.
const float relief_contrast = 3.3;

struct Grain {
    float value[relief_waves];  // about -1 .. 1
    vec2 slope[relief_waves];   // gradient times the wavelength
    float facing[relief_waves];  // slope of stones, in slopes of the grain
    float moves;                // of the edges of covers, in shares
    float seen;                 // 1 near the eye, 0 where pixels hold waves of 4 m
    float amount;
};

// Returns the share of a wavelength [m] that pixels with this footprint [m] show.
float relief_shown(float wavelength, float footprint) {
    return 1.0 - smoothstep(0.3, 0.9, footprint / wavelength);
}

// Returns gradient noise of one size of cells at a place relative to the eye, and its changes
// along x and y, in cells [Perlin 2002].
vec3 relief_wave(int size, vec2 at) {
    vec2 place = cover[size].xy + at * cover[size].z;
    vec2 cell = floor(place);
    vec2 u = place - cell;
    vec2 t = u * u * u * (u * (6.0 * u - 15.0) + 10.0);
    vec2 change = 30.0 * u * u * (1.0 - u) * (1.0 - u);
    ivec2 corner = cover_cell[size].xy + ivec2(cell);
    vec2 g[4];
    float rise[4];
    for (int i = 0; i < 4; ++i) {
        ivec2 beside = ivec2(i & 1, i >> 1);
        GridPoint hashed = copy_offset(corner.x + beside.x, corner.y + beside.y + 7919 * size);
        g[i] = 2.0 * vec2(hashed.x, hashed.y) - 1.0;
        rise[i] = dot(g[i], u - vec2(beside));
    }
    float south = mix(rise[0], rise[1], t.x), north = mix(rise[2], rise[3], t.x);
    float east = mix(rise[1] - rise[0], rise[3] - rise[2], t.y);
    vec2 inner = mix(mix(g[0], g[1], t.x), mix(g[2], g[3], t.x), t.y);
    return vec3(mix(south, north, t.y), inner + change * vec2(east, north - south));
}

// Returns the grain at a place relative to the eye. noise: of the covers.
Grain grain_at(vec2 at, float footprint, float noise) {
    Grain grain;
    grain.amount = clamp(0.9 + relief_uneven * noise, 0.25, 1.6);
    grain.moves = 0.0;
    mat2 turn = mat2(0.8, -0.6, 0.6, 0.8);  // off the lattices of map and mesh
    for (int i = 0; i < relief_waves; ++i) {
        int size = first_relief + i;
        float shown = relief_contrast * relief_shown(cover[size].w, footprint);
        vec3 wave = shown > 0.0 ? shown * relief_wave(size, turn * at) : vec3(0.0);
        grain.value[i] = wave.x;
        grain.slope[i] = wave.yz * turn;
        float cleft = wave.x + relief_cleft * (i > 0 ? grain.value[i - 1] : 0.0);
        grain.facing[i] = cleft < 0.0 ? -relief_round : relief_round;
        grain.moves += grain.amount * relief_breaks[i] * wave.x;
    }
    grain.seen = clamp(grain.amount * relief_shown(4.0, footprint), 0.0, 1.0);
    return grain;
}

// The colour of the ground and the steepness of its relief.
struct Cover {
    vec3 colour;
    vec4 relief;
};

// Returns the share of a cover whose edge follows the grain: where there is none of it, or nothing
// else, it stays so.
float broken_share(float share, Grain grain) {
    float moved = share + 4.0 * share * (1.0 - share) * grain.moves;
    return mix(share, smoothstep(0.25, 0.75, moved), grain.seen);
}

// Returns the ground with a share of another cover over it.
Cover covered(Cover below, vec3 colour, vec4 relief, float share, Grain grain) {
    float broken = broken_share(share, grain);
    return Cover(mix(below.colour, colour, broken), mix(below.relief, relief, broken));
}

// Returns the share of the light that the hollows of the relief leave.
float relief_light(Cover cover, Grain grain) {
    vec3 r = grain.amount * cover.relief.xyz;
    float steepness[5] = float[5](r.x, r.x, r.y, r.z, r.z);
    float sum = 0.0;
    for (int i = 0; i < relief_waves; ++i) sum += steepness[i] * grain.value[i];
    return clamp(1.0 + relief_dark * sum, 0.25, 1.75);
}

// Returns the slope of the relief.
vec2 relief_slope(Cover cover, Grain grain) {
    vec3 r = grain.amount * cover.relief.xyz;
    float steepness[5] = float[5](r.x, r.x, r.y, r.z, r.z);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < relief_waves; ++i) {
        sum += steepness[i] * mix(1.0, grain.facing[i], cover.relief.w) * grain.slope[i];
    }
    return sum;
}
