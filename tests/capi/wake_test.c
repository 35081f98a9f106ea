// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// ocean_wake_...: the waves of one hull alone.
#include <math.h>

#include "tests.h"

void the_wake_of_each_hull_is_written_alone(void) {
    enum { kSide = 24 };
    static float values[2 * kSide * kSide];
    size_t count = 9;
    float highest = 0.0f;
    ocean_domain domain = {.struct_size = sizeof(domain)};
    ocean_output output = {.data = values,
                           .count = 2 * kSide * kSide,
                           .channel = {OCEAN_HEIGHT, OCEAN_VZ},
                           .channels = 2};
    ocean_region_request region = {.struct_size = sizeof(region),
                                   .x = -20.0,
                                   .y = -10.0,
                                   .cell = 1.0,
                                   .columns = kSide,
                                   .rows = kSide,
                                   .outputs = &output,
                                   .output_count = 1,
                                   .output_size = sizeof(output)};
    ocean_sea* sea = small_sea(NULL);
    OK(ocean_wake_count(sea, &count));
    CHECK(count == 0);
    BAD_VALUE(ocean_wake_domain(sea, 0, 0.0, &domain));
    BAD_VALUE(ocean_wake_region(sea, 0, 0.0, &region));
    sea = sea_of(
        "libocean = 1\n[[hulls]]\nlength = 10.0\nbeam = 3.0\nwake_resolution = 64\n"
        "track = [[-60.0, -240.0, 0.0], [60.0, 240.0, 0.0]]\n");
    OK(ocean_wake_count(sea, &count));
    CHECK(count == 1);
    OK(ocean_wake_domain(sea, 0, 2.0, &domain));
    CHECK(domain.columns == 64 && domain.rows == 64 && domain.wraps == 0);
    CHECK(domain.x < 8.0 && domain.x + 64 * domain.cell > 8.0);
    OK(ocean_wake_region(sea, 0, 2.0, &region));
    for (int i = 0; i < kSide * kSide; ++i) highest = fmaxf(highest, values[2 * i]);
    CHECK(highest > 0.01f && highest < 2.0f);
    const float once = values[2 * 100];
    OK(ocean_wake_add(sea, 0, 2.0, &region));
    CHECK(fabsf(values[2 * 100] - 2.0f * once) <= 1e-6f * fabsf(once));
    BAD_ARGUMENT(ocean_wake_count(NULL, &count));
    BAD_ARGUMENT(ocean_wake_count(sea, NULL));
    BAD_ARGUMENT(ocean_wake_domain(sea, 0, 0.0, NULL));
    BAD_ARGUMENT(ocean_wake_domain(sea, 0, HUGE_VAL, &domain));
    BAD_VALUE(ocean_wake_domain(sea, 1, 0.0, &domain));
    BAD_ARGUMENT(ocean_wake_region(sea, 0, 0.0, NULL));
    BAD_ARGUMENT(ocean_wake_region(sea, 0, HUGE_VAL, &region));
    BAD_VALUE(ocean_wake_region(sea, 1, 0.0, &region));
    BAD_ARGUMENT(ocean_wake_add(sea, 0, 0.0, NULL));
    BAD_ARGUMENT(ocean_wake_add(sea, 0, HUGE_VAL, &region));
    BAD_VALUE(ocean_wake_add(sea, 1, 0.0, &region));
    output.channel[1] = OCEAN_NX;
    CHECK_RESULT(OCEAN_UNSUPPORTED, ocean_wake_add(sea, 0, 0.0, &region));
    output.channel[1] = OCEAN_FOAM;
    CHECK_RESULT(OCEAN_UNSUPPORTED, ocean_wake_region(sea, 0, 0.0, &region));
    CHECK_RESULT(OCEAN_UNSUPPORTED, ocean_wake_add(sea, 0, 0.0, &region));
}
