// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Foam in detail: which part of a point's neighbourhood is white, from the cover c there, 0 .. 1,
// and the values T of textures that are uniform in [0, 1] (ocean/internal/foam_texture.hpp). T < c
// holds on the share c of the area. All functions here preserve that: combined textures are uniform
// again, and the mean of a softened or faded mask is c, so that the visible foam is as much as the
// wind makes. Test: foam_lace_test.cpp.

// Returns the sum a + share b of two independent textures, 0 < share <= 1, made uniform by its own
// distribution function, that of the trapezoid: b breaks up the pattern of a. The density of z
// rises as z / share up to share, is 1 up to 1, and falls to 0 at 1 + share.
formula real add_uniform(real a, real b, real share) {
    real z = a + share * b;
    real rest = real(1.0) + share - z;
    if (z < share) return z * z / (real(2.0) * share);
    if (z > real(1.0)) return real(1.0) - rest * rest / (real(2.0) * share);
    return z - real(0.5) * share;
}

// Both patterns at once: z = min(a, begins + b), where b joins as soon as the cover of a reaches
// `begins` >= 0, made uniform: a > z with probability 1 - z, begins + b > z with 1 - (z - begins);
// 1 less their product.
formula real unite_uniform(real a, real b, real begins) {
    real z = min(a, begins + b);
    real joined = min(max(z - begins, real(0.0)), real(1.0));
    return z + joined - z * joined;
}

// Returns how white a point is, 0 .. 1: clamp(1/2 + (c' - T) / edge), 0 < edge <= 1. The mean of a
// whole ramp is at its middle, so c' = c. Within half an edge of 0 or 1 a part of the ramp lies
// outside [0, 1]. Near 0 a triangle from T = 0 to c' + edge / 2 remains, whose area is (c' + edge /
// 2)^2 / (2 edge): that is c for the c' below. Near 1 the same holds for the part that is not
// white.
formula real foam_mask(real cover, real value, real edge) {
    real c = min(max(cover, real(0.0)), real(1.0));
    real middle = c;
    if (c < real(0.5) * edge) {
        middle = sqrt(real(2.0) * edge * c) - real(0.5) * edge;
    } else if (c > real(1.0) - real(0.5) * edge) {
        middle = real(1.0) + real(0.5) * edge - sqrt(real(2.0) * edge * (real(1.0) - c));
    }
    return min(max(real(0.5) + (middle - value) / edge, real(0.0)), real(1.0));
}

// How thick the foam is, 0 at its edges to 1 where the texture is lower than the cover by `span`
// or more: thin foam lets the water through.
formula real foam_thickness(real cover, real value, real span) {
    return min(max((cover - value) / span, real(0.0)), real(1.0));
}

// Returns the mean thickness over T < c, for foam too far away to have a pattern: the integral of
// the thickness over T, c^2 / (2 span) or c - span / 2, divided by c. Both branches meet with equal
// slope at c = span.
formula real foam_mean_thickness(real cover, real span) {
    if (cover < span) return real(0.5) * max(cover, real(0.0)) / span;
    return real(1.0) - real(0.5) * span / cover;
}

// Returns the share of the pattern that a pixel is too large to show, 0 .. 1: `footprint` is a
// pixel's size and `cell` the width of the pattern's widest cells, both in metres. The walls of
// cells are a tenth of them and more: pixels of a tenth of a cell show all, those of 1.5 cells
// none.
formula real foam_fade(real footprint, real cell) {
    real far = min(max((footprint / cell - real(0.1)) / real(1.4), real(0.0)), real(1.0));
    return far * far * (real(3.0) - real(2.0) * far);
}

// Returns how white a pixel is: from the mask to the cover itself as the pixel becomes too large
// for the pattern. Both ends have the mean c, so all between have it.
formula real foam_faded(real mask, real cover, real footprint, real cell) {
    return mask + (cover - mask) * foam_fade(footprint, cell);
}

// Returns the width of the mask's edge in a pixel, which blurs the pattern: a thin wall is grey
// then, and not white in one pixel and dark in the next one.
formula real foam_pixel_edge(real edge, real footprint, real cell) {
    return min(edge + footprint / cell, real(1.0));
}

// Returns the thickness in a pixel: a soft mask is white where the foam is thin too, so that the
// mean over the pattern takes the place of the thickness as pixels blur it.
formula real foam_pixel_thickness(real thickness, real mean, real footprint, real cell) {
    return thickness + (mean - thickness) * min(real(2.5) * footprint / cell, real(1.0));
}

// Returns the cover that windrows have gathered: `streaks`, uniform in [0, 1], draw a share of it,
// with the widest edge. What remains of the pattern where pixels are larger than its cells.
formula real foam_in_streaks(real cover, real streaks, real share) {
    return cover + share * (foam_mask(cover, streaks, real(1.0)) - cover);
}

// Returns the bubbles under the surface, 0 .. 1: those that breakers drove down, and those below
// and around the foam, as the water blurs its pattern.
formula real foam_bubbles(real driven, real cover, real value) {
    return max(driven, foam_mask(cover, value, real(1.0)));
}
