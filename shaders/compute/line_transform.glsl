// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The inverse transform of a line of N complex numbers by N / 8 threads of one workgroup, each
// with 8 of them in its registers: element e of thread t is number t + e N / 8, before and after.
// Steps of radix 8 (Stockham, so in order without a permutation), the last of radix 8, 4 or 2, and
// between two of them an exchange through shared memory. [Cooley and Tukey 1965], with e^(+i).
// Needs complex.glsl. Defined outside:
//   N        its length
//   THREADS  N / 8, since layouts want a number
//   LINES    side by side in the workgroup
//   PAD      one free place every 2^PAD keeps the threads off each other's memory bank
//   SPLIT    real and imaginary parts one after the other, in half the memory

#define PLACES (LINES * (N + (N >> PAD)))

layout(std430, binding = 3) readonly restrict buffer Roots {
    vec2 root[];  // e^(2 pi i k / N)
};

shared float exchanged_re[PLACES];
#if !SPLIT
shared float exchanged_im[PLACES];
#endif

uint place(uint number, uint line) {
    return (number + (number >> PAD)) * LINES + line;
}

void butterfly_2(inout vec2 a, inout vec2 b) {
    precise vec2 sum = a + b;
    precise vec2 difference = a - b;
    a = sum;
    b = difference;
}

void butterfly_4(inout vec2 a, inout vec2 b, inout vec2 c, inout vec2 d) {
    butterfly_2(a, c);
    butterfly_2(b, d);
    d = times_i(d);
    butterfly_2(a, b);
    butterfly_2(c, d);
    vec2 second = c;
    c = b;
    b = second;
}

void butterfly_8(inout vec2 v[8]) {
    const float kHalfRoot = 0.70710678118654752;
    butterfly_4(v[0], v[2], v[4], v[6]);
    butterfly_4(v[1], v[3], v[5], v[7]);
    v[3] = product(v[3], vec2(kHalfRoot, kHalfRoot));
    v[5] = times_i(v[5]);
    v[7] = product(v[7], vec2(-kHalfRoot, kHalfRoot));
    butterfly_2(v[0], v[1]);
    butterfly_2(v[2], v[3]);
    butterfly_2(v[4], v[5]);
    butterfly_2(v[6], v[7]);
    // Number r of the sums is in v[2 r], number r + 4 in v[2 r + 1].
    vec2 u[8] = v;
    v[1] = u[2];
    v[2] = u[4];
    v[3] = u[6];
    v[4] = u[1];
    v[5] = u[3];
    v[6] = u[5];
}

// span: the length of the transforms that are done.
void step_8(inout vec2 v[8], uint thread, uint span) {
    uint turn = (thread & (span - 1u)) * (N / (8u * span));
    v[1] = product(v[1], root[turn]);
    v[2] = product(v[2], root[2u * turn]);
    v[3] = product(v[3], root[3u * turn]);
    v[4] = product(v[4], root[4u * turn]);
    v[5] = product(v[5], root[5u * turn]);
    v[6] = product(v[6], root[6u * turn]);
    v[7] = product(v[7], root[7u * turn]);
    butterfly_8(v);
}

// The last step, two of length N out of eight of N / 4: elements 0 2 4 6 and 1 3 5 7.
void last_step_4(inout vec2 v[8], uint thread) {
    uint other = thread + THREADS;
    v[2] = product(v[2], root[thread]);
    v[4] = product(v[4], root[2u * thread]);
    v[6] = product(v[6], root[3u * thread]);
    v[3] = product(v[3], root[other]);
    v[5] = product(v[5], root[2u * other]);
    v[7] = product(v[7], root[3u * other]);
    butterfly_4(v[0], v[2], v[4], v[6]);
    butterfly_4(v[1], v[3], v[5], v[7]);
}

// The last step out of eight of N / 2: elements 0 4, 1 5, 2 6 and 3 7.
void last_step_2(inout vec2 v[8], uint thread) {
    v[4] = product(v[4], root[thread]);
    v[5] = product(v[5], root[thread + THREADS]);
    v[6] = product(v[6], root[thread + 2u * THREADS]);
    v[7] = product(v[7], root[thread + 3u * THREADS]);
    butterfly_2(v[0], v[4]);
    butterfly_2(v[1], v[5]);
    butterfly_2(v[2], v[6]);
    butterfly_2(v[3], v[7]);
}

#define PUT(MEMORY, PART) \
    MEMORY[place(first, line)] = v[0].PART; \
    MEMORY[place(first + span, line)] = v[1].PART; \
    MEMORY[place(first + 2u * span, line)] = v[2].PART; \
    MEMORY[place(first + 3u * span, line)] = v[3].PART; \
    MEMORY[place(first + 4u * span, line)] = v[4].PART; \
    MEMORY[place(first + 5u * span, line)] = v[5].PART; \
    MEMORY[place(first + 6u * span, line)] = v[6].PART; \
    MEMORY[place(first + 7u * span, line)] = v[7].PART

#define GET(MEMORY, PART) \
    v[0].PART = MEMORY[place(thread, line)]; \
    v[1].PART = MEMORY[place(thread + THREADS, line)]; \
    v[2].PART = MEMORY[place(thread + 2u * THREADS, line)]; \
    v[3].PART = MEMORY[place(thread + 3u * THREADS, line)]; \
    v[4].PART = MEMORY[place(thread + 4u * THREADS, line)]; \
    v[5].PART = MEMORY[place(thread + 5u * THREADS, line)]; \
    v[6].PART = MEMORY[place(thread + 6u * THREADS, line)]; \
    v[7].PART = MEMORY[place(thread + 7u * THREADS, line)]

// After a step of that span: each thread gets its elements for the next.
void exchange(inout vec2 v[8], uint thread, uint line, uint span) {
    uint turn = thread & (span - 1u);
    uint first = (thread - turn) * 8u + turn;
    PUT(exchanged_re, x);
#if SPLIT
    barrier();
    GET(exchanged_re, x);
    barrier();
    PUT(exchanged_re, y);
    barrier();
    GET(exchanged_re, y);
#else
    PUT(exchanged_im, y);
    barrier();
    GET(exchanged_re, x);
    GET(exchanged_im, y);
#endif
    barrier();
}

void inverse_transform(inout vec2 v[8], uint thread, uint line) {
    butterfly_8(v);
    exchange(v, thread, line, 1u);
#if N >= 64
    step_8(v, thread, 8u);
#endif
#if N > 64
    exchange(v, thread, line, 8u);
#endif
#if N >= 512
    step_8(v, thread, 64u);
#endif
#if N > 512
    exchange(v, thread, line, 64u);
#endif
#if N >= 4096
    step_8(v, thread, 512u);
#endif
#if N > 4096
    exchange(v, thread, line, 512u);
#endif
#if N == 32 || N == 256 || N == 2048
    last_step_4(v, thread);
#elif N == 128 || N == 1024 || N == 8192
    last_step_2(v, thread);
#endif
}
