// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The data between the two passes: PACKS grids of N x N complex numbers. A pack holds two real
// fields, one in the real part, the other in the imaginary part. Both fields vanish on the
// lattice's Nyquist lines; else they would leak into each other. Columns lie side by side in blocks
// of LINES, so that pass one writes and pass two reads whole blocks.

layout(std430, binding = 4) restrict buffer Pack0 { vec2 value[]; } pack_0;
#if PACKS > 1
layout(std430, binding = 5) restrict buffer Pack1 { vec2 value[]; } pack_1;
#endif
#if PACKS > 2
layout(std430, binding = 6) restrict buffer Pack2 { vec2 value[]; } pack_2;
#endif
#if PACKS > 3
layout(std430, binding = 7) restrict buffer Pack3 { vec2 value[]; } pack_3;
#endif
#if PACKS > 4
layout(std430, binding = 8) restrict buffer Pack4 { vec2 value[]; } pack_4;
#endif
#if PACKS > 5
layout(std430, binding = 9) restrict buffer Pack5 { vec2 value[]; } pack_5;
#endif

uint pack_index(uint x, uint y) {
    return (x / COLUMNS * N + y) * COLUMNS + x % COLUMNS;
}
