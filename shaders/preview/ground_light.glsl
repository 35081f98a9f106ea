// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The colours of the ground, and its light under sun and sky.
#include "preview/ground_relief.glsl"
#include "preview/ground_state.glsl"
#include "preview/sand.glsl"
#include "preview/sky.glsl"
#include "wave/haze.glsl"
#include "wave/reflectance.glsl"

in vec2 label;
in vec3 position;

// Linear albedos, Rec. 709.
const vec3 snow_albedo = vec3(0.80, 0.83, 0.88);
const vec3 rock_albedo = vec3(0.165, 0.15, 0.135);
const vec3 dark_rock_albedo = vec3(0.09, 0.083, 0.078);
const vec3 scree_albedo = vec3(0.22, 0.195, 0.165);
const vec3 grass_albedo = vec3(0.082, 0.092, 0.036);
const vec3 dry_grass_albedo = vec3(0.19, 0.16, 0.075);
const vec3 forest_albedo = vec3(0.028, 0.042, 0.018);
const vec3 cliff_albedo = vec3(0.135, 0.12, 0.105);
const vec3 gravel_albedo = vec3(0.115, 0.108, 0.098);
const vec3 meadow_albedo = vec3(0.062, 0.098, 0.028);

// Returns how far the ground rises over its surroundings, about -1 (hollow) .. 1 (crest): between
// means over 4 and 16 cells of the terrain, relative to a cell.
float wear_at(vec2 place) {
    float cell = log2(range.z / tile.w);
    float fine = smooth_read(place, floor(cell + 1.5)).x;
    float coarse = smooth_read(place, floor(cell + 4.0)).x;
    return clamp((fine - coarse) / range.z, -1.0, 1.0);
}

float ramp(float from, float to, float x) {
    float t = clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// Returns how dark water has made sand, 0 .. 1: where waves have wetted it, or, in water that
// stands still, by its height. The first water darkens most [Lobell and Asner 2002].
float darkening_of(Ground ground, float noise) {
    float above = water_line.y > 0.0 ? ground.height - water_line.x : 1e3;
    float still = ground.still * (1.0 - ramp(0.2, 1.0, above + 0.2 * noise));
    float wetted = ground.wetted * max(1.0 + 0.4 * noise, 0.0);
    return 1.0 - exp(-5.0 * wetted) + still;
}

// Returns the ground as streams, gullies and the sea have made it.
Cover made_cover(Cover c, Ground ground, float noise, Grain grain) {
    float rough = 1.0 + 0.2 * noise;
    c.colour *= 1.0 - 0.25 * max(-ground.gully_wear, 0.0);
    float meadow = 0.7 * ground.deposit * ramp(0.6, 0.25, ground.steepness + 0.1 * noise);
    c = covered(c, meadow_albedo * rough, grass_relief, meadow, grain);
    float gravel = 0.8 * ramp(0.35, 0.8, ground.streambed + 0.15 * noise);
    c = covered(c, gravel_albedo * rough, scree_relief, gravel, grain);
    float cliff = ramp(0.15, 0.6, -ground.shore + 0.15 * noise);
    c = covered(c, cliff_albedo * rough, rock_relief, cliff, grain);
    vec3 sand = mix(sand_albedo, wet_sand_albedo, darkening_of(ground, noise));
    float beach = ramp(0.3, 0.7, ground.shore + 0.12 * noise);
    return covered(c, sand * (1.0 + 0.08 * noise), sand_relief, beach, grain);
}

// Returns the cover of land by height, slope and wear; noise about -1 .. 1.
Cover land_cover(Ground ground, float noise, float wear, Grain grain) {
    float relief = heights.y, tree_line = water_line.z;
    float z = ground.height + 0.3 * relief * noise;
    float steep = ground.steepness;
    Cover c = Cover(grass_albedo * (1.0 + 0.3 * noise), grass_relief);
    float straw = relief_straw * smoothstep(0.0, 0.8, grain.moves);
    c.colour = mix(c.colour, dry_grass_albedo, straw);
    float dry = 0.75 * ramp(tree_line - 0.25 * relief,
                            max(min(snow.x, heights.w), tree_line + relief),
                            z + 0.6 * relief * wear);
    c = covered(c, dry_grass_albedo, grass_relief, dry, grain);
    float woods = ramp(tree_line + 0.15 * relief, tree_line - 0.3 * relief,
                       z + 0.25 * relief * wear) *
                  ramp(0.95, 0.6, steep + 0.12 * noise) *
                  ramp(-0.55, 0.15, noise + 0.35 - 0.3 * wear);
    c = covered(c, forest_albedo * (1.0 + 0.25 * noise), forest_relief, woods, grain);
    float scree = 0.8 * ramp(0.50, 0.68, steep + 0.24 * noise - 0.08 * wear);
    c = covered(c, scree_albedo * (1.0 + 0.2 * noise), scree_relief, scree, grain);
    float rock = ramp(0.62, 0.92, steep + 0.20 * noise + 0.10 * wear);
    c = covered(c, rock_albedo * (1.0 + 0.25 * noise), rock_relief, rock, grain);
    c.colour = mix(c.colour, dark_rock_albedo, 0.55 * ramp(0.9, 1.5, steep + 0.2 * noise));
    c = made_cover(c, ground, noise, grain);
    vec2 level_sun = sun.xy / max(length(sun.xy), 1e-3);
    float facing = -dot(ground.slope, level_sun);
    float above = z - snow.x - snow.z * facing - snow.w * wear;
    float white = ramp(-snow.y, snow.y, above) * ramp(1.25, 0.75, steep + 0.15 * noise);
    return covered(c, snow_albedo * (0.94 + 0.06 * noise), snow_relief, white, grain);
}

// Returns the ramp of the teaching programs, c0 + c1 u in colours of a screen: c1 is an increment,
// and the highest ground is (255, 225, 156).
vec3 ramp_albedo(float height) {
    float u = (height - heights.z) / max(heights.w - heights.z, 1e-9);
    vec3 c = (vec3(66.0, 40.0, 18.0) + vec3(189.0, 185.0, 138.0) * clamp(u, 0.0, 1.0)) / 255.0;
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

// Returns the share that the ground leaves free of what shines along a line from a point, which
// rises by `rise` on a metre: the lowest clearance, at steps that grow with the distance up to
// `reach` [m], over a half shade of 1 in 50.
float free_way(vec2 at, float height, vec2 towards, float rise, float reach, float footprint) {
    if (shadow.x < 1.0) return 1.0;
    float distance = max(1.5 * tile.w, footprint);
    float ratio = pow(max(reach / distance, 1.0), 1.0 / shadow.x);
    float share = 1.0;
    for (int i = 0; i < int(shadow.x); ++i) {
        float ray = height + 0.05 * tile.w + distance * rise;
        if (ray > heights.w || share <= 0.0) break;
        float mip = log2(max(0.5 * distance * (ratio - 1.0) / tile.w, 1.0));
        float here = textureLod(ground_map, map_place(at + towards * distance), mip).x -
                     eye.w * earth_drop(distance);
        share = min(share, (ray - here) / (0.02 * distance));
        distance *= ratio;
    }
    return clamp(share, 0.0, 1.0);
}

// Returns the share of the sun's disc that is free.
float free_sun(vec2 at, float height, float footprint) {
    if (sun.z >= 0.999) return 1.0;
    float across = length(sun.xy);
    return free_way(at, height, sun.xy / across, sun.z / across, shadow.y, footprint);
}

// Returns the light of the ground in the colours that the block chooses.
vec3 shaded(Ground ground) {
    vec3 from_eye = position - vec3(0.0, 0.0, eye.z);
    float distance = length(from_eye);
    vec2 place = map_place(label);
    float wear = wear_at(place);
    vec3 albedo = ramp_albedo(ground.height);
    vec2 slope = ground.slope;
    if (colours.x == 0) {
        float noise = cover_noise(label, ground.footprint);
        Footprint footprint = footprint_of(label);
        float side = sqrt(footprint.width * length(footprint.longer));
        Grain grain = grain_at(label, side, noise);
        Cover cover = land_cover(ground, noise, wear, grain);
        albedo = cover.colour * relief_light(cover, grain);
        slope += relief_slope(cover, grain);
    }

    // On the round Earth the zenith leans away from the eye's.
    vec2 lean = eye.w * label / earth_radius();
    vec3 normal = normalize(vec3(-slope - lean, 1.0));
    float facing = max(dot(normal, sun.xyz), 0.0);
    float lit = facing > 0.0 && sun.w > 0.0
                    ? facing * free_sun(label, ground.height, ground.footprint)
                    : 0.0;
    float open = clamp(1.0 + 0.35 * wear, 0.5, 1.1) * (0.5 + 0.5 * normal.z);
    vec3 bounced = 0.15 * (0.5 - 0.5 * normal.z) * light_from_above();
    vec3 light = albedo * (sun.w * lit * sun_colour.rgb + open * sky_light.rgb + bounced);
#if COAST
    // A film of water on sand mirrors the sky.
    float film = ground.wetted * ramp(0.3, 0.7, ground.shore);
    float cosine = max(-dot(normal, from_eye / distance), 1e-3);
    vec3 mirrored = reflect(from_eye / distance, normal);
    mirrored.z = abs(mirrored.z);
    light = mix(light, sky(normalize(mirrored), 0.1),
                film * film * rough_water_reflectance(cosine, 0.1));
#endif

    float range_to = max(length(from_eye.xy), 1e-3);
    vec3 air = sky(normalize(vec3(from_eye.xy, 0.02 * range_to)), look.z);
    return mix(light, air, look.y > 0.0 ? haze(distance, look.y) : 0.0);
}
