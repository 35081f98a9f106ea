// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions by which a host keeps a sea in properties of its own and labels its own files.
#include <math.h>

#include "tests.h"

static char* provenance(const ocean_sea* sea, const ocean_provenance_request* request) {
    size_t size = 0;
    char* text;
    OK(ocean_provenance_json(sea, request, NULL, &size));
    text = scratch(size + 1);
    OK(ocean_provenance_json(sea, request, text, &size));
    CHECK(strlen(text) + 1 == size);
    return text;
}

void bad_frames_have_no_time(void) {
    ocean_sea* sea = small_sea(NULL);
    double time = 77.0;
    BAD_ARGUMENT(ocean_time_of_frame(sea, NAN, &time));
    BAD_ARGUMENT(ocean_time_of_frame(sea, 1.0, NULL));
    CHECK(time == 77.0);
    OK(ocean_time_of_frame(sea, 25.0, &time));
    CHECK(time == 1.0);
}

void headers_of_slope_tiles_describe_their_band(void) {
    ocean_sea* sea = small_sea(NULL);
    const ocean_detail_band band = {0.5, 2.0, 16.25, 0.25, 0.125, -0.0625, 77.0};
    ocean_provenance_request request = {.struct_size = sizeof(request),
                                        .frame = -2,
                                        .axes = OCEAN_YUP,
                                        .field = "detail2",
                                        .residual = 0.123456789};
    char* text = provenance(sea, &request);
    CHECK_HOLDS(text,
                "\"ocean:axes\": \"zup\", \"ocean:field\": \"detail2\", \"ocean:unit\": \"1\"");
    CHECK_HOLDS(text, "\"ocean:map_resolution\": \"64\"}");
    request.band = &band;
    request.band_size = sizeof(band);
    request.resolution = 1024;
    text = provenance(sea, &request);
    CHECK_HOLDS(text,
                "\"ocean:map_resolution\": \"1024\", \"ocean:tile\": \"16.25\", "
                "\"ocean:longest_wave\": \"2\", \"ocean:shortest_wave\": \"0.5\", "
                "\"ocean:slope_variance\": \"0.25,0.125,-0.0625\", "
                "\"ocean:slope_residual\": \"0.12345679\"}");
    request.band_size = 6 * sizeof(double); /* of the first header that had bands */
    text = provenance(sea, &request);
    CHECK_HOLDS(text, "\"ocean:tile\": \"16.25\"");
}

void bad_provenance_requests_are_refused_and_write_nothing(void) {
    ocean_sea* sea = small_sea(NULL);
    const ocean_detail_band band = {0.5, 2.0, 16.25, 0.25, 0.125, -0.0625, 0.0};
    ocean_provenance_request request = {.struct_size = sizeof(request),
                                        .field = "detail1",
                                        .band = &band,
                                        .band_size = sizeof(band)};
    char out[8] = "#######";
    size_t size;
#define REFUSED(assignment)                                                             \
    size = sizeof(out);                                                                 \
    CHECK_SPOILT(ocean_provenance_request, request, assignment, OCEAN_INVALID_ARGUMENT, \
                 ocean_provenance_json(sea, &request, out, &size))
    REFUSED(request.field = "detail");
    CHECK(strcmp(ocean_last_error_field(OCEAN_ERROR_PARAMETER), "field") == 0);
    CHECK_HOLDS(ocean_last_error(), "displacement");
    REFUSED(request.time = INFINITY);
    REFUSED(request.residual = NAN);
    REFUSED(request.axes = 3);
    REFUSED(request.reserved = 1);
    REFUSED(request.resolution = -1);
    REFUSED(request.band_size = 8);
    REFUSED(request.struct_size = 8);
    BAD_ARGUMENT(ocean_provenance_json(sea, NULL, out, &size));
    BAD_ARGUMENT(ocean_provenance_json(NULL, &request, out, &size));
    CHECK(strcmp(out, "#######") == 0);
}

void values_are_written_as_a_sea_file_and_read_back(void) {
    const char* names[] = {"time.start",    "wind_speed", "waves.1.spectrum", "depth",
                           "waves.0.fetch", "file",       "[take]",           "seed"};
    const char* values[] = {
        "1e1", "12.3", "jonswap", "", "50000", "a \"b\"", "[take]\nlines = []\n", "7"};
    const size_t count = sizeof(names) / sizeof(names[0]);
    char text[512];
    size_t size = sizeof(text);
    OK(ocean_text_of_values(names, values, count, text, &size));
    CHECK(strcmp(text,
                 "libocean = 1\n\n[time]\nstart = 1e1\n\n[random]\nseed = 7\n\n[[waves]]\n"
                 "wind_speed = 12.3\nfetch = 50000\nfile = \"a \\\"b\\\"\"\n\n[[waves]]\n"
                 "spectrum = \"jonswap\"\n\n[take]\nlines = []\n") == 0);
    whole_text(ocean_values_json, small_sea(NULL));

    const char* unknown[] = {"[waves.16.measured_record]", "wind_sped", "waves.16.fetch"};
    const char* value = "1";
    for (size_t i = 0; i < 3; ++i) {
        size = sizeof(text);
        BAD_VALUE(ocean_text_of_values(unknown + i, &value, 1, text, &size));
    }
    const char* lines = "1\n[time]";
    BAD_VALUE(ocean_text_of_values(names, &lines, 1, text, &size));
    BAD_ARGUMENT(ocean_text_of_values(NULL, values, 1, text, &size));
    OK(ocean_text_of_values(NULL, NULL, 0, text, &size));
}
