// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The light of the water, or a field of it.
#include "preview/foam_look.glsl"
#include "preview/sea.glsl"
#include "preview/sky.glsl"
#include "preview/below.glsl"
#include "preview/tone.glsl"
#include "wave/crest_light.glsl"
#include "wave/erfc.glsl"
#include "wave/foam_lace.glsl"
#include "wave/haze.glsl"
#include "wave/reflectance.glsl"
#include "wave/slope_tiles.glsl"
#include "wave/surface.glsl"
#include "wave/visible_slope.glsl"

in vec2 label;
in vec3 position;
layout(location = 0) out vec4 colour;

// The sea at a fragment: means over its footprint, and what varies inside.
struct Water {
    vec4 displacement;  // as displacement_map
    vec4 gradients;     // as gradient_map
    vec2 detail;        // slopes of waves that no map has
    vec3 variance;      // of the slopes that are in neither: xx, yy, xy
    float squeezing;    // variance of dDx/dx + dDy/dy that is not in the mean
    vec3 foam[COVERS];  // as cover_map
    float footprint;    // side of what a pixel sees of it, m
};

vec3 from_eye_here() { return position - vec3(0.0, 0.0, eye.z); }

// What a pixel covers of the water: an ellipse of labels, long and narrow almost everywhere.
struct Footprint {
    vec2 dx;      // steps of the label from pixel to pixel
    vec2 dy;
    vec2 longer;  // the longer one
    float width;  // m: the length of the other one
};

Footprint footprint_of(vec2 at) {
    vec2 dx = dFdx(at);
    vec2 dy = dFdy(at);
    float x = length(dx);
    float y = length(dy);
    return x > y ? Footprint(dx, dy, dx, y) : Footprint(dx, dy, dy, x);
}

// A map's mean over the footprint. Where the driver's filter is round, TAPS of its circles stand
// side by side along the longer axis.
vec4 filtered(sampler2D map, vec2 place, Footprint footprint, float scale, float texels) {
#if TAPS > 0
    float longer = length(footprint.longer);
    float circle = max(footprint.width, longer / float(TAPS));
    float mip = log2(max(circle * texels, 1.0));
    vec4 sum = vec4(0.0);
    for (int i = 0; i < TAPS; ++i) {
        float along = (float(i) + 0.5) / float(TAPS) - 0.5;
        sum += textureLod(map, place + along * scale * footprint.longer, mip);
    }
    return sum / float(TAPS);
#else
    return textureGrad(map, place, footprint.dx * scale, footprint.dy * scale);
#endif
}

float jacobian_of(Water water) {
    return surface_jacobian(waves.x, water.gradients.z, water.gradients.w, water.displacement.w);
}

vec3 normal_of(Water water) {
    SurfaceNormal normal = surface_normal(waves.x, water.gradients.z, water.gradients.w,
                                          water.displacement.w, water.gradients.x, water.gradients.y);
    return vec3(normal.x, normal.y, normal.z);
}

vec2 slope_of(Water water) { return water.gradients.xy + water.detail; }

// The normal with the slopes of the near detail, which lie on a surface that is not folded.
vec3 detailed_normal_of(Water water) {
    vec3 normal = normal_of(water);
    normal.xy -= max(normal.z, 0.0) * water.detail;
    return normalize(normal);
}

// Behind a ridge water is seen at a grazing angle however near it is.
float seen_footprint(Water water) {
    vec3 from_eye = from_eye_here();
    float distance = max(length(from_eye), 1e-3);
    return slope_footprint(distance, look.z, max(-dot(normal_of(water), from_eye) / distance, 0.0));
}

#if DETAIL > 0
uniform sampler2D tile_map[DETAIL];

// As slope_tile_read, of labels relative to the eye.
vec2 tile_slope(int d, vec2 at, int level) {
    vec2 place = at * tile[d].z;
    float scale = slope_tile_triangles / copy_triangles;
    GridPoint skewed = copy_grid(scale * place.x, scale * place.y);
    vec2 grid = tile_grid[d].xy + vec2(skewed.x, skewed.y);
    vec2 cell = floor(grid);
    vec2 inside = grid - cell;
    vec2 sum = vec2(0.0);
    float squares = 0.0;
    for (int i = 0; i < 3; ++i) {
        CopyCorner corner = copy_corner(inside.x, inside.y, i);
        GridPoint moved = copy_offset(tile_cell[d].x + int(cell.x) + corner.x,
                                      tile_cell[d].y + int(cell.y) + corner.y);
        vec2 from = tile[d].xy + place + vec2(moved.x, moved.y);
        sum += corner.weight * textureLod(tile_map[d], from, float(level)).xy;
        squares += corner.weight * corner.weight;
    }
    return sum * inversesqrt(squares);
}

// Slopes of the tiles, and to the variance what of them a pixel cannot show. Returns their mean
// square: at most what the maps lack, whose own varies with time.
float add_detail(inout Water water, vec2 at, float lacking) {
    float whole = 0.0;
    for (int d = 0; d < DETAIL; ++d) {
        whole += tile[d].w * tile[d].w * (tile_variance[d].x + tile_variance[d].y);
    }
    float scale = min(1.0, sqrt(lacking / max(whole, 1e-12)));
    for (int d = 0; d < DETAIL; ++d) {
        float weight = scale * tile[d].w;
        float fade = slope_tile_fade(water.footprint, tile_grid[d].z, tile_grid[d].w);
        // Texels of two thirds of a pixel: waves that are shorter would be a grain.
        float texels = water.footprint * tile[d].z * float(textureSize(tile_map[d], 0).x);
        int level = clamp(int(floor(log2(max(texels, 1.0)))), 0, 7);
        float left = 1.0 - fade * fade * tile_read[2 * d + level / 4][level % 4];
        if (fade > 0.0) water.detail += fade * weight * tile_slope(d, at, level);
        water.variance += weight * weight * left * tile_variance[d].xyz;
    }
    return scale * scale * whole;
}
#endif

Water water_at(vec2 at) {
    Footprint footprint = footprint_of(at);
    Water water;
    water.displacement = water.gradients = vec4(0.0);
    water.detail = vec2(0.0);
    water.variance = vec3(0.0);
    water.squeezing = 0.0;
    Copies copies = copies_at(at);
    float resolved = 0.0;  // mean square slope of the maps
    for (int c = 0; c < CASCADES; ++c) {
        float scale = cascade[c].z;
        vec4 all = part[c].x * part[c].x * textureLod(moment_map[c], vec2(0.5), 99.0);
        resolved += all.x + all.y;
        if (length(footprint.longer) * scale >= 1.0) {  // the footprint is larger than the period
            water.variance += all.xyz;
            water.squeezing += all.w;
            continue;
        }
        for (int i = 0; i < copies.count; ++i) {
            float weight = part[c].x * copies.weight[i];
            vec2 place = map_place(c, at, copies.offset[i]);
            float texels = 1.0 / cascade[c].w;
            vec4 gradients = filtered(gradient_map[c], place, footprint, scale, texels);
            vec4 moments = filtered(moment_map[c], place, footprint, scale, texels);
            water.displacement +=
                weight * filtered(displacement_map[c], place, footprint, scale, texels);
            water.gradients += weight * gradients;
            vec3 squares = vec3(gradients.x * gradients.x, gradients.y * gradients.y,
                                gradients.x * gradients.y);
            float squeezed = gradients.z + gradients.w;
            // Copies are independent: variances add by the squares of their weights.
            water.variance += weight * weight * (moments.xyz - squares);
            water.squeezing += weight * weight * (moments.w - squeezed * squeezed);
        }
    }
    water.variance = max(water.variance, vec3(0.0, 0.0, water.variance.z));
    water.footprint = seen_footprint(water);
    float lacking = max(0.0, waves.z - resolved);  // of waves that no map has
#if DETAIL > 0
    lacking -= add_detail(water, at, lacking);
#endif
    water.variance.xy += 0.5 * lacking;
    for (int v = 0; v < COVERS; ++v) {
        float squares = 0.0;
        vec3 sum = vec3(0.0);
        for (int i = 0; i < copies.count; ++i) {
            vec2 place = cover[v].xy + at * cover[v].z + copies.offset[i] + 0.5 * cover[v].w;
            float share = copies.weight[i] * copies.weight[i];
            float texels = cover[v].z / cover[v].w;  // a metre
            sum += share * filtered(cover_map[v], place, footprint, cover[v].z, texels).rgb;
            squares += share;
        }
        water.foam[v] = sum / squares;
    }
    return water;
}

// Share of the water that foam hides.
float cover_of(Water water) {
    float sum = 0.0;
    for (int v = 0; v < COVERS; ++v) sum += cover_share[v] * water.foam[v].r;
    return clamp(sum, 0.0, 1.0);
}

#if LACE
uniform sampler2D lace_map;
uniform sampler2D bubble_map;
uniform sampler2D streak_map;
uniform int lace_ready;  // 0: these textures are still being made
uniform sampler2D lace_shares;  // eight rows for each of them: what share of a level's reads is lower

// A texture that is so many metres wide. A level's means are not uniform in [0, 1]; the share of
// them that is lower is.
float uniform_read(sampler2D map, int rows, vec2 place, float footprint, float tile) {
    float texels = footprint / tile * float(textureSize(map, 0).x);
    float level = min(floor(log2(max(texels, 1.0)) + 0.5), log2(float(textureSize(map, 0).x)) - 5.0);
    vec2 size = vec2(textureSize(lace_shares, 0));
    float read = textureLod(map, place, level).r;
    vec2 row = vec2(read * (size.x - 1.0) + 0.5, float(rows) + level + 0.5);
    return textureLod(lace_shares, row / size, 0.0).r;
}

// What draws the foam of a cover at a label, uniform in [0, 1]: as POV-Ray's Ocean_Lace_; and what
// the net alone has of it.
float lace_at(int v, vec2 at, float footprint, out float net_alone) {
    vec2 tiles = vec2(dot(at, lace[v].xy), at.y * lace[v].x - at.x * lace[v].y);
    vec2 net = vec2(tiles.x * lace[v].z, tiles.y);
    vec2 turned = vec2(3.0 * net.x + net.y, 3.0 * net.y - net.x) / 11.0;
    net_alone = unite_uniform(
        uniform_read(lace_map, 0, lace_net[v].xy + turned, footprint, lace_tile * 11.0 / sqrt(10.0)),
        uniform_read(lace_map, 0, lace_net[v].zw + net, footprint, lace_tile), 0.08);
    float bubbled = max(0.3 - foam_faded(0.0, 0.3, footprint, bubble_cell), 1e-3);
    float bubbles = uniform_read(bubble_map, 8, lace_more[v].xy + tiles * (lace_tile / bubble_tile),
                                 footprint, bubble_tile);
    float value = add_uniform(net_alone, bubbles, bubbled);
    if (lace[v].w <= 0.0) return value;
    float streaks = uniform_read(streak_map, 16, lace_more[v].zw + tiles * (lace_tile / streak_tile),
                                 footprint, streak_tile);
    return add_uniform(value, streaks, lace[v].w);
}
#endif

// What is seen of foam in a pixel.
struct Foam {
    float white;      // share that it hides
    float thickness;  // of that
    float height;     // m, over the water
    float value;      // of what draws it, 0 .. 1; of the last cover
    float plume;      // of bubbles below
};

Foam foam_at(Water water, vec2 at) {
    float footprint = water.footprint;
    Foam seen = Foam(0.0, 0.0, 0.0, 1.0, 0.0);
    float thick = 0.0;
    for (int v = 0; v < COVERS; ++v) {
        vec3 mean = water.foam[v];
        float c = clamp(foam.w * mean.r, 0.0, 1.0);
        float white = c;
        float thickness = mean.g / max(mean.r, 1e-6);
        float height = 0.0;
#if LACE
        float far = lace_ready > 0 ? foam_faded(0.0, 1.0, footprint, lace_cell) : 1.0;
        if (c > 0.0 && far < 1.0) {
            float net;
            seen.value = lace_at(v, at, footprint, net);
            // A pixel blurs what it sees; any edge has the same mean.
            float edge = min(foam_edge + footprint / lace_cell, 1.0);
            white = foam_faded(foam_mask(c, seen.value, edge), c, footprint, lace_cell);
            float here = foam_thickness(c, seen.value, foam_span);
            // Bubbles are smaller than two pixels, by whose difference the slope is known.
            height = foam_height * foam_thickness(c, net, 1.0) * (1.0 - far);
            thickness = mix(here, thickness, min(2.5 * footprint / lace_cell, 1.0));
        }
#endif
        seen.white += cover_share[v] * white;
        thick += cover_share[v] * white * thickness;
        seen.height += cover_share[v] * height;
        seen.plume += cover_share[v] * clamp(foam.w, 0.0, 1.0) * mean.b;
    }
    seen.thickness = thick / max(seen.white, 1e-6);
    return seen;
}

// The slope of a height, from its differences between pixels.
vec2 slope_of_height(float height, vec2 at) {
    vec2 rise = vec2(dFdx(height), dFdy(height));
    vec2 x = dFdx(at), y = dFdy(at);
    float area = x.x * y.y - x.y * y.x;
    if (abs(area) < 1e-12) return vec2(0.0);
    return vec2(rise.x * y.y - rise.y * x.y, rise.y * x.x - rise.x * y.x) / area;
}

// Light of the sun mirrored by facets: the density of their slopes at the one that mirrors it into
// the eye, over the area of water that is seen [Cox and Munk 1954], [Ross 2005].
vec3 glitter(vec3 to_eye, vec2 lean, mat2 covariance, float area, float elevation_cosine) {
    vec3 half_way = normalize(to_eye + sun.xyz);
    if (half_way.z <= 0.05) return vec3(0.0);
    float spread = 0.00465 * 0.5;  // the sun's radius, as a slope
    mat2 v = covariance + mat2(spread * spread + look.z * look.z * 0.25);
    float determinant_v = max(determinant(v), 1e-14);
    vec2 miss = half_way.xy / half_way.z - lean;
    vec2 solved = vec2(v[1][1] * miss.x - v[0][1] * miss.y, v[0][0] * miss.y - v[0][1] * miss.x);
    float density = exp(-0.5 * dot(miss, solved) / determinant_v) /
                    (6.2831853 * sqrt(determinant_v));
    float reflected = water_reflectance(max(dot(to_eye, half_way), 0.0), water.w);
    float squared = half_way.z * half_way.z;
    float seen = max(area * elevation_cosine, 1e-3);
    return 3.14159265 * sun.w * sun_colour.rgb * reflected * density / (4.0 * seen * squared * squared);
}

// The mean of the sky over the facets that mirror it: three points along the line of sight, which
// is the way that the mirrored sky varies most. across: radians that they spread it the other way.
vec3 mirrored_sky(vec3 to_eye, vec2 lean, vec2 deviation, float across) {
    vec3 sum = vec3(0.0);
    for (int i = -1; i <= 1; ++i) {
        vec3 facet = normalize(vec3(lean + float(i) * 1.7320508 * deviation, 1.0));
        vec3 mirrored = reflect(-to_eye, facet);
        mirrored.z = abs(mirrored.z);  // a second reflection
        sum += (i == 0 ? 2.0 / 3.0 : 1.0 / 6.0) * sky(normalize(mirrored), across);
    }
    return sum;
}

vec3 shaded(Water state, Foam froth, vec2 froth_slope) {
    vec3 from_eye = from_eye_here();
    float distance = max(length(from_eye), 1e-3);
    vec3 to_eye = -from_eye / distance;
    float range = max(length(from_eye.xy), 1e-3);
    vec2 e = -from_eye.xy / range;

    // A folded crest has no slope; the shallowest kept is 84 degrees.
    vec3 normal = normal_of(state);
    vec2 lean = normal.xy / max(normal.z, 0.1) - state.detail - e * (eye.w * range / earth_radius());
    mat2 covariance = mat2(state.variance.x, state.variance.z, state.variance.z, state.variance.y);
    vec2 along = covariance * e;
    float variance = max(dot(along, e), 1e-12);
    float deviation = sqrt(variance);
    float elevation = -from_eye.z / range + dot(lean, e);
    float area = visible_area(deviation, elevation);
    vec2 seen = lean + along * (visible_lean(deviation, elevation) / variance);
    float mean_cosine = max(dot(to_eye, normalize(vec3(lean, 1.0))), 0.0);
    float reflected = clamp(rough_water_reflectance(mean_cosine, deviation), 0.0, 1.0);
    vec2 spread = along / variance * sqrt(visible_lean_variance(deviation, elevation));
    // A facet that leans aside turns what it mirrors by twice as much, times the cosine; as wide as
    // that deviation is a mean over sqrt(12) of it.
    vec2 aside = vec2(-e.y, e.x);
    float across = 6.9 * mean_cosine * sqrt(max(dot(covariance * aside, aside), 0.0));
    vec3 mirrored = mirrored_sky(to_eye, seen, spread, max(across, look.z));

    vec3 body = (water.rgb + foam_plume * froth.plume) * light_from_above();
    float through = crest_light(state.displacement.z / max(waves.y, 1e-3), jacobian_of(state),
                                dot(-to_eye.xy, sun.xy), dot(normal.xy, sun.xy));
    body += crest.w * through * sun.w * sun_colour.rgb * crest.rgb;

    vec3 radiance = reflected * mirrored + (1.0 - reflected) * body +
                    glitter(to_eye, lean, covariance, area, range / distance);
    vec3 facing = normalize(vec3(lean - froth_slope, 1.0));
    vec3 foam_light = sky_light.rgb + sun.w * sun_colour.rgb * max(dot(facing, sun.xyz), 0.0);
    radiance = mix(radiance, mix(thin_foam, thick_foam, froth.thickness) * foam_light, froth.white);
    // The light of the air is that of the sky over the horizon.
    vec3 air = sky(normalize(vec3(from_eye.xy, 0.02 * range)), look.z);
    return mix(radiance, air, look.y > 0.0 ? haze(distance, look.y) : 0.0);
}

#if BELOW
// Snell's window: the whole sky in a cone of 48.6 degrees, broken by the waves; around it the deep.
vec3 shaded_from_below(Water state, Foam froth) {
    vec3 from_eye = from_eye_here();
    float distance = max(length(from_eye), 1e-3);
    from_eye /= distance;
    vec3 normal = normal_of(state);
    vec2 lean = normal.xy / max(normal.z, 0.1) - state.detail;
    // Of facets that are not seen by themselves those are windows which are met within the critical
    // angle: a share, and a mean lean, of a Gaussian's below a limit.
    vec2 e = from_eye.xy / max(length(from_eye.xy), 1e-3);
    mat2 covariance = mat2(state.variance.x, state.variance.z, state.variance.z, state.variance.y);
    vec2 along = covariance * e;
    float deviation = sqrt(max(dot(along, e), 1e-6));
    float met = acos(clamp(dot(from_eye, normalize(vec3(lean, 1.0))), -1.0, 1.0));
    float inside = (asin(1.0 / water.w) - met) / deviation;
    float windows = normal_distribution(inside);
    float shift = min(excess_over_mills(inside) - inside, 20.0);  // phi / Phi
    vec3 down = -normalize(vec3(lean + shift / deviation * along, 1.0));
    vec3 mirrored = water_glow(reflect(from_eye, -normalize(vec3(lean, 1.0))));
    vec3 out_there = refract(from_eye, down, water.w);
    vec3 light = mirrored;
    if (dot(out_there, out_there) > 0.5) {
        float passed = 1.0 - water_reflectance(max(-dot(out_there, down), 0.0), water.w);
        vec3 above = sky(normalize(vec3(out_there.xy, abs(out_there.z))), look.z);
        light = mix(mirrored, above, windows * passed);
    }
    // The sun through facets: the angle by which they turn it is a third of their lean.
    vec3 straight = refract(from_eye, -normalize(vec3(lean, 1.0)), water.w);
    if (dot(straight, straight) > 0.5) {
        float spread = 0.34 * 0.34 * 0.5 * (state.variance.x + state.variance.y) + 2e-5;
        float beside = 2.0 - 2.0 * dot(straight, sun.xyz);
        float passed = 1.0 - water_reflectance(max(straight.z, 0.0), water.w);
        // What a white surface sends is irradiance over pi.
        light += 0.5 * passed * sun.w * sun_colour.rgb * exp(-0.5 * beside / spread) / spread;
    }
    // Foam scatters what falls on it, half of it down.
    vec3 foam_light = 0.5 * light_from_above();
    light = mix(light, mix(thick_foam, thin_foam, froth.thickness) * foam_light, froth.white);
    light += foam_plume * froth.plume * light_at_eye();
    return through_water(light, from_eye, distance);
}

// Which of the surface's two sides the eye sees, by a vector square to what its pixels show of it.
bool is_underside(vec3 facing, vec3 from_eye) {
    float met = dot(facing, from_eye);
    // Far off it is seen by its edge, and pixels do not tell.
    if (abs(met) < 2e-3 * length(facing) * length(from_eye)) return eye.z < 0.0;
    // An eye above a lip that hangs over sees the lip's own water behind it: from above.
    float height = position.z + drop_at(label);
    return facing.z * met > 0.0 && (eye.z < height || height < 0.0);
}
#endif

float range_width() { return max(range.y - range.x, 1e-9); }

// A value of the shown range: blue below its middle, white there, red above.
vec4 two_sided(float value) {
    float x = clamp(2.0 * (value - range.x) / range_width() - 1.0, -1.0, 1.0);
    vec3 low = vec3(0.11, 0.30, 0.62);
    vec3 high = vec3(0.66, 0.13, 0.11);
    return vec4(x < 0.0 ? mix(vec3(0.94), low, -x) : mix(vec3(0.94), high, x), 1.0);
}

vec4 shaded_view(Water state) {
    Foam froth = foam_at(state, label);
    vec2 slope = slope_of_height(froth.height, label);
    slope /= max(1.0, length(slope));
#if BELOW
    bool below = is_underside(cross(dFdx(position), dFdy(position)), from_eye_here());
    vec3 light = below ? shaded_from_below(state, froth) : shaded(state, froth, slope);
#else
    vec3 light = shaded(state, froth, slope);
#endif
    return vec4(drawn_colour(light), 1.0);
}

// Cover, white share of the pixel, thickness of the foam there, and the value that draws it.
vec4 foam_numbers(Water state) {
    Foam froth = foam_at(state, label);
    return vec4(cover_of(state), froth.white, froth.thickness, froth.value);
}

// The cases are rows of libocean/preview/view_table.hpp. A number without a row is magenta.
vec4 shown_view(Water state) {
    switch (view.x) { VIEW_CASES }
    return vec4(1.0, 0.0, 1.0, 1.0);
}

void main() { colour = shown_view(water_at(label)); }
