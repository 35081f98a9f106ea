// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Gullies as a function of place: erosion without a stored grid. Stripes along the fall line are
// added octave by octave to a base that has long waves alone; each octave follows the slope of the
// base and of the longer gullies. No water is routed: there are gullies, and no trunk valleys.
//
// Written without branches and with 32-bit integers, so that C++ compiles it for one point and for
// the lanes of a vector alike (real and uint are then vectors): sums, products, divisions and roots
// are rounded once each, and the bits are the same for every width. Tests: gullies_test.cpp.
//
// An octave of wavelength l has a lattice of spacing l whose points p are jittered, each with a
// phase, both hashed. With t the unit vector along the contour line of the slope so far, weights
// w = (1 - |x - p|^2 / R^2)^3 (C2) and a(p) = (x - p).t / l + phase(p) in turns,
//     (c, s) = sum of w (cos a, sin a), made a unit vector, or less: divided by at least F sum w
// [Tricard 2019]. So neighbouring stripes meet with their full depth unless they cancel. The height
// that it adds is
//     depth l g m k (q - E q),   q = 1 - 2 (sqrt((1 - c)/2 + e^2) - e),
// q a ridge with a crease of roundness e at c = 1 and a round floor at c = -1, E q its mean over a
// random phase. g is the share of an octave that the cells can hold, m = slope^2 / (slope^2 +
// flat^2) leaves flats and summits alone, and k = product over the longer octaves of
// (1 - D m max(-q, 0)) keeps their floors smooth.
//
// Masks. With p = -1 on a floor .. 1 on a ridge, a straight line of q, and 0.6^o the weight of an
// octave,
//     wear = sum of 0.6^o g m k p / sum of 0.6^o,
//     ridge = 1 - product of (1 - 0.6^o g m k eased(p)),   gully the same of -p:
// the mean over octaves, and the union of their ridges and floors. On flats all are 0.

// Widths are in spacings of the lattice.
#define gully_jitter real(0.4)
#define gully_square real(1.5625)  // R^2, R = 1.25
#define gully_least real(0.35)     // F
#define gully_damping real(0.35)   // D
// The part of the gullies' slope that turns the next octave. With all of it pleats appear, because
// sharp ridges fold the next octave.
#define gully_steer real(0.7)

struct GullyRule {
    real flat_square;  // flat^2
    real roundness;    // e
    real mean;         // of q over a phase, where (c, s) has length 1
    real short_mean;   // and where it has length 0
    real profile;      // 2 / (sqrt(1 + e^2) - e): from a ridge, 0, to a floor, 2
    real wear_scale;   // 1 / sum of the octaves' weights, those without a share included
};

struct GullyOctave {
    real height;     // depth l g [m]
    real steepness;  // 2 pi depth g
    real weight;     // in the masks, times g
    uint key;        // of the hashes
    uint last;       // lattice points of a period, less 1; 0xFFFFFFFF: does not repeat
};

// The lattice point nearest to a place, 0 .. last, and the place seen from it: -1/2 .. 1/2
// [spacings]. The host counts in double.
struct GullyCell {
    uint i;
    uint j;
    real x;
    real y;
};

struct GullyStripes {
    real cosine;
    real sine;
    real weight;
};

// The gullies added so far.
struct GullyState {
    real height;    // [m]
    real slope_x;   // that steers the next octave
    real slope_y;
    real keep;      // k
    real wear;      // sum over octaves
    real no_gully;  // 1 - mask: product over octaves
    real no_ridge;
};

// Returns the share g of an octave of this wavelength on samples that lie `cell` apart [m]: 1 from
// 4 cells a wave on, 0 up to 2, t^2 (3 - 2t) between them with t = wavelength / (2 cell) - 1.
formula real gully_share(real wavelength, real cell) {
    real twice = max(real(2.0) * cell, real(1e-30));
    real t = min(max((wavelength - twice) / twice, real(0.0)), real(1.0));
    return t * t * (real(3.0) - real(2.0) * t);
}

// Neighbours of a lattice point that comes again after `last`.
formula uint gully_before(uint i, uint last) {
    return min(i - 1u, last);
}
formula uint gully_after(uint i, uint last) {
    return last - min(last - i - 1u, last);
}

// Mixes the 32 bits of a lattice point [Wellons 2018].
formula uint gully_hash(uint bits) {
    uint h = bits;
    h = h ^ (h >> 16);
    h = h * 0x7FEB352Du;
    h = h ^ (h >> 15);
    h = h * 0x846CA68Bu;
    return h ^ (h >> 16);
}

// Sine of f turns, |f| <= 1/4: minimax polynomial, right to 2e-7.
formula real gully_sine(real f) {
    real q = f * f;
    real s = real(39.536705) * q - real(76.54978);
    s = s * q + real(81.601006);
    s = s * q - real(41.341656);
    s = s * q + real(6.283185);
    return s * f;
}

// Adds the stripes of the lattice point with this hash; (x, y) is the place seen from where it
// would lie without jitter, (along_x, along_y) is t.
formula GullyStripes gully_add(GullyStripes sum, uint hash, real x, real y, real along_x,
                               real along_y) {
    real bit = gully_jitter / real(1024.0);
    real rx = x + real(0.5) * gully_jitter - bit * real(hash & 1023u);
    real ry = y + real(0.5) * gully_jitter - bit * real((hash >> 10) & 1023u);
    real inside = max(real(1.0) - (rx * rx + ry * ry) / gully_square, real(0.0));
    real w = inside * inside * inside;
    real turns = rx * along_x + ry * along_y + real(hash >> 20) / real(4096.0);
    real a = turns - floor(turns + real(0.5));
    GullyStripes result;
    result.cosine = sum.cosine + w * gully_sine(real(0.25) - abs(a));
    result.sine = sum.sine + w * gully_sine(max(min(a, real(0.5) - a), real(-0.5) - a));
    result.weight = sum.weight + w;
    return result;
}

// Returns (c, s) of an octave: no lattice point but the nine around a place is nearer than
// 2 - 1/2 - jitter / 2 = 1.3 spacings.
formula GullyStripes gully_stripes(GullyCell cell, GullyOctave octave, real along_x, real along_y) {
    uint column[3];
    column[0] = gully_before(cell.i, octave.last) * 0x8DA6B343u;
    column[1] = cell.i * 0x8DA6B343u;
    column[2] = gully_after(cell.i, octave.last) * 0x8DA6B343u;
    uint row[3];
    row[0] = (gully_before(cell.j, octave.last) * 0xD8163841u) ^ octave.key;
    row[1] = (cell.j * 0xD8163841u) ^ octave.key;
    row[2] = (gully_after(cell.j, octave.last) * 0xD8163841u) ^ octave.key;
    GullyStripes sum;
    sum.cosine = real(0.0);
    sum.sine = real(0.0);
    sum.weight = real(0.0);
    for (int j = 0; j < 3; ++j) {
        real y = cell.y + real(float(1 - j));
        for (int i = 0; i < 3; ++i) {
            real x = cell.x + real(float(1 - i));
            sum = gully_add(sum, gully_hash(column[i] ^ row[j]), x, y, along_x, along_y);
        }
    }
    real least = gully_least * sum.weight;
    real divisor = sqrt(max(sum.cosine * sum.cosine + sum.sine * sum.sine, least * least));
    sum.cosine = sum.cosine / divisor;
    sum.sine = sum.sine / divisor;
    return sum;
}

// Rises from 0 at p = 1/2 to 1 at p = 1 (C1).
formula real gully_eased(real p) {
    real t = max(real(2.0) * p - real(1.0), real(0.0));
    return t * t * (real(3.0) - real(2.0) * t);
}

// Returns the state before the first octave, on a base with this slope.
formula GullyState gully_begin(real slope_x, real slope_y) {
    GullyState state;
    state.height = real(0.0);
    state.slope_x = slope_x;
    state.slope_y = slope_y;
    state.keep = real(1.0);
    state.wear = real(0.0);
    state.no_gully = real(1.0);
    state.no_ridge = real(1.0);
    return state;
}

// Returns the state with one more octave. Octaves come from the longest to the shortest.
formula GullyState gully_octave(GullyState state, GullyRule rule, GullyOctave octave,
                                GullyCell cell) {
    real square = state.slope_x * state.slope_x + state.slope_y * state.slope_y;
    real slope = sqrt(max(square, real(1e-24)));
    real along_x = -state.slope_y / slope;
    real along_y = state.slope_x / slope;
    GullyStripes stripes = gully_stripes(cell, octave, along_x, along_y);

    real e = rule.roundness;
    real root = sqrt(max(real(0.5) - real(0.5) * stripes.cosine, real(0.0)) + e * e);
    real q = real(1.0) - real(2.0) * (root - e);
    real steep = square / (square + rule.flat_square);
    real share = steep * state.keep;
    // The phase is random wherever (c, s) is short too, so its mean is subtracted there as well:
    // that of each length, within 0.004 by this line.
    real length_square = stripes.cosine * stripes.cosine + stripes.sine * stripes.sine;
    real mean = rule.short_mean + length_square * (rule.mean - rule.short_mean);
    state.height = state.height + octave.height * share * (q - mean);
    // dq / d(2 pi a) = -s / (2 root), along t; the lattice points' own weights are left out.
    real turn = gully_steer * octave.steepness * share * (real(-0.5) * stripes.sine / root);
    state.slope_x = state.slope_x + turn * along_x;
    state.slope_y = state.slope_y + turn * along_y;
    state.keep = state.keep * (real(1.0) - gully_damping * steep * max(-q, real(0.0)));

    real p = real(1.0) - rule.profile * (root - e);
    real seen = octave.weight * share;
    state.wear = state.wear + seen * p;
    state.no_ridge = state.no_ridge * (real(1.0) - seen * gully_eased(p));
    state.no_gully = state.no_gully * (real(1.0) - seen * gully_eased(-p));
    return state;
}

// Returns a component of the slope of base and gullies. Only steering holds a part of it back.
formula real gully_slope(real base, real steering) {
    return base + (steering - base) / gully_steer;
}
