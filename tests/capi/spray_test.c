// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spray through the C API: counted and copied without being computed twice, what is refused.
#include <math.h>
#include <stddef.h>

#include "tests.h"

static ocean_sea* open_windy_sea(const ocean_options* options) {
    ocean_sea* sea = small_sea(options);
    OK(ocean_set(sea, "wind_speed", "20"));
    return sea;
}

static ocean_spray_request usual_request(double time) {
    const ocean_spray_request request = {.struct_size = sizeof(request),
                                         .time = time,
                                         .lifetime = 2.0,
                                         .density = 0.25,
                                         .most = 1000000,
                                         .particle_size = sizeof(ocean_spray_particle)};
    return request;
}

/* All of a time. */
static ocean_spray_particle* spray_of(ocean_sea* sea, double time, size_t* count) {
    ocean_spray_request request = usual_request(time);
    OK(ocean_spray(sea, &request, count));
    ocean_spray_particle* particles = scratch((*count + 1) * sizeof(*particles));
    request.particles = particles;
    request.particle_count = *count;
    OK(ocean_spray(sea, &request, count));
    return particles;
}

static void run_jobs(void* user, ocean_job job, void* work, int32_t count) {
    ++*(int*)user;
    for (int32_t i = 0; i < count; ++i) job(work, i);
}

void spray_is_counted_then_copied(void) {
    int runs = 0;
    const ocean_options options = {
        .struct_size = sizeof(options), .threads = 2, .run_jobs = run_jobs, .jobs_user = &runs};
    ocean_sea* sea = open_windy_sea(&options);
    ocean_sea* other = open_windy_sea(NULL);
    ocean_spray_request request = usual_request(3.0);
    ocean_spray_particle few[2];
    size_t count = 0;
    size_t again = 0;
    OK(ocean_spray(sea, &request, &count));
    CHECK(count > 100 && runs > 0);
    runs = 0;
    ocean_spray_particle* particles = scratch(2 * count * sizeof(*particles));
    request.particles = few;
    request.particle_count = 2;
    memset(few, 77, sizeof(few));
    CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL, ocean_spray(sea, &request, &again));
    CHECK(again == count && few[0].id == 0x4d4d4d4d4d4d4d4dull);
    request.particles = particles;
    request.particle_count = count;
    OK(ocean_spray(sea, &request, &again));
    CHECK(again == count && runs == 0);
    ocean_spray_particle* alone = spray_of(other, 3.0, &again);
    CHECK(again == count && memcmp(alone, particles, count * sizeof(*particles)) == 0);
    /* What was counted of another sea is not taken for this one's. */
    request.particles = NULL;
    OK(ocean_spray(sea, &request, &again));
    OK(ocean_set(sea, "seed", "7"));
    request.particles = particles;
    request.particle_count = 2 * count;
    OK(ocean_spray(sea, &request, &again));
    CHECK(memcmp(alone, particles, count * sizeof(*particles)) != 0);
}

void a_smaller_particle_has_fewer_members_filled(void) {
    ocean_sea* sea = open_windy_sea(NULL);
    size_t count = 0, again = 0;
    ocean_spray_particle* whole = spray_of(sea, 3.0, &count);
    ocean_spray_request request = usual_request(3.0);
    uint64_t* ids = scratch(count * sizeof(*ids));
    request.particles = (ocean_spray_particle*)(void*)ids;
    request.particle_count = count;
    request.particle_size = sizeof(*ids);
    OK(ocean_spray(sea, &request, &again));
    CHECK(again == count && count > 100);
    for (size_t i = 0; i < count; ++i) CHECK(ids[i] == whole[i].id);
    /* A request of an older header, which ends before its region. */
    request = usual_request(3.0);
    request.struct_size = offsetof(ocean_spray_request, region);
    request.region[2] = NAN;
    OK(ocean_spray(sea, &request, &again));
    CHECK(again == count);
}

void bad_spray_requests_are_refused_and_write_nothing(void) {
    ocean_sea* sea = open_windy_sea(NULL);
    ocean_spray_particle particle;
    ocean_spray_request request = usual_request(3.0);
    size_t count = 77;
#define REFUSED(code, assignment) \
    CHECK_SPOILT(ocean_spray_request, request, assignment, code, ocean_spray(sea, &request, &count))
    REFUSED(OCEAN_INVALID_VALUE, request.lifetime = 0.0);
    CHECK_HOLDS(ocean_last_error(), "lifetime");
    REFUSED(OCEAN_INVALID_VALUE, request.lifetime = NAN);
    REFUSED(OCEAN_INVALID_VALUE, request.density = -1.0);
    REFUSED(OCEAN_INVALID_VALUE, request.most = 0);
    REFUSED(OCEAN_INVALID_VALUE, request.time = INFINITY);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.reserved = 1);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.region[2] = 40.0);
    CHECK_HOLDS(ocean_last_error(), "region[3]");
    REFUSED(OCEAN_INVALID_ARGUMENT, request.region[0] = NAN);
    REFUSED(OCEAN_UNSUPPORTED, request.region[2] = request.region[3] = 40.0);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.struct_size = 16);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.particles = &particle; request.particle_size = 4);
    BAD_ARGUMENT(ocean_spray(NULL, &request, &count));
    BAD_ARGUMENT(ocean_spray(sea, NULL, &count));
    BAD_ARGUMENT(ocean_spray(sea, &request, NULL));
    CHECK(count == 77);
}
