// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Slope tiles through the C API: counted, described, written into a host's buffers; what is
// refused.
#include <math.h>

#include "tests.h"

enum { kSamples = 256, kTexels = 256 * 256 };

static ocean_detail_request usual_request(double time) {
    const ocean_detail_request request = {.struct_size = sizeof(request),
                                          .time = time,
                                          .samples = kSamples,
                                          .band_size = sizeof(ocean_detail_band),
                                          .output_size = sizeof(ocean_output)};
    return request;
}

static ocean_output slopes_into(float* data, int32_t channels) {
    ocean_output output = {.data = data, .channels = channels};
    output.count = (size_t)kTexels * (size_t)channels;
    output.channel[0] = OCEAN_SLOPE_X;
    output.channel[1] = OCEAN_SLOPE_Y;
    output.channel[2] = -1;
    output.channel[3] = -1;
    return output;
}

void detail_has_bands_and_their_slopes(void) {
    ocean_sea* sea = small_sea(NULL);
    ocean_detail_request request = usual_request(3.0);
    size_t count = 0;
    double residual = -1.0;
    OK(ocean_detail(sea, &request, &count, &residual));
    CHECK(count == 3 && residual > 0.0);
    ocean_detail_band bands[4];
    request.bands = bands;
    request.band_count = 2;
    memset(bands, 77, sizeof(bands));
    count = 0;
    CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL, ocean_detail(sea, &request, &count, NULL));
    CHECK(count == 3 && memcmp(bands, bands + 1, sizeof(bands[0])) == 0);

    request.band_count = 4;
    float* planar = scratch(2 * kTexels * sizeof(float));
    float* rgba = scratch(4 * kTexels * sizeof(float));
    ocean_output outputs[3] = {slopes_into(planar, 2), slopes_into(planar, 2),
                               slopes_into(rgba, 4)};
    outputs[0].channel[0] = outputs[0].channel[1] = -1;
    request.outputs = outputs;
    request.output_count = 3;
    OK(ocean_detail(sea, &request, &count, NULL));
    CHECK(bands[2].shortest_wave == 0.012 && bands[1].longest_wave == bands[0].shortest_wave);
    CHECK(fabs(bands[1].tile - 8.3 * bands[1].longest_wave) < 1e-12);
    CHECK(bands[0].mean_square == 0.0 && bands[1].mean_square > 0.0);
    for (size_t i = 0; i < kTexels; ++i) CHECK(rgba[4 * i + 2] == 0.0f && rgba[4 * i + 3] == 0.0f);

    /* A frame alone, in another sea; a smaller band struct has fewer members filled. */
    ocean_sea* alone = clone_of(sea, NULL);
    float* again = scratch(2 * kTexels * sizeof(float));
    outputs[1].data = again;
    double lengths[4] = {0.0, 0.0, 0.0, 77.0};
    request.bands = (ocean_detail_band*)(void*)lengths;
    request.band_count = 3;
    request.band_size = sizeof(double);
    request.output_count = 2;
    OK(ocean_detail(alone, &request, &count, NULL));
    CHECK(memcmp(planar, again, 2 * kTexels * sizeof(float)) == 0);
    for (size_t i = 0; i < 3; ++i) CHECK(lengths[i] == bands[i].shortest_wave);
    CHECK(lengths[3] == 77.0);
}

void bad_detail_requests_are_refused_and_write_nothing(void) {
    ocean_sea* sea = small_sea(NULL);
    float* data = scratch(2 * kTexels * sizeof(float));
    ocean_output output = slopes_into(data, 2);
    ocean_detail_request request = usual_request(3.0);
    request.outputs = &output;
    request.output_count = 1;
    size_t count = 77;
    double residual = 77.0;
    const ocean_output good_output = output;
#define REFUSED(code, assignment)                                 \
    CHECK_SPOILT(ocean_detail_request, request, assignment, code, \
                 ocean_detail(sea, &request, &count, &residual)); \
    output = good_output
    REFUSED(OCEAN_INVALID_VALUE, request.samples = 300);
    CHECK_HOLDS(ocean_last_error(), "samples");
    REFUSED(OCEAN_INVALID_VALUE, request.samples = 128);
    REFUSED(OCEAN_INVALID_VALUE, request.time = NAN);
    REFUSED(OCEAN_INVALID_VALUE, output.channel[0] = OCEAN_HEIGHT);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.resolution = 100);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.struct_size = 16);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.output_size = 4);
    REFUSED(OCEAN_INVALID_ARGUMENT, output.count -= 1);
    REFUSED(OCEAN_INVALID_ARGUMENT, output.channels = 5);
    ocean_detail_band band;
    REFUSED(OCEAN_INVALID_ARGUMENT, request.bands = &band; request.band_size = 4);
    ocean_output many[4] = {output, output, output, output};
    REFUSED(OCEAN_INVALID_VALUE, request.outputs = many; request.output_count = 4);
    BAD_ARGUMENT(ocean_detail(NULL, &request, &count, &residual));
    BAD_ARGUMENT(ocean_detail(sea, NULL, &count, &residual));
    BAD_ARGUMENT(ocean_detail(sea, &request, NULL, &residual));
    CHECK(count == 77 && residual == 77.0);
    for (size_t i = 0; i < 2 * kTexels; ++i) CHECK(data[i] == 0.0f);
}
