// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// ocean_evaluate: what lands in a host's buffers, and what is refused.
#include <math.h>
#include <stddef.h>
#include <stdint.h>

#include "tests.h"

static const double kTime = 12.0;

void requests_of_older_headers_are_understood(void) {
    struct first_output {
        float* data;
        size_t count;
        int32_t channel[4];
        int32_t channels;
        int32_t axes;
    } first[2] = {{NULL, kSmallCount, {OCEAN_HEIGHT, 0, 0, 0}, 1, OCEAN_ZUP},
                  {NULL, kSmallCount, {OCEAN_NZ, 0, 0, 0}, 1, OCEAN_ZUP}};
    struct newer_output {
        ocean_output known;
        int64_t unknown;
    } newer[2] = {{{.count = kSmallCount, .channel = {OCEAN_HEIGHT}, .channels = 1}, 0},
                  {{.count = kSmallCount, .channel = {OCEAN_NZ}, .channels = 1}, 0}};
    ocean_sea* sea = small_sea(NULL);
    float* expected[2];
    ocean_request request = {.time = kTime, .output_count = 2};
    CHECK(sizeof(struct first_output) == offsetof(ocean_output, row_pitch));
    for (int i = 0; i < 2; ++i) {
        expected[i] = planar_map(sea, kTime, 0, i == 0 ? OCEAN_HEIGHT : OCEAN_NZ);
        first[i].data = scratch(kSmallCount * sizeof(float));
        newer[i].known.data = first[i].data;
    }
    /* What lies behind the end of an older request is not read. */
    request.struct_size = offsetof(ocean_request, output_size);
    request.output_size = 12345;
    request.cascade = 77;
    request.outputs = (const ocean_output*)(const void*)first;
    OK(ocean_evaluate(sea, &request));
    for (int i = 0; i < 2; ++i) {
        CHECK(memcmp(first[i].data, expected[i], kSmallCount * sizeof(float)) == 0);
        memset(first[i].data, 0, kSmallCount * sizeof(float));
    }
    request.struct_size = sizeof(request);
    request.output_size = sizeof(newer[0]);
    request.cascade = 0;
    request.outputs = &newer[0].known;
    OK(ocean_evaluate(sea, &request));
    for (int i = 0; i < 2; ++i) {
        CHECK(memcmp(first[i].data, expected[i], kSmallCount * sizeof(float)) == 0);
    }
    newer[1].unknown = 1;
    CHECK_RESULT(OCEAN_UNSUPPORTED, ocean_evaluate(sea, &request));
}

void cascades_have_periods_and_what_does_not_add_up_is_refused(void) {
    const int32_t refused[] = {OCEAN_NZ, OCEAN_JACOBIAN, OCEAN_WHITECAP, OCEAN_FOAM};
    float data[kSmallCount];
    double periods[2] = {0.0, 0.0};
    size_t count = 1;
    ocean_output part = {
        .data = data, .count = kSmallCount, .channel = {OCEAN_HEIGHT}, .channels = 1};
    const ocean_request request = {
        .struct_size = sizeof(request), .outputs = &part, .output_count = 1, .cascade = 2};
    ocean_sea* sea = small_sea(NULL);
    OK(ocean_set(sea, "cascades", "2"));
    CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL, ocean_cascade_periods(sea, periods, &count));
    CHECK(count == 2 && periods[0] == 0.0);
    OK(ocean_cascade_periods(sea, NULL, &count));
    OK(ocean_cascade_periods(sea, periods, &count));
    CHECK(periods[0] == 200.0 && periods[1] < 200.0);
    OK(ocean_evaluate(sea, &request)); /* where 0 is asked, the lattice of the cascade */
    for (int i = 0; i < 4; ++i) {
        part.channel[0] = refused[i];
        BAD_VALUE(ocean_evaluate(sea, &request));
    }
}

/* A good request on shared storage, for one field after the other to be spoilt. */
static float buffer[kSmallCount * 4];
static ocean_output output;
static ocean_request good_request(void) {
    ocean_request request = {.struct_size = sizeof(ocean_request), .time = 1.0, .output_count = 1};
    const ocean_output good = {.data = buffer,
                               .count = kSmallCount * 3,
                               .channel = {OCEAN_DX, OCEAN_DY, OCEAN_HEIGHT, 1000},
                               .channels = 3,
                               .axes = OCEAN_TNB};
    output = good;
    request.outputs = &output;
    return request;
}

static void refused(ocean_sea* sea, ocean_request request, const char* word) {
    BAD_ARGUMENT(ocean_evaluate(sea, &request));
    CHECK_HOLDS(ocean_last_error(), word);
    for (int i = 0; i < kSmallCount * 4; ++i) {
        if (buffer[i] == 0.0f) continue;
        fprintf(stderr, "written although refused (%s)\n", word);
        ++failures;
        return;
    }
}

/* Runs `refused` with one assignment applied to a good request. */
#define REFUSED(assignment, word)               \
    do {                                        \
        ocean_request request = good_request(); \
        assignment;                             \
        refused(sea, request, (word));          \
    } while (0)

void bad_requests_are_refused_and_write_nothing(void) {
    const int32_t resolutions[] = {-64, 1, 16, 33, 96, 16384, INT32_MAX, INT32_MIN};
    ocean_sea* sea = small_sea(NULL);
    REFUSED(request.struct_size = 0, "struct_size");
    REFUSED(request.struct_size = offsetof(ocean_request, output_count), "struct_size");
    REFUSED(request.output_size = 8, "output_size");
    REFUSED(request.output_size = 5000, "output_size");
    REFUSED(request.cascade = -1, "cascade");
    REFUSED(request.cascade = 2, "cascade");
    REFUSED(request.reserved = 1, "reserved");
    REFUSED(output.reserved = 1, "reserved");
    REFUSED(output.seam = 1, "count");
    REFUSED(output.row_pitch = 64 * 3 - 1, "row_pitch");
    REFUSED(output.row_pitch = SIZE_MAX / 8, "row_pitch");
    REFUSED(output.row_pitch = 64 * 3 + 1, "count");
    REFUSED(request.struct_size = 100000, "struct_size");
    REFUSED(request.time = (double)NAN, "time");
    REFUSED(request.time = (double)INFINITY, "time");
    REFUSED(request.time = -(double)INFINITY, "time");
    REFUSED(request.outputs = NULL, "outputs");
    REFUSED(request.output_count = 0, "no output");
    REFUSED(output.data = NULL, "data");
    REFUSED(output.count = kSmallCount * 3 - 1, "count");
    REFUSED(request.resolution = 128, "count");
    REFUSED(output.channels = 0, "channels");
    REFUSED(output.channels = 5, "channels");
    REFUSED(output.channels = -1, "channels");
    REFUSED(output.axes = 3, "axes");
    REFUSED(output.axes = -1, "axes");
    REFUSED(output.channel[1] = OCEAN_COVER + 1, "channel[1]");
    REFUSED(output.channel[2] = -2, "channel[2]");
    REFUSED(output.channel[0] = output.channel[1] = output.channel[2] = -1, "no output");
    for (size_t i = 0; i < sizeof(resolutions) / sizeof(resolutions[0]); ++i) {
        REFUSED(request.resolution = resolutions[i], "resolution");
    }
    /* And the good one is good: a channel beyond `channels` is not read. */
    {
        const ocean_request request = good_request();
        OK(ocean_evaluate(sea, &request));
        CHECK(buffer[1] != 0.0f && buffer[kSmallCount * 3] == 0.0f);
        memset(buffer, 0, sizeof(buffer));
    }
}

void bad_cover_powers_are_refused_and_write_nothing(void) {
    ocean_sea* sea = small_sea(NULL);
    double power = 0.0;
    OK(ocean_cover_power(sea, 1.0, 0, &power));
    CHECK(power > 1.5 && power < 6.0);
    power = 77.0;
    BAD_ARGUMENT(ocean_cover_power(sea, NAN, 0, &power));
    BAD_ARGUMENT(ocean_cover_power(sea, 0.0, 100, &power));
    BAD_ARGUMENT(ocean_cover_power(sea, 0.0, 0, NULL));
    BAD_ARGUMENT(ocean_cover_power(NULL, 0.0, 0, &power));
    CHECK(power == 77.0);
}
