// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// ocean_evaluate: what lands in a host's buffers, and what is refused.
#include <math.h>
#include <stddef.h>
#include <stdint.h>

#include "tests.h"

enum { kUntouched = 77 };
static const double kTime = 12.0;

/* The small sea's map in an output of these channels and axes, in a buffer filled with kUntouched.
 */
static float* interleaved(ocean_sea* sea, const int32_t channel[4], int32_t channels,
                          int32_t axes) {
    ocean_output output = {.channels = channels, .axes = axes};
    ocean_request request = {.struct_size = sizeof(ocean_request), .output_count = 1};
    output.count = (size_t)kSmallCount * (size_t)channels;
    output.data = scratch(output.count * sizeof(float));
    memcpy(output.channel, channel, sizeof(output.channel));
    for (size_t i = 0; i < output.count; ++i) output.data[i] = kUntouched;
    request.time = kTime;
    request.outputs = &output;
    OK(ocean_evaluate(sea, &request));
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
    return same;
}

void interleaved_outputs_hold_the_planar_maps(void) {
    const int32_t available[] = {OCEAN_DX,       OCEAN_DY, OCEAN_HEIGHT,  OCEAN_NX,
                                 OCEAN_NY,       OCEAN_NZ, OCEAN_SLOPE_X, OCEAN_SLOPE_Y,
                                 OCEAN_JACOBIAN, OCEAN_VX, OCEAN_VY,      OCEAN_VZ};
    const int count = (int)(sizeof(available) / sizeof(available[0]));
    ocean_sea* sea = small_sea(NULL);
    for (int first = 0; first < count; ++first) {
        const int32_t channel[4] = {available[first], -1, available[(first + 5) % count],
                                    available[(first + 7) % count]};
        for (int channels = 1; channels <= 4; ++channels) {
            float* data = interleaved(sea, channel, channels, OCEAN_ZUP);
            for (int c = 0; c < channels; ++c) {
                CHECK(holds(sea, data, channels, c, channel[c], 1.0f));
            }
        }
    }
}

void axes_turn_whole_vectors_only(void) {
    const int32_t vectors[3][3] = {{OCEAN_DX, OCEAN_DY, OCEAN_HEIGHT},
                                   {OCEAN_NX, OCEAN_NY, OCEAN_NZ},
                                   {OCEAN_VX, OCEAN_VY, OCEAN_VZ}};
    /* Almost vectors: another third component, another second, another order. */
    const int32_t parts[4][4] = {{OCEAN_NX, OCEAN_NY, OCEAN_HEIGHT, OCEAN_DY},
                                 {OCEAN_VX, -1, OCEAN_VZ, OCEAN_VY},
                                 {OCEAN_DY, OCEAN_DX, OCEAN_HEIGHT, -1},
                                 {OCEAN_DX_X, OCEAN_DY_Y, OCEAN_DX_Y, -1}}; /* no vector */
    ocean_sea* sea = small_sea(NULL);
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
            data = interleaved(sea, channel, 4, OCEAN_TNB);
            CHECK(holds(sea, data, 4, offset + 0, xyz[0], 1.0f));
            CHECK(holds(sea, data, 4, offset + 1, xyz[2], 1.0f));
            CHECK(holds(sea, data, 4, offset + 2, xyz[1], 1.0f));
            memcpy(channel, xyz, 3 * sizeof(int32_t));
            data = interleaved(sea, channel, 2, OCEAN_TNB);
            CHECK(holds(sea, data, 2, 1, xyz[1], 1.0f));
        }
    }
    for (int p = 0; p < 4; ++p) {
        data = interleaved(sea, parts[p], 4, OCEAN_YUP);
        for (int c = 0; c < 4; ++c) CHECK(holds(sea, data, 4, c, parts[p][c], 1.0f));
    }
}

void a_finer_map_passes_through_the_coarse_samples(void) {
    ocean_sea* sea = small_sea(NULL);
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
}

void rows_have_gaps_and_a_seam(void) {
    enum { kPitch = 65 * 3 + 7 };
    ocean_sea* sea = small_sea(NULL);
    float* height = planar_map(sea, kTime, 0, OCEAN_HEIGHT);
    float* normal = planar_map(sea, kTime, 0, OCEAN_NX);
    float* data = scratch(65 * kPitch * sizeof(float));
    ocean_output output = {.data = data,
                           .count = 64 * kPitch + 65 * 3,
                           .channel = {OCEAN_HEIGHT, -1, OCEAN_NX},
                           .channels = 3,
                           .row_pitch = kPitch,
                           .seam = 1};
    const ocean_request request = {.struct_size = sizeof(request),
                                   .time = kTime,
                                   .outputs = &output,
                                   .output_count = 1,
                                   .output_size = sizeof(output)};
    for (int i = 0; i < 65 * kPitch; ++i) data[i] = kUntouched;
    OK(ocean_evaluate(sea, &request));
    int same = 1;
    for (int j = 0; j < 65; ++j) {
        for (int f = 0; f < kPitch; ++f) {
            const int sample = j % 64 * 64 + f / 3 % 64;
            float expected = kUntouched;
            if (f < 65 * 3 && f % 3 == 0) expected = height[sample];
            if (f < 65 * 3 && f % 3 == 2) expected = normal[sample];
            same &= data[j * kPitch + f] == expected;
        }
    }
    CHECK(same);
}

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

void cascades_add_up_to_the_sea(void) {
    enum { kCascades = 2, kMap = 512 };
    const int32_t channels[] = {OCEAN_DX, OCEAN_HEIGHT, OCEAN_VY, OCEAN_DX_X, OCEAN_DX_Y};
    double periods[kCascades] = {0.0, 0.0};
    size_t count = 1;
    ocean_sea* sea = small_sea(NULL);
    OK(ocean_set(sea, "cascades", "2"));
    CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL, ocean_cascade_periods(sea, periods, &count));
    CHECK(count == kCascades && periods[0] == 0.0);
    OK(ocean_cascade_periods(sea, NULL, &count));
    OK(ocean_cascade_periods(sea, periods, &count));
    CHECK(periods[0] == 200.0 && periods[1] < 200.0);
    const int divisor = (int)(periods[0] / periods[1] + 0.5);
    for (size_t c = 0; c < sizeof(channels) / sizeof(channels[0]); ++c) {
        float* whole = planar_map(sea, kTime, kMap, channels[c]);
        float* parts[kCascades];
        ocean_output part = {.count = kMap * kMap, .channels = 1};
        ocean_request request = {.struct_size = sizeof(request),
                                 .time = kTime,
                                 .resolution = kMap,
                                 .outputs = &part,
                                 .output_count = 1};
        double errors = 0.0;
        double squares = 0.0;
        part.channel[0] = channels[c];
        for (int p = 0; p < kCascades; ++p) {
            parts[p] = part.data = scratch(part.count * sizeof(float));
            request.cascade = p + 1;
            OK(ocean_evaluate(sea, &request));
        }
        for (int j = 0; j < kMap; ++j) {
            for (int i = 0; i < kMap; ++i) {
                /* The place of sample i of the sea is that of sample i * divisor of its part. */
                const int within = j * divisor % kMap * kMap + i * divisor % kMap;
                const double value = whole[j * kMap + i];
                errors += pow(value - parts[0][j * kMap + i] - parts[1][within], 2.0);
                squares += value * value;
            }
        }
        CHECK(squares > 0.0 && sqrt(errors / squares) < 2e-6);
    }
    /* Where 0 is asked, the lattice of the cascade; what does not add up is refused. */
    {
        float data[kSmallCount];
        ocean_output part = {
            .data = data, .count = kSmallCount, .channel = {OCEAN_HEIGHT}, .channels = 1};
        const ocean_request request = {
            .struct_size = sizeof(request), .outputs = &part, .output_count = 1, .cascade = 2};
        const int32_t refused[] = {OCEAN_NZ, OCEAN_JACOBIAN, OCEAN_WHITECAP, OCEAN_FOAM};
        OK(ocean_evaluate(sea, &request));
        for (int i = 0; i < 4; ++i) {
            part.channel[0] = refused[i];
            BAD_VALUE(ocean_evaluate(sea, &request));
        }
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

/* A map of a windy sea in `buffer`, whose first two components are these channels. */
static ocean_sea* evaluate_foaming(int32_t first, int32_t second) {
    ocean_sea* sea = small_sea(NULL);
    const ocean_request request = good_request();
    OK(ocean_set(sea, "wind_speed", "15"));
    OK(ocean_set(sea, "foam_lifetime", "1"));
    output.channel[0] = first;
    output.channel[1] = second;
    output.channel[2] = -1;
    OK(ocean_evaluate(sea, &request));
    return sea;
}

void foam_and_whitecaps_are_channels_like_others(void) {
    float most = 0.0f;
    evaluate_foaming(OCEAN_WHITECAP, OCEAN_FOAM);
    for (size_t i = 0; i < kSmallCount; ++i) {
        const float whitecap = buffer[3 * i];
        const float foam = buffer[3 * i + 1];
        CHECK(whitecap >= 0.0f && whitecap <= foam && foam <= 1.0f);
        if (foam > most) most = foam;
    }
    CHECK(most > 0.0f);
}

void cover_is_foam_to_its_power(void) {
    ocean_sea* sea = evaluate_foaming(OCEAN_FOAM, OCEAN_COVER);
    double power = 0.0;
    float most = 0.0f;
    OK(ocean_cover_power(sea, 1.0, 0, &power));
    CHECK(power > 1.5 && power < 6.0);
    for (size_t i = 0; i < kSmallCount; ++i) {
        const double cover = pow(buffer[3 * i], power);
        CHECK(fabs(buffer[3 * i + 1] - cover) < 1e-6);
        if (buffer[3 * i + 1] > most) most = buffer[3 * i + 1];
    }
    CHECK(most > 0.1f);
    power = 77.0;
    BAD_ARGUMENT(ocean_cover_power(sea, NAN, 0, &power));
    BAD_ARGUMENT(ocean_cover_power(sea, 0.0, 100, &power));
    BAD_ARGUMENT(ocean_cover_power(sea, 0.0, 0, NULL));
    BAD_ARGUMENT(ocean_cover_power(NULL, 0.0, 0, &power));
    CHECK(power == 77.0);
}
