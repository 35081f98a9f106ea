// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Complex numbers as vec2. Sums and products are precise, so that no compiler fuses or reorders
// them: a frame's linear fields have the same bits whatever else is requested, and with every
// driver that rounds as GLSL requires.

vec2 times_i(vec2 a) {
    return vec2(-a.y, a.x);
}

vec2 product(vec2 a, vec2 b) {
    precise vec2 result = vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
    return result;
}
