// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Questions at world points: what lands in a host's buffers, and what is refused.
#include <math.h>
#include <stdint.h>

#include "tests.h"

enum { kUntouched = 77 };
static const double kTime = 12.0;

void a_stride_leaves_what_lies_behind_each_row(void) {
    enum { kPoints = 200, kStride = 12 };
    static float samples[kStride * kPoints], without[9 * kPoints], velocity[4 * kPoints];
    static double xy[2 * kPoints], bodies[5 * kPoints];
    float poses[kStride * kPoints];
    ocean_sea* sea = small_sea(NULL);
    for (int i = 0; i < kStride * kPoints; ++i) samples[i] = poses[i] = kUntouched;
    for (int i = 0; i < 4 * kPoints; ++i) velocity[i] = kUntouched;
    for (int p = 0; p < kPoints; ++p) {
        const double body[5] = {7.3 * p, -2.1 * p, 90.0, 0.5, 0.2};
        memcpy(bodies + 5 * p, body, sizeof(body));
        memcpy(xy + 2 * p, body, 2 * sizeof(double));
    }
    OK(ocean_query(sea, kTime, xy, kPoints, samples, kStride));
    OK(ocean_query(sea, kTime, xy, kPoints, without, 9)); /* the same without the foam */
    OK(ocean_orbital_velocity(sea, kTime, 0.0, xy, kPoints, velocity, 4));
    OK(ocean_float_pose(sea, kTime, bodies, kPoints, poses, kStride));
    for (int p = 0; p < kPoints; ++p) {
        const float *sample = samples + kStride * p, *pose = poses + kStride * p;
        CHECK(memcmp(without + 9 * p, sample, 9 * sizeof(float)) == 0);
        CHECK(sample[0] == (float)xy[2 * p] && sample[1] == (float)xy[2 * p + 1]);
        CHECK(sample[9] >= 0.0f && sample[9] <= 1.0f);
        CHECK(sample[10] == kUntouched && sample[11] == kUntouched);
        CHECK(velocity[4 * p + 2] != kUntouched && velocity[4 * p + 3] == kUntouched);
        CHECK(pose[10] != kUntouched && pose[11] == kUntouched);
    }
}

void long_lists_of_points_are_answered_as_short_ones(void) {
    enum { kPoints = 40000 };
    ocean_sea* sea = small_sea(NULL);
    double* xy = scratch(2 * kPoints * sizeof(double));
    float* samples = scratch(10 * kPoints * sizeof(float));
    float one[10];
    for (int p = 0; p < kPoints; ++p) {
        xy[2 * p] = 0.37 * p;
        xy[2 * p + 1] = -0.11 * p;
    }
    OK(ocean_query(sea, kTime, xy, kPoints, samples, 10));
    for (int p = 0; p < kPoints; p += 1237) {
        OK(ocean_query(sea, kTime, xy + 2 * p, 1, one, 10));
        CHECK(memcmp(one, samples + 10 * p, sizeof(one)) == 0);
    }
}

void bad_queries_are_refused_and_write_nothing(void) {
    double xy[4] = {1.0, 2.0, 3.0, 4.0};
    double body[5] = {1.0, 2.0, 0.0, 4.0, 2.0};
    float out[24];
    ocean_sea* sea = small_sea(NULL);
    for (int i = 0; i < 24; ++i) out[i] = kUntouched;
    OK(ocean_query(sea, kTime, NULL, 0, NULL, 10));
    OK(ocean_orbital_velocity(sea, kTime, 0.0, NULL, 0, NULL, 3));
    OK(ocean_float_pose(sea, kTime, NULL, 0, NULL, 11));

    BAD_ARGUMENT(ocean_query(NULL, kTime, xy, 2, out, 10));
    BAD_ARGUMENT(ocean_query(sea, NAN, xy, 2, out, 10));
    BAD_ARGUMENT(ocean_query(sea, kTime, NULL, 2, out, 10));
    BAD_ARGUMENT(ocean_query(sea, kTime, xy, 2, NULL, 10));
    BAD_ARGUMENT(ocean_query(sea, kTime, xy, 2, out, 8));
    CHECK_HOLDS(ocean_last_error(), "stride = 8; allowed: 9");
    BAD_ARGUMENT(ocean_query(sea, kTime, xy, SIZE_MAX / 8, out, 10));
    BAD_ARGUMENT(ocean_query(sea, kTime, xy, 2, out, SIZE_MAX / 2));
    xy[3] = INFINITY;
    BAD_ARGUMENT(ocean_query(sea, kTime, xy, 2, out, 10));
    CHECK_HOLDS(ocean_last_error(), "y of point 1 = inf");
    BAD_ARGUMENT(ocean_orbital_velocity(sea, kTime, 0.0, xy, 2, out, 3));
    BAD_ARGUMENT(ocean_orbital_velocity(sea, kTime, NAN, xy, 1, out, 3));
    BAD_ARGUMENT(ocean_orbital_velocity(sea, kTime, 0.0, xy, 1, out, 2));
    BAD_ARGUMENT(ocean_orbital_velocity(NULL, kTime, 0.0, xy, 1, out, 3));
    BAD_ARGUMENT(ocean_float_pose(NULL, kTime, body, 1, out, 11));
    BAD_ARGUMENT(ocean_float_pose(sea, kTime, body, 1, out, 10));
    body[4] = -2.0;
    BAD_ARGUMENT(ocean_float_pose(sea, kTime, body, 1, out, 11));
    CHECK_HOLDS(ocean_last_error(), "body 0: width = -2");
    for (int i = 0; i < 24; ++i) CHECK(out[i] == kUntouched);
}

void points_are_described_in_full(void) {
    enum { kPoints = 50 };
    struct newer_sample {
        ocean_sample known;
        int32_t unknown[2];
    } newer[2];
    double xy[2 * kPoints];
    ocean_sample samples[kPoints];
    float heights[kPoints];
    double error = -1.0;
    ocean_query_request request;
    ocean_sea* sea = small_sea(NULL);
    for (int i = 0; i < 2 * kPoints; ++i) xy[i] = 3.7 * i - 50.0;
    memset(&request, 0, sizeof(request));
    request.struct_size = sizeof(request);
    request.time = 4.0;
    request.xy = xy;
    request.count = kPoints;
    request.samples = samples;
    request.sample_size = sizeof(samples[0]);
    request.foam = 1;
    request.height_error = &error;
    OK(ocean_query_points(sea, &request));
    CHECK(error > 0.0 && error < 0.01);
    /* A program of an older header, whose samples are heights, and one of a newer. */
    request.samples = (ocean_sample*)(void*)heights;
    request.sample_size = sizeof(float);
    OK(ocean_query_points(sea, &request));
    for (int i = 0; i < kPoints; ++i) CHECK(heights[i] == samples[i].height);
    memset(newer, 0x55, sizeof(newer));
    request.samples = &newer[0].known;
    request.sample_size = sizeof(newer[0]);
    request.count = 2;
    OK(ocean_query_points(sea, &request));
    CHECK(newer[1].known.height == samples[1].height && newer[1].unknown[1] == 0x55555555);
    /* Coarser, for less. */
    request.resolution = 32;
    OK(ocean_query_points(sea, &request));
    CHECK(error > 0.02);
    request.resolution = 33;
    BAD_VALUE(ocean_query_points(sea, &request));
    request.resolution = 0;
    request.refine = 3;
    BAD_VALUE(ocean_query_points(sea, &request));
    request.refine = 0;
    request.sample_size = 2;
    BAD_ARGUMENT(ocean_query_points(sea, &request));
    request.sample_size = sizeof(ocean_sample);
    request.time = 1e39;
    BAD_VALUE(ocean_query_points(sea, &request));
    request.time = 1.0;
    request.xy = NULL;
    BAD_ARGUMENT(ocean_query_points(sea, &request));
    request.count = 0;
    OK(ocean_query_points(sea, &request));
    BAD_ARGUMENT(ocean_query_points(sea, NULL));
    BAD_ARGUMENT(ocean_query_points(NULL, &request));
}

void bad_requests_for_water_are_refused(void) {
    double xyz[6] = {7.1, -3.3, -5.0, 14.2, -6.6, 0.0};
    ocean_water_sample samples[2];
    ocean_water_request request = {.struct_size = sizeof(request),
                                   .time = kTime,
                                   .xyz = xyz,
                                   .count = 2,
                                   .samples = samples,
                                   .sample_size = sizeof(samples[0])};
    ocean_sea* sea = small_sea(NULL);
    OK(ocean_water_points(sea, &request));
    CHECK(fabsf(samples[1].pressure) > 10.0f);
    xyz[5] = NAN;
    BAD_ARGUMENT(ocean_water_points(sea, &request));
    CHECK_HOLDS(ocean_last_error(), "z of point 1 = ");
    request.xyz = NULL;
    BAD_ARGUMENT(ocean_water_points(sea, &request));
    request.count = 0;
    OK(ocean_water_points(sea, &request));
    request.sample_size = 2;
    BAD_ARGUMENT(ocean_water_points(sea, &request));
    BAD_ARGUMENT(ocean_water_points(NULL, &request));
    BAD_ARGUMENT(ocean_water_points(sea, NULL));
}

void bad_gauges_are_refused(void) {
    enum { kTimes = 5, kGauges = 2, kColumns = 10 };
    const double fixed[4] = {0.0, 20.0, -30.0, -4.0};
    const double tow[8] = {10.0, 0.0, 0.0, 0.0, 14.0, 40.0, 8.0, 0.0};
    ocean_gauge gauges[kGauges] = {{.fixes = fixed, .fix_count = 1, .velocity = {2.0, 0.0}},
                                   {.fixes = tow, .fix_count = 2}};
    double values[kTimes * kGauges * kColumns];
    size_t times = 0;
    ocean_gauge_request request = {.struct_size = sizeof(request),
                                   .start = 10.0,
                                   .end = 12.0,
                                   .rate = 2.0,
                                   .gauges = gauges,
                                   .gauge_count = kGauges,
                                   .gauge_size = sizeof(gauges[0])};
    ocean_sea* sea = small_sea(NULL);
    OK(ocean_gauges(sea, &request, &times));
    CHECK(times == kTimes);
    request.values = values;
    request.value_count = kTimes * kGauges * kColumns - 1;
    CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL, ocean_gauges(sea, &request, &times));
    request.value_count = kTimes * kGauges * kColumns;
    OK(ocean_gauges(sea, &request, &times));
    CHECK(values[0] == 10.0 && values[(kTimes * kGauges - 1) * kColumns] == 12.0);
#define REFUSED(assignment)                                                        \
    CHECK_SPOILT(ocean_gauge_request, request, assignment, OCEAN_INVALID_ARGUMENT, \
                 ocean_gauges(sea, &request, &times))
    REFUSED(request.rate = 0.0);
    REFUSED(request.rate = NAN);
    REFUSED(request.rate = INFINITY);
    REFUSED(request.end = 9.0);
    REFUSED(request.gauges = NULL);
    REFUSED(request.gauge_size = 4);
    REFUSED(request.struct_size = 16);
    REFUSED(gauges[1].fix_count = 0);
    gauges[1].fix_count = 2;
    REFUSED(gauges[0].velocity[1] = NAN);
    gauges[0].velocity[1] = 0.0;
    REFUSED(gauges[1].fixes = tow + 4; gauges[1].fix_count = 1; gauges[0].fixes = NULL);
}

/* The small sea with a crest at 5 s and (60, 140) m, `height` as a sea file has it. */
static ocean_result open_hero(const char* height, ocean_sea** sea) {
    char text[1024];
    const int length = snprintf(text, sizeof(text),
                                "%s\n[[crests]]\ntime = 5.0\nx = 60.0\ny = 140.0\nheight = %s\n",
                                kSmallSea, height);
    return ocean_parse(text, (size_t)length, NULL, NULL, sea);
}

void the_highest_crest_is_found_in_time_and_place(void) {
    const double box[4] = {120.0, 0.0, 180.0, 60.0};
    const double empty_box[4] = {50.0, 50.0, 50.0, 60.0};
    const double endless_box[4] = {0.0, 0.0, HUGE_VAL, 60.0};
    ocean_crest crest = {.struct_size = sizeof(crest)};
    ocean_sea* sea = NULL;
    OK(open_hero("\"1.2 Hs\"", &sea));
    OK(ocean_find_crest(sea, 0.0, 10.0, NULL, &crest));
    CHECK(fabs(crest.time - 5.0) < 0.5);
    CHECK(hypot(crest.x - 60.0, crest.y - 140.0) < 8.0);
    OK(ocean_find_crest(sea, 0.0, 10.0, box, &crest));
    CHECK(crest.x >= 120.0 && crest.y <= 60.0);
    const double height = crest.height;
    BAD_VALUE(ocean_find_crest(sea, 5.0, 4.0, NULL, &crest));
    BAD_VALUE(ocean_find_crest(sea, 0.0, 1e8, NULL, &crest));
    BAD_VALUE(ocean_find_crest(sea, 0.0, 1.0, empty_box, &crest));
    BAD_ARGUMENT(ocean_find_crest(sea, 0.0, 1.0, endless_box, &crest));
    BAD_VALUE(ocean_find_crest(sea, HUGE_VAL, HUGE_VAL, NULL, &crest));
    BAD_ARGUMENT(ocean_find_crest(sea, 0.0, 1.0, NULL, NULL));
    BAD_ARGUMENT(ocean_find_crest(NULL, 0.0, 1.0, NULL, &crest));
    crest.struct_size = 8;
    BAD_ARGUMENT(ocean_find_crest(sea, 0.0, 1.0, NULL, &crest));
    CHECK(crest.height == height);
    ocean_free(sea);
}
