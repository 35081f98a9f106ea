// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Questions at world points: what lands in a host's buffers, and what is refused.
#include <math.h>
#include <stdint.h>

#include "tests.h"

enum { kUntouched = 77 };
static const double kTime = 12.0;
static const double kSpacing = 200.0 / 64.0;

/* World points at which samples of the small sea's maps are shown, and what they show: height,
 * normal, velocity. */
static double* shown_points(ocean_sea* sea, float* expected, int count) {
    const int32_t channels[9] = {OCEAN_DX, OCEAN_DY, OCEAN_HEIGHT, OCEAN_NX, OCEAN_NY,
                                 OCEAN_NZ, OCEAN_VX, OCEAN_VY,     OCEAN_VZ};
    double* xy = scratch(2 * (size_t)count * sizeof(double));
    for (int c = 0; c < 9; ++c) {
        float* map = planar_map(sea, kTime, 0, channels[c]);
        for (int p = 0; p < count; ++p) {
            const int i = (p * 37) % 64;
            const int j = (p * 11) % 64;
            const float value = map[j * 64 + i];
            if (c == 0) xy[2 * p] = i * kSpacing + value;
            if (c == 1) xy[2 * p + 1] = j * kSpacing + value - 2000.0;
            if (c > 1) expected[7 * p + c - 2] = value;
        }
    }
    return xy;
}

void queries_find_the_surface_that_the_maps_show(void) {
    enum { kPoints = 200, kStride = 12 };
    static float expected[7 * kPoints];
    static float samples[kStride * kPoints];
    ocean_sea* sea = small_sea(NULL);
    double* xy = shown_points(sea, expected, kPoints);
    double errors = 0.0;
    double squares = 0.0;
    for (int i = 0; i < kStride * kPoints; ++i) samples[i] = kUntouched;
    OK(ocean_query(sea, kTime, xy, kPoints, samples, kStride));
    for (int p = 0; p < kPoints; ++p) {
        const float* sample = samples + kStride * p;
        CHECK(sample[0] == (float)xy[2 * p] && sample[1] == (float)xy[2 * p + 1]);
        for (int c = 0; c < 7; ++c) {
            CHECK(fabs(sample[2 + c] - expected[7 * p + c]) < 0.03);
        }
        errors += pow(sample[2] - expected[7 * p], 2.0);
        squares += pow(expected[7 * p], 2.0);
        CHECK(sample[9] >= 0.0f && sample[9] <= 1.0f);
        CHECK(sample[10] == kUntouched && sample[11] == kUntouched);
    }
    CHECK(sqrt(errors / squares) < 2e-3);
    // Nine floats a point: the same without the foam.
    static float without[9 * kPoints];
    OK(ocean_query(sea, kTime, xy, kPoints, without, 9));
    for (int p = 0; p < kPoints; ++p) {
        for (int c = 0; c < 9; ++c) CHECK(without[9 * p + c] == samples[kStride * p + c]);
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

void water_moves_as_the_surface_and_less_below(void) {
    enum { kPoints = 100 };
    ocean_sea* sea = small_sea(NULL);
    double xy[2 * kPoints];
    float surface[10 * kPoints];
    float velocity[4 * kPoints];
    double sums[3] = {0.0, 0.0, 0.0};
    const double depths[3] = {1.0, 0.0, -20.0};
    for (int i = 0; i < 2 * kPoints; ++i) xy[i] = 7.3 * i;
    /* With no displacement the shown point is the label, and moves up and down as the water. */
    OK(ocean_set(sea, "choppiness", "0"));
    OK(ocean_query(sea, kTime, xy, kPoints, surface, 10));
    for (int d = 0; d < 3; ++d) {
        for (int i = 0; i < 4 * kPoints; ++i) velocity[i] = kUntouched;
        OK(ocean_orbital_velocity(sea, kTime, depths[d], xy, kPoints, velocity, 4));
        for (int p = 0; p < kPoints; ++p) {
            for (int c = 0; c < 3; ++c) sums[d] += pow(velocity[4 * p + c], 2.0);
            CHECK(velocity[4 * p + 3] == kUntouched);
            if (d < 2) CHECK(fabs(velocity[4 * p + 2] - surface[10 * p + 8]) < 1e-5);
        }
    }
    CHECK(sums[0] == sums[1]);
    CHECK(sums[2] > 0.0 && sums[2] < 0.2 * sums[1]);
}

void small_bodies_lie_as_the_surface(void) {
    const double bodies[10] = {30.0, 40.0, 90.0, 0.5, 0.2, -7.0, 1e6, 0.0, 1e4, 50.0};
    float poses[24];
    float sample[10];
    ocean_sea* sea = small_sea(NULL);
    for (int i = 0; i < 24; ++i) poses[i] = kUntouched;
    OK(ocean_float_pose(sea, kTime, bodies, 2, poses, 12));
    OK(ocean_query(sea, kTime, bodies, 1, sample, 10));
    for (int c = 0; c < 3; ++c) {
        CHECK(fabs(poses[c] - sample[c]) < 1e-6);
        CHECK(fabs(poses[3 + c] - sample[3 + c]) < 1e-6);
    }
    CHECK(fabs(poses[6]) < 1e-6 && poses[7] > 0.5f); /* the bow to the north */
    CHECK(fabs(poses[9] - asin(poses[8]) * 57.29578) < 1e-4);
    CHECK(poses[11] == kUntouched && poses[23] == kUntouched);
    CHECK(poses[12 + 5] > 0.999f); /* 10 km long: level */
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
    float rows[kPoints * 10];
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
    OK(ocean_query(sea, 4.0, xy, kPoints, rows, 10));
    OK(ocean_query_points(sea, &request));
    for (int i = 0; i < kPoints; ++i) {
        CHECK(samples[i].height == rows[10 * i + 2]);
        CHECK(memcmp(samples[i].normal, rows + 10 * i + 3, sizeof(samples[i].normal)) == 0);
        CHECK(memcmp(samples[i].velocity, rows + 10 * i + 6, sizeof(samples[i].velocity)) == 0);
        CHECK(samples[i].foam == rows[10 * i + 9]);
        CHECK((samples[i].flags & ~(OCEAN_FOLDED | OCEAN_UNDECIDED)) == 0);
        CHECK(samples[i].label[0] - xy[2 * i] < 20.0 && samples[i].label[0] - xy[2 * i] > -20.0);
    }
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

void water_is_asked_at_any_depths(void) {
    enum { kPoints = 30 };
    double xyz[3 * kPoints];
    double xy[2];
    float velocity[3];
    ocean_water_sample samples[kPoints];
    ocean_water_request request = {.struct_size = sizeof(request),
                                   .time = kTime,
                                   .xyz = xyz,
                                   .count = kPoints,
                                   .samples = samples,
                                   .sample_size = sizeof(samples[0])};
    ocean_sea* sea = small_sea(NULL);
    float most[3] = {0.0f, 0.0f, 0.0f};
    for (int i = 0; i < kPoints; ++i) {
        xyz[3 * i] = 7.1 * i;
        xyz[3 * i + 1] = -3.3 * i;
        xyz[3 * i + 2] = -5.0 * (i % 3);
    }
    OK(ocean_water_points(sea, &request));
    for (int i = 0; i < kPoints; ++i) {
        memcpy(xy, xyz + 3 * i, sizeof(xy));
        OK(ocean_orbital_velocity(sea, kTime, xyz[3 * i + 2], xy, 1, velocity, 3));
        CHECK(memcmp(velocity, samples[i].velocity, sizeof(velocity)) == 0);
        most[i % 3] = fmaxf(most[i % 3], fabsf(samples[i].pressure));
    }
    /* Of the order of rho g h, and less the deeper. */
    CHECK(most[0] > 3000.0f && most[0] < 60000.0f);
    CHECK(most[1] < most[0] && most[2] < most[1] && most[2] > 0.0f);
    request.exact = 1;
    {
        const ocean_water_sample map = samples[4];
        OK(ocean_water_points(sea, &request));
        CHECK(fabsf(map.pressure - samples[4].pressure) < 0.01f * most[1]);
    }
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

void gauges_read_what_queries_find(void) {
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
    for (int i = 0; i < kTimes; ++i) {
        for (int g = 0; g < kGauges; ++g) {
            const double* row = values + (i * kGauges + g) * kColumns;
            const double time = 10.0 + 0.5 * i;
            const double x = g == 0 ? 20.0 + 2.0 * time : 10.0 * (time - 10.0);
            const double y = g == 0 ? -30.0 : 2.0 * (time - 10.0);
            const double xyz[3] = {x, y, g == 0 ? -4.0 : 0.0};
            float sample[9];
            ocean_water_sample water;
            const ocean_water_request below = {.struct_size = sizeof(below),
                                               .time = time,
                                               .xyz = xyz,
                                               .count = 1,
                                               .samples = &water,
                                               .sample_size = sizeof(water),
                                               .exact = 1};
            CHECK(row[0] == time && fabs(row[1] - x) < 1e-9 && fabs(row[2] - y) < 1e-9);
            OK(ocean_query(sea, time, row + 1, 1, sample, 9));
            CHECK(fabs(row[3] - sample[2]) < 0.01);
            CHECK(fabs(row[4] + sample[3] / sample[5]) < 0.02);
            CHECK(fabs(row[5] + sample[4] / sample[5]) < 0.02);
            OK(ocean_water_points(sea, &below));
            for (int c = 0; c < 3; ++c) CHECK(fabs(row[6 + c] - water.velocity[c]) < 1e-5);
            CHECK(fabs(row[9] - water.pressure) < 0.01);
        }
    }
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
    const double hero = crest.height;
    float sample[9];
    OK(ocean_query(sea, crest.time, &crest.x, 1, sample, 9));
    CHECK(fabs(sample[2] - hero) < 0.02 * hero);
    OK(ocean_find_crest(sea, 0.0, 10.0, box, &crest));
    CHECK(crest.height < 0.8 * hero);
    CHECK(crest.x >= 120.0 && crest.x <= 180.0 && crest.y >= 0.0 && crest.y <= 60.0);
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

void impossible_crests_are_refused_when_a_sea_is_opened(void) {
    ocean_sea* sea = NULL;
    BAD_VALUE(open_hero("40.0", &sea));
    CHECK_HOLDS(ocean_last_error(), "crests.0.height = 40 m");
    BAD_VALUE(open_hero("1.0\n[[crests]]\ntime = 5.1\nx = 60.5\ny = 140.0\nheight = -1.0", &sea));
    CHECK_HOLDS(ocean_last_error(), "contradicts the crests near it");
    CHECK(sea == NULL);
}
