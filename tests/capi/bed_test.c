// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// ocean_set_bed: a host's heights as the bed of a sea.
#include <math.h>

#include "tests.h"

enum { kColumns = 9, kRows = 4 };

static void make_beach(float* heights) {
    for (int i = 0; i < kColumns * kRows; ++i) heights[i] = (float)(i % kColumns) - 4.5f;
}

void a_bed_is_copied_and_removed(void) {
    float heights[kColumns * kRows];
    ocean_sea* sea = small_sea(NULL);
    char* open_sea = whole_text(ocean_text, sea);
    char* with_bed;
    make_beach(heights);
    OK(ocean_set_bed(sea, heights, kColumns, kRows, -20.0, 30.0, 5.0));
    with_bed = whole_text(ocean_text, sea);
    for (int i = 0; i < kColumns * kRows; ++i) heights[i] = 99.0f;
    CHECK(strcmp(whole_text(ocean_text, sea), with_bed) == 0);
    CHECK(strcmp(open_sea, with_bed) != 0);
    OK(ocean_set(sea, "seabed_origin", "[]"));
    OK(ocean_set_bed(sea, NULL, 0, 0, 0.0, 0.0, 0.0));
    CHECK(strcmp(whole_text(ocean_text, sea), open_sea) == 0);
}

void bad_beds_are_refused_and_change_nothing(void) {
    float heights[kColumns * kRows];
    ocean_sea* sea = small_sea(NULL);
    char* before = whole_text(ocean_text, sea);
    make_beach(heights);
    BAD_ARGUMENT(ocean_set_bed(NULL, heights, kColumns, kRows, 0, 0, 1));
    BAD_ARGUMENT(ocean_set_bed(sea, NULL, kColumns, kRows, 0, 0, 1));
    BAD_ARGUMENT(ocean_set_bed(sea, heights, 0, 0, 0, 0, 1));
    BAD_ARGUMENT(ocean_set_bed(sea, heights, 1, kRows, 0, 0, 1));
    BAD_ARGUMENT(ocean_set_bed(sea, heights, kColumns, 8193, 0, 0, 1));
    BAD_ARGUMENT(ocean_set_bed(sea, heights, kColumns, kRows, HUGE_VAL, 0, 1));
    BAD_ARGUMENT(ocean_set_bed(sea, heights, kColumns, kRows, 0, 0, HUGE_VAL));
    BAD_VALUE(ocean_set_bed(sea, heights, kColumns, kRows, 0, 0, 0));
    BAD_VALUE(ocean_set_bed(sea, heights, kColumns, kRows, 0, 0, -1));
    BAD_VALUE(ocean_set_bed(sea, heights, kColumns, kRows, 1e8, 0, 1));
    heights[5] = -HUGE_VALF;
    BAD_VALUE(ocean_set_bed(sea, heights, kColumns, kRows, 0, 0, 1));
    CHECK_HOLDS(ocean_last_error(), "column 5, row 0");
    CHECK(strcmp(before, whole_text(ocean_text, sea)) == 0);
}

void a_region_over_a_bed_is_computed_and_maps_that_repeat_are_not(void) {
    enum { kSide = 5 };
    float heights[kColumns * kRows];
    float values[2 * kSide * kSide] = {0};
    float bed[kSide * kSide];
    ocean_output output = {.data = values,
                           .count = 2 * kSide * kSide,
                           .channel = {OCEAN_HEIGHT, OCEAN_DEPTH},
                           .channels = 2};
    ocean_region_request region = {.struct_size = sizeof(region),
                                   .cell = 4.0,
                                   .columns = kSide,
                                   .rows = kSide,
                                   .outputs = &output,
                                   .output_count = 1,
                                   .output_size = sizeof(output)};
    ocean_output map = output;
    ocean_request request = {.struct_size = sizeof(request),
                             .outputs = &map,
                             .output_count = 1,
                             .output_size = sizeof(map),
                             .resolution = 32};
    ocean_sea* sea = small_sea(NULL);
    CHECK_RESULT(OCEAN_UNSUPPORTED, ocean_region(sea, 0.0, &region));
    CHECK_RESULT(OCEAN_UNSUPPORTED, ocean_bed_region(sea, 0, 0, 1, kSide, kSide, bed));
    make_beach(heights);
    OK(ocean_set_bed(sea, heights, kColumns, kRows, 0.0, 0.0, 5.0));
    OK(ocean_region(sea, 1.0, &region));
    /* The bed rises to the east: 4.5 m of water at its western end, less all along. */
    CHECK(values[1] > values[2 * (kSide - 1) + 1]);
    BAD_ARGUMENT(ocean_region(sea, HUGE_VAL, &region));
    OK(ocean_bed_region(sea, -5.0, 0.0, 2.5, kSide, kSide, bed));
    /* West of the bed its border goes on; between samples it is linear. */
    CHECK(bed[0] == -4.5f && bed[1] == -4.5f && bed[2] == -4.5f);
    CHECK(bed[3] == -4.0f && bed[kSide + 4] == -3.5f);
    BAD_ARGUMENT(ocean_bed_region(NULL, 0, 0, 1, kSide, kSide, bed));
    BAD_ARGUMENT(ocean_bed_region(sea, 0, 0, 1, kSide, kSide, NULL));
    BAD_ARGUMENT(ocean_bed_region(sea, 0, 0, 1, 1, kSide, bed));
    BAD_ARGUMENT(ocean_bed_region(sea, 0, 0, 1, kSide, 32769, bed));
    BAD_ARGUMENT(ocean_bed_region(sea, 0, 0, 0, kSide, kSide, bed));
    BAD_ARGUMENT(ocean_bed_region(sea, HUGE_VAL, 0, 1, kSide, kSide, bed));
    region.columns = 1;
    BAD_ARGUMENT(ocean_region(sea, 1.0, &region));
    map.channels = 1;
    map.data = scratch(32 * 32 * sizeof(float));
    map.count = 32 * 32;
    CHECK_RESULT(OCEAN_UNSUPPORTED, ocean_evaluate(sea, &request));
}
