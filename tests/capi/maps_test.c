// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// ocean_evaluate: what lands in a host's buffers, and what is refused.
#include <math.h>

#include "tests.h"

enum { kUntouched = 77 };
static const double kTime = 12.0;

/* The small sea's map in an output of these channels and axes, in a buffer filled with kUntouched;
 * to be freed by the caller. */
static float* interleaved(ocean_sea* sea, const int32_t channel[4], int32_t channels,
                          int32_t axes) {
    ocean_output output = {NULL, 0, {0, 0, 0, 0}, 0, 0};
    ocean_request request = {sizeof(ocean_request), 0.0, 0, NULL, 1};
    output.count = (size_t)kSmallCount * (size_t)channels;
    output.data = malloc(output.count * sizeof(float));
    output.channels = channels;
    output.axes = axes;
    memcpy(output.channel, channel, sizeof(output.channel));
    for (size_t i = 0; i < output.count; ++i) output.data[i] = kUntouched;
    request.time = kTime;
    request.outputs = &output;
    CHECK_RESULT(OCEAN_OK, ocean_evaluate(sea, &request));
    return output.data;
}

/* Component c of `data` is `sign` times the planar map of `channel` (-1: untouched). */
static int holds(ocean_sea* sea, const float* data, int channels, int c, int32_t channel,
                 float sign) {
    float* map = channel < 0 ? NULL : planar_map(sea, kTime, 0, channel);
    int same = 1;
    for (int i = 0; i < kSmallCount; ++i) {
        const float expected = map == NULL ? kUntouched : sign * map[i];
        same &= data[i * channels + c] == expected;
    }
    free(map);
    return same;
}

void interleaved_outputs_hold_the_planar_maps(void) {
    const int32_t available[] = {OCEAN_DX,       OCEAN_DY, OCEAN_HEIGHT,  OCEAN_NX,
                                 OCEAN_NY,       OCEAN_NZ, OCEAN_SLOPE_X, OCEAN_SLOPE_Y,
                                 OCEAN_JACOBIAN, OCEAN_VX, OCEAN_VY,      OCEAN_VZ};
    const int count = (int)(sizeof(available) / sizeof(available[0]));
    ocean_sea* sea = open_small_sea(NULL);
    for (int first = 0; first < count; ++first) {
        const int32_t channel[4] = {available[first], -1, available[(first + 5) % count],
                                    available[(first + 7) % count]};
        for (int channels = 1; channels <= 4; ++channels) {
            float* data = interleaved(sea, channel, channels, OCEAN_ZUP);
            for (int c = 0; c < channels; ++c) {
                CHECK(holds(sea, data, channels, c, channel[c], 1.0f));
            }
            free(data);
        }
    }
    ocean_free(sea);
}

void axes_turn_whole_vectors_only(void) {
    const int32_t vectors[3][3] = {{OCEAN_DX, OCEAN_DY, OCEAN_HEIGHT},
                                   {OCEAN_NX, OCEAN_NY, OCEAN_NZ},
                                   {OCEAN_VX, OCEAN_VY, OCEAN_VZ}};
    /* Almost vectors: another third component, another second, another order. */
    const int32_t parts[3][4] = {{OCEAN_NX, OCEAN_NY, OCEAN_HEIGHT, OCEAN_DY},
                                 {OCEAN_VX, -1, OCEAN_VZ, OCEAN_VY},
                                 {OCEAN_DY, OCEAN_DX, OCEAN_HEIGHT, -1}};
    ocean_sea* sea = open_small_sea(NULL);
    float* data;
    for (int v = 0; v < 3; ++v) {
        const int32_t* xyz = vectors[v];
        for (int offset = 0; offset < 2; ++offset) {
            int32_t channel[4] = {-1, -1, -1, -1};
            memcpy(channel + offset, xyz, 3 * sizeof(int32_t));
            data = interleaved(sea, channel, 4, OCEAN_YUP);
            CHECK(holds(sea, data, 4, offset + 0, xyz[0], 1.0f));
            CHECK(holds(sea, data, 4, offset + 1, xyz[2], 1.0f));
            CHECK(holds(sea, data, 4, offset + 2, xyz[1], -1.0f));
            CHECK(holds(sea, data, 4, 3 - 3 * offset, -1, 1.0f));
            free(data);
            data = interleaved(sea, channel, 4, OCEAN_TNB);
            CHECK(holds(sea, data, 4, offset + 0, xyz[0], 1.0f));
            CHECK(holds(sea, data, 4, offset + 1, xyz[2], 1.0f));
            CHECK(holds(sea, data, 4, offset + 2, xyz[1], 1.0f));
            free(data);
            memcpy(channel, xyz, 3 * sizeof(int32_t));
            data = interleaved(sea, channel, 2, OCEAN_TNB);
            CHECK(holds(sea, data, 2, 1, xyz[1], 1.0f));
            free(data);
        }
    }
    for (int p = 0; p < 3; ++p) {
        data = interleaved(sea, parts[p], 4, OCEAN_YUP);
        for (int c = 0; c < 4; ++c) CHECK(holds(sea, data, 4, c, parts[p][c], 1.0f));
        free(data);
    }
    ocean_free(sea);
}

void a_finer_map_passes_through_the_coarse_samples(void) {
    ocean_sea* sea = open_small_sea(NULL);
    float* coarse = planar_map(sea, kTime, 0, OCEAN_HEIGHT);
    float* fine = planar_map(sea, kTime, 128, OCEAN_HEIGHT);
    double squares = 0.0;
    double differences = 0.0;
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 64; ++i) {
            const double height = coarse[j * 64 + i];
            const double difference = height - fine[2 * j * 128 + 2 * i];
            squares += height * height;
            differences += difference * difference;
        }
    }
    CHECK(sqrt(squares / kSmallCount) > 0.1);
    CHECK(sqrt(differences / squares) < 2e-6);
    free(coarse);
    free(fine);
    ocean_free(sea);
}

/* A good request on shared storage, for one field after the other to be spoilt. */
static float buffer[kSmallCount * 4];
static ocean_output output;
static ocean_request good_request(void) {
    ocean_request request = {sizeof(ocean_request), 1.0, 0, NULL, 1};
    const ocean_output good = {
        buffer, kSmallCount * 3, {OCEAN_DX, OCEAN_DY, OCEAN_HEIGHT, 1000}, 3, OCEAN_TNB};
    output = good;
    request.outputs = &output;
    return request;
}

static void refused(ocean_sea* sea, ocean_result code, ocean_request request, const char* word) {
    CHECK_RESULT(code, ocean_evaluate(sea, &request));
    if (strstr(ocean_last_error(), word) == NULL) {
        fprintf(stderr, "'%s' is not in: %s\n", word, ocean_last_error());
        ++failures;
    }
    for (int i = 0; i < kSmallCount * 4; ++i) {
        if (buffer[i] == 0.0f) continue;
        fprintf(stderr, "written although refused (%s)\n", word);
        ++failures;
        return;
    }
}

/* Runs `refused` with one assignment applied to a good request. */
#define REFUSED(assignment, word)                              \
    do {                                                       \
        ocean_request request = good_request();                \
        assignment;                                            \
        refused(sea, OCEAN_INVALID_ARGUMENT, request, (word)); \
    } while (0)

void bad_requests_are_refused_and_write_nothing(void) {
    const int32_t resolutions[] = {-64, 1, 16, 33, 96, 16384, INT32_MAX, INT32_MIN};
    ocean_sea* sea = open_small_sea(NULL);
    REFUSED(request.struct_size = 0, "struct_size");
    REFUSED(request.struct_size = sizeof(ocean_request) - 8, "struct_size");
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
    REFUSED(output.channel[1] = OCEAN_VZ + 1, "channel[1]");
    REFUSED(output.channel[2] = -2, "channel[2]");
    REFUSED(output.channel[0] = output.channel[1] = output.channel[2] = -1, "no output");
    for (size_t i = 0; i < sizeof(resolutions) / sizeof(resolutions[0]); ++i) {
        REFUSED(request.resolution = resolutions[i], "resolution");
    }
    /* And the good one is good: a channel beyond `channels` is not read. */
    {
        const ocean_request request = good_request();
        CHECK_RESULT(OCEAN_OK, ocean_evaluate(sea, &request));
        CHECK(buffer[1] != 0.0f && buffer[kSmallCount * 3] == 0.0f);
        memset(buffer, 0, sizeof(buffer));
    }
    ocean_free(sea);
}

void foam_and_whitecaps_are_channels_like_others(void) {
    ocean_sea* sea = open_small_sea(NULL);
    ocean_request request = good_request();
    CHECK_RESULT(OCEAN_OK, ocean_set(sea, "wind_speed", "15"));
    CHECK_RESULT(OCEAN_OK, ocean_set(sea, "foam_lifetime", "1"));
    output.channel[0] = OCEAN_WHITECAP;
    output.channel[1] = OCEAN_FOAM;
    output.channel[2] = -1;
    CHECK_RESULT(OCEAN_OK, ocean_evaluate(sea, &request));
    float most = 0.0f;
    for (size_t i = 0; i < kSmallCount; ++i) {
        const float whitecap = buffer[3 * i];
        const float foam = buffer[3 * i + 1];
        CHECK(whitecap >= 0.0f && whitecap <= foam && foam <= 1.0f);
        if (foam > most) most = foam;
    }
    CHECK(most > 0.0f);
    ocean_free(sea);
}
