// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sums over the waves of a coast, a label for each invocation. Core's processor code is
// coast/loops/signal_code.hpp and coast/loops/band_sector_code.hpp; it finishes the surface from these
// sums. Places and phases are double until their whole turns and cells have gone: a carrier turns
// some thousand times between the label and the world's origin, and single precision would lose
// 1e-4 of it.
// Jets: a value, its derivatives along x and y [1/m] and in time [1/s]; what does not change with
// time has three components.
// Defined outside: PARTS, the components of the sums that are written: 1, 3 or 4.
#include "wave/turns.glsl"

layout(local_size_x = 64) in;

struct Pair {
    dvec2 cells_per_metre;
    dvec2 half_turns;  // of the carrier [1/m]
    uvec2 mask;        // columns and rows of the coefficients, less 1
    uint pitch;
    uint values;  // index of the first coefficient
    uint rates;
    int band;
    float centre;  // direction of the sector's middle [rad]
    float open_displacement;
};

layout(std430, binding = 0) readonly buffer Labels {
    dvec2 label[];
};
layout(std430, binding = 1) readonly buffer Coefficients {
    vec2 coefficient[];  // complex
};
layout(std430, binding = 2) readonly buffer Coast {
    dvec2 delay_origin, energy_origin;
    double delays_per_metre, energies_per_metre;
    ivec2 delay_samples, energy_samples;
    int pair_count;
    int depth_count;
    float first_log;
    float per_log;
    Pair pair[];
};
layout(std430, binding = 3) readonly buffer Depths {
    vec4 displacement_at[];  // coth(k d) of the four bands
};
layout(std430, binding = 4) writeonly buffer Sums {
    float sums[];
};
layout(location = 0) uniform int label_count;
layout(binding = 0) uniform sampler2DArray delay_maps;   // of the pairs, then the ground
layout(binding = 1) uniform sampler2DArray energy_maps;  // amplitudes, then the remainder

// ---- jets

vec4 jet_product(vec4 a, vec4 b) {
    return vec4(a.x * b.x, a.x * b.yzw + b.x * a.yzw);
}
vec4 jet_product(vec4 a, vec3 b) {
    return jet_product(a, vec4(b, 0.0));
}
vec3 jet_product(vec3 a, vec3 b) {
    return vec3(a.x * b.x, a.x * b.yz + b.x * a.yz);
}

struct Turn {
    vec3 cosine;
    vec3 sine;
};

SinCos sin_cos_reduced(double turns) {
    return sin_cos_turns(float(turns - roundEven(turns)));
}

const double kPerRadian = 0.15915494309189535LF;

Turn turn_by(vec3 angle) {
    SinCos at = sin_cos_reduced(double(angle.x) * kPerRadian);
    return Turn(vec3(at.cosine, -at.sine * angle.yz), vec3(at.sine, at.cosine * angle.yz));
}

// ---- maps that do not change with time: field/quad_grid.hpp

struct Place {
    ivec2 first;  // the sample before the label
    vec2 fraction;
    ivec2 last;  // sample
    float per_metre;
};

struct Quads {
    vec4 value, by_x, by_y;
    vec4 highest;  // of the samples that it is read from
};

Place find_place(dvec2 at, dvec2 origin, double per_metre, ivec2 samples) {
    dvec2 inside = clamp((at - origin) * per_metre, dvec2(0.0), dvec2(samples - 1));
    ivec2 first = min(ivec2(inside), max(samples - 2, ivec2(0)));
    return Place(first, vec2(inside - dvec2(first)), samples - 1, float(per_metre));
}

vec4 cubic_weights(float t) {
    return vec4(-0.5 * t * (1.0 - t) * (1.0 - t), 1.0 + t * t * (1.5 * t - 2.5),
                t * (0.5 + t * (2.0 - 1.5 * t)), -0.5 * t * t * (1.0 - t));
}
vec4 cubic_slopes(float t) {
    return vec4(-0.5 + t * (2.0 - 1.5 * t), t * (4.5 * t - 5.0), 0.5 + t * (4.0 - 4.5 * t),
                t * (1.5 * t - 1.0));
}

Quads read_quads(sampler2DArray maps, int layer, Place place) {
    vec4 along_x = cubic_weights(place.fraction.x);
    vec4 along_y = cubic_weights(place.fraction.y);
    vec4 slope_x = cubic_slopes(place.fraction.x);
    vec4 slope_y = cubic_slopes(place.fraction.y);
    Quads quads = Quads(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    for (int i = 0; i < 4; ++i) {
        vec4 sum = vec4(0.0), slope = vec4(0.0);
        for (int j = 0; j < 4; ++j) {
            ivec2 at = clamp(place.first + ivec2(i, j) - 1, ivec2(0), place.last);
            vec4 texel = texelFetch(maps, ivec3(at, layer), 0);
            sum += along_y[j] * texel;
            slope += slope_y[j] * texel;
            quads.highest = max(quads.highest, texel);
        }
        quads.value += along_x[i] * sum;
        quads.by_x += place.per_metre * slope_x[i] * sum;
        quads.by_y += place.per_metre * along_x[i] * slope;
    }
    return quads;
}

vec3 field(Quads quads, int component) {
    return vec3(quads.value[component], quads.by_x[component], quads.by_y[component]);
}

// ---- signals: coast/loops/signal_code.hpp

struct Signal {
    vec4 re, im;
};

struct Complexes {
    vec2 value, by_x, by_y;  // [1/cell]
};

Complexes read_spline(uint first, Pair of, uvec2 cell, vec2 t) {
    const vec4 c0 = vec4(1.0, 4.0, 1.0, 0.0) / 6.0;
    const vec4 c1 = vec4(-0.5, 0.0, 0.5, 0.0);
    const vec4 c2 = vec4(0.5, -1.0, 0.5, 0.0);
    const vec4 c3 = vec4(-1.0, 3.0, -3.0, 1.0) / 6.0;
    vec4 along_x = ((c3 * t.x + c2) * t.x + c1) * t.x + c0;
    vec4 along_y = ((c3 * t.y + c2) * t.y + c1) * t.y + c0;
    vec4 slope_x = (3.0 * c3 * t.x + 2.0 * c2) * t.x + c1;
    vec4 slope_y = (3.0 * c3 * t.y + 2.0 * c2) * t.y + c1;
    Complexes sum = Complexes(vec2(0.0), vec2(0.0), vec2(0.0));
    for (uint j = 0u; j < 4u; ++j) {
        uint at = first + ((cell.y + j - 1u) & of.mask.y) * of.pitch + cell.x;
        mat4x2 four = mat4x2(coefficient[at], coefficient[at + 1u], coefficient[at + 2u],
                             coefficient[at + 3u]);
        vec2 row = four * along_x;
        sum.value += along_y[j] * row;
        sum.by_x += along_y[j] * (four * slope_x);
        sum.by_y += slope_y[j] * row;
    }
    return sum;
}

// The signal and its derivatives by the place at which it is read.
Signal read_signal(Pair of, dvec2 place) {
    dvec2 at = place * of.cells_per_metre;
    dvec2 whole = roundEven(at - 0.5LF);
    vec2 t = vec2(at - whole);
    uvec2 cell = uvec2(ivec2(whole)) & of.mask;
    SinCos turn =
        sin_cos_reduced(0.5LF * (of.half_turns.x * place.x + of.half_turns.y * place.y));
    mat2 carrier = mat2(turn.cosine, turn.sine, -turn.sine, turn.cosine);
    Complexes sum = read_spline(of.values, of, cell, t);
    vec2 i_value = vec2(-sum.value.y, sum.value.x);
    vec2 cells = vec2(of.cells_per_metre);
    vec2 k = 3.14159265358979 * vec2(of.half_turns);
    vec2 value = carrier * sum.value;
    vec2 by_x = carrier * (cells.x * sum.by_x + k.x * i_value);
    vec2 by_y = carrier * (cells.y * sum.by_y + k.y * i_value);
    vec2 rate = vec2(0.0);
#if PARTS == 4
    rate = carrier * read_spline(of.rates, of, cell, t).value;
#endif
    return Signal(vec4(value.x, by_x.x, by_y.x, rate.x), vec4(value.y, by_x.y, by_y.y, rate.y));
}

// ---- the sums: coast/loops/band_sector_code.hpp

struct WaveSums {
    vec4 z_re, z_im, squares, along_x, along_y, left_x, left_y;
};

// A jet by the shifted place as one by the label, which the place follows by its shift.
vec4 by_label(vec4 at_place, vec3 shift_x, vec3 shift_y) {
    vec4 jet = at_place;
    jet.yz += at_place.y * shift_x.yz + at_place.z * shift_y.yz;
    return jet;
}

void add_band_sector(Pair of, dvec2 place, Quads delay, vec3 amplitude, vec3 displacement,
              inout WaveSums sums) {
    vec3 shift_x = field(delay, 0);
    vec3 shift_y = field(delay, 1);
    Signal signal = read_signal(of, place + dvec2(shift_x.x, shift_y.x));
    vec4 re = by_label(signal.re, shift_x, shift_y);
    vec4 im = by_label(signal.im, shift_x, shift_y);

    Turn phase = turn_by(field(delay, 2));
    vec3 cosine = jet_product(amplitude, phase.cosine);
    vec3 sine = jet_product(amplitude, phase.sine);
    vec4 z_re = jet_product(re, cosine) - jet_product(im, sine);
    vec4 z_im = jet_product(re, sine) + jet_product(im, cosine);
    sums.z_re += z_re;
    sums.z_im += z_im;
    sums.squares += jet_product(z_re, z_re) + jet_product(z_im, z_im);

    Turn direction = turn_by(field(delay, 3) + vec3(of.centre, 0.0, 0.0));
    vec4 displaced = jet_product(z_im, displacement);
    sums.along_x += jet_product(displaced, direction.cosine);
    sums.along_y += jet_product(displaced, direction.sine);
}

void add_left(Pair of, dvec2 place, inout WaveSums sums) {
    vec4 displaced = of.open_displacement * read_signal(of, place).im;
    sums.left_x += cos(of.centre) * displaced;
    sums.left_y += sin(of.centre) * displaced;
}

float held_in_unit(float x) {
    return x <= 0.0 ? 0.0 : x >= 1.0 - 1e-6 ? 1.0 : x;
}

// coth(k d) of the bands' middles at a depth: coast/statics/shore_depths.cpp
void read_displacement(vec3 depth, out vec3 displacement[4]) {
    float at = clamp((log(depth.x) - first_log) * per_log, 0.0, float(depth_count - 1));
    int first = min(int(at), depth_count - 2);
    vec4 weights = cubic_weights(at - float(first));
    vec4 slopes = cubic_slopes(at - float(first));
    vec4 value = vec4(0.0), slope = vec4(0.0);
    for (int a = 0; a < 4; ++a) {
        vec4 entry = displacement_at[clamp(first + a - 1, 0, depth_count - 1)];
        value += weights[a] * entry;
        slope += slopes[a] * entry;
    }
    for (int band = 0; band < 4; ++band) {
        displacement[band] = vec3(value[band], slope[band] * per_log / depth.x * depth.yz);
    }
}

WaveSums sum_waves(dvec2 place) {
    WaveSums sums = WaveSums(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0),
                             vec4(0.0));
    Place in_delays = find_place(place, delay_origin, delays_per_metre, delay_samples);
    Place in_energy = find_place(place, energy_origin, energies_per_metre, energy_samples);
    Quads ground = read_quads(delay_maps, pair_count, in_delays);
    Quads remainder = read_quads(energy_maps, (pair_count + 3) / 4, in_energy);
    if (ground.highest.w <= 0.0 && remainder.highest.z <= 0.0) return sums;
    bool is_partly =
        (1.0 - held_in_unit(ground.value.w)) * (1.0 - held_in_unit(remainder.value.z)) > 0.0;
    vec3 displacement[4];
    read_displacement(field(ground, 1), displacement);
    Quads amplitudes;
    for (int p = 0; p < pair_count; ++p) {
        Pair of = pair[p];
        if (p % 4 == 0) amplitudes = read_quads(energy_maps, p / 4, in_energy);
        Quads delay = read_quads(delay_maps, p, in_delays);
        add_band_sector(of, place, delay, field(amplitudes, p % 4), displacement[of.band], sums);
        if (is_partly) add_left(of, place, sums);
    }
    return sums;
}

void write_sum(int sum, int label, vec4 jet) {
    for (int p = 0; p < PARTS; ++p) sums[(sum * PARTS + p) * label_count + label] = jet[p];
}

void main() {
    int at = int(gl_GlobalInvocationID.x);
    if (at >= label_count) return;
    WaveSums all = sum_waves(label[at]);
    write_sum(0, at, all.z_re);
    write_sum(1, at, all.z_im);
    write_sum(2, at, all.squares);
    write_sum(3, at, all.along_x);
    write_sum(4, at, all.along_y);
    write_sum(5, at, all.left_x);
    write_sum(6, at, all.left_y);
}
