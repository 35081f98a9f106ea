// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Textures of foam through the C API: threads, and what is refused.
#include <math.h>

#include "tests.h"

enum { kSize = 128, kCount = kSize * kSize };

static ocean_foam_texture_request lace_into(float* data, size_t count) {
    const ocean_foam_texture_request request = {.struct_size = sizeof(request),
                                                .kind = "lace",
                                                .size = kSize,
                                                .seed = 3,
                                                .data = data,
                                                .count = count};
    return request;
}

static void run_backwards(void* user, ocean_job job, void* work, int32_t count) {
    ++*(int*)user;
    while (count > 0) job(work, --count);
}

static int32_t end_at_once(void* user, int64_t done, int64_t total) {
    (void)user;
    (void)done;
    (void)total;
    return 1;
}

void foam_textures_have_the_same_bits_on_any_threads(void) {
    float* texture = scratch(kCount * sizeof(*texture));
    float* again = scratch(kCount * sizeof(*again));
    ocean_foam_texture_request request = lace_into(texture, kCount);
    double period = 0.0;
    OK(ocean_foam_texture(&request, NULL, &period));
    CHECK(period == 12.0);
    /* The same bits on a host's own threads; another seed has others. */
    int runs = 0;
    const ocean_options host = {
        .struct_size = sizeof(host), .threads = 3, .run_jobs = run_backwards, .jobs_user = &runs};
    request = lace_into(again, kCount);
    OK(ocean_foam_texture(&request, &host, NULL));
    CHECK(runs > 0 && memcmp(texture, again, kCount * sizeof(*texture)) == 0);
    request.seed = 4;
    OK(ocean_foam_texture(&request, NULL, NULL));
    CHECK(memcmp(texture, again, kCount * sizeof(*texture)) != 0);
    request.data = NULL; /* the period alone */
    request.count = 0;
    request.kind = "streaks";
    OK(ocean_foam_texture(&request, NULL, &period));
    CHECK(period == 97.0);
}

void bad_foam_textures_are_refused_and_write_nothing(void) {
    float* texture = scratch(kCount * sizeof(*texture));
    ocean_foam_texture_request request = lace_into(texture, kCount);
    double period = 77.0;
#define REFUSED(code, assignment)                                       \
    CHECK_SPOILT(ocean_foam_texture_request, request, assignment, code, \
                 ocean_foam_texture(&request, NULL, &period))
    REFUSED(OCEAN_INVALID_VALUE, request.kind = "bubble");
    CHECK_HOLDS(ocean_last_error(), "did you mean bubbles?");
    REFUSED(OCEAN_INVALID_VALUE, request.kind = "");
    REFUSED(OCEAN_INVALID_VALUE, request.size = 100);
    CHECK_HOLDS(ocean_last_error(), "64 .. 4096");
    REFUSED(OCEAN_INVALID_VALUE, request.size = 0);
    REFUSED(OCEAN_INVALID_VALUE, request.size = INT32_MIN);
    REFUSED(OCEAN_INVALID_VALUE, request.size = 1 << 30);
    REFUSED(OCEAN_INVALID_VALUE, request.size = 32; request.data = NULL);
    REFUSED(OCEAN_BUFFER_TOO_SMALL, request.count = kCount - 1);
    REFUSED(OCEAN_BUFFER_TOO_SMALL, request.count = 0);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.kind = NULL);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.struct_size = 8);
    BAD_ARGUMENT(ocean_foam_texture(NULL, NULL, &period));
    const ocean_options many = {.struct_size = sizeof(many), .threads = 2000};
    BAD_ARGUMENT(ocean_foam_texture(&request, &many, &period));
    const ocean_options impatient = {.struct_size = sizeof(impatient), .progress = end_at_once};
    CHECK_RESULT(OCEAN_CANCELLED, ocean_foam_texture(&request, &impatient, &period));
    CHECK(period == 77.0);
    for (int i = 0; i < kCount; ++i) CHECK(texture[i] == 0.0f);
}
