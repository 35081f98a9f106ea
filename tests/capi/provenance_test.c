// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions by which a host keeps a sea in properties of its own and labels its own files.
#include <math.h>

#include "tests.h"

static char* provenance(const ocean_sea* sea, const ocean_provenance_request* request) {
    size_t size = 0;
    char* text;
    CHECK_RESULT(OCEAN_OK, ocean_provenance_json(sea, request, NULL, &size));
    text = calloc(size + 1, 1);
    CHECK_RESULT(OCEAN_OK, ocean_provenance_json(sea, request, text, &size));
    CHECK(strlen(text) + 1 == size);
    return text;
}

static void check_holds(const char* text, const char* part) {
    if (strstr(text, part) != NULL) return;
    fprintf(stderr, "%s\nis not in\n%s\n", part, text);
    ++failures;
}

void a_frame_has_the_time_of_the_sea_file(void) {
    ocean_sea* sea = open_small_sea(NULL);
    double time = 77.0;
    CHECK_RESULT(OCEAN_OK, ocean_set(sea, "start", "100000"));
    CHECK_RESULT(OCEAN_OK, ocean_set(sea, "fps", "25"));
    CHECK_RESULT(OCEAN_OK, ocean_set(sea, "first_frame", "5"));
    CHECK_RESULT(OCEAN_OK, ocean_time_of_frame(sea, 7.5, &time));
    CHECK(time == 100000.0 + 2.5 / 25.0);
    CHECK_RESULT(OCEAN_INVALID_ARGUMENT, ocean_time_of_frame(sea, NAN, &time));
    CHECK_RESULT(OCEAN_INVALID_ARGUMENT, ocean_time_of_frame(sea, 1.0, NULL));
    CHECK(time == 100000.0 + 2.5 / 25.0);
    ocean_free(sea);
}

void headers_say_where_a_file_comes_from(void) {
    ocean_sea* sea = open_small_sea(NULL);
    ocean_provenance_request request = {
        .struct_size = sizeof(request), .time = 0.5, .frame = 13, .axes = OCEAN_TNB};
    char* text = provenance(sea, &request);
    check_holds(text, "{\"ocean:sea\": \"# A sea, for libocean.");
    check_holds(text, "\\u000Awind_speed = 12.0");
    check_holds(text, "\"ocean:frame\": \"13\", \"ocean:time\": \"0.5\"");
    check_holds(text, "\"ocean:period\": \"200\", \"ocean:backend\": \"cpu\"");
    check_holds(text, "\"ocean:version\": \"" LIBOCEAN_TEST_VERSION "\"}");
    free(text);
    request.field = "velocity";
    text = provenance(sea, &request);
    check_holds(text, "\"ocean:axes\": \"tnb\"");
    check_holds(text, "\"ocean:field\": \"velocity\", \"ocean:unit\": \"m/s\"");
    free(text);
    request.field = "cover"; /* the same in all axes */
    text = provenance(sea, &request);
    check_holds(text, "\"ocean:axes\": \"zup\", \"ocean:field\": \"cover\", \"ocean:unit\": \"1\"");
    free(text);
    ocean_free(sea);
}

void headers_of_slope_tiles_describe_their_band(void) {
    ocean_sea* sea = open_small_sea(NULL);
    const ocean_detail_band band = {0.5, 2.0, 16.25, 0.25, 0.125, -0.0625, 77.0};
    ocean_provenance_request request = {.struct_size = sizeof(request),
                                        .frame = -2,
                                        .axes = OCEAN_YUP,
                                        .field = "detail2",
                                        .residual = 0.123456789};
    char* text = provenance(sea, &request);
    check_holds(text,
                "\"ocean:axes\": \"zup\", \"ocean:field\": \"detail2\", \"ocean:unit\": \"1\"");
    check_holds(text, "\"ocean:map_resolution\": \"64\"}");
    free(text);
    request.band = &band;
    request.band_size = sizeof(band);
    request.resolution = 1024;
    text = provenance(sea, &request);
    check_holds(text,
                "\"ocean:map_resolution\": \"1024\", \"ocean:tile\": \"16.25\", "
                "\"ocean:longest_wave\": \"2\", \"ocean:shortest_wave\": \"0.5\", "
                "\"ocean:slope_variance\": \"0.25,0.125,-0.0625\", "
                "\"ocean:slope_residual\": \"0.12345679\"}");
    free(text);
    request.band_size = 6 * sizeof(double); /* of the first header that had bands */
    text = provenance(sea, &request);
    check_holds(text, "\"ocean:tile\": \"16.25\"");
    free(text);
    ocean_free(sea);
}

void bad_provenance_requests_are_refused_and_write_nothing(void) {
    ocean_sea* sea = open_small_sea(NULL);
    const ocean_detail_band band = {0.5, 2.0, 16.25, 0.25, 0.125, -0.0625, 0.0};
    ocean_provenance_request request = {.struct_size = sizeof(request),
                                        .field = "detail1",
                                        .band = &band,
                                        .band_size = sizeof(band)};
    char out[8] = "#######";
    size_t size;
#define REFUSED(code, assignment)                                             \
    do {                                                                      \
        const ocean_provenance_request good = request;                        \
        assignment;                                                           \
        size = sizeof(out);                                                   \
        CHECK_RESULT(code, ocean_provenance_json(sea, &request, out, &size)); \
        request = good;                                                       \
    } while (0)
    REFUSED(OCEAN_INVALID_ARGUMENT, request.field = "detail");
    CHECK(strcmp(ocean_last_error_field(OCEAN_ERROR_PARAMETER), "field") == 0);
    CHECK(strstr(ocean_last_error(), "displacement") != NULL);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.time = INFINITY);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.residual = NAN);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.axes = 3);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.reserved = 1);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.resolution = -1);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.band_size = 8);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.struct_size = 8);
    CHECK_RESULT(OCEAN_INVALID_ARGUMENT, ocean_provenance_json(sea, NULL, out, &size));
    CHECK_RESULT(OCEAN_INVALID_ARGUMENT, ocean_provenance_json(NULL, &request, out, &size));
    CHECK(strcmp(out, "#######") == 0);
    ocean_free(sea);
}

void values_are_written_as_a_sea_file_and_read_back(void) {
    const char* names[] = {"time.start",    "wind_speed", "waves.1.spectrum", "depth",
                           "waves.0.fetch", "file",       "[take]",           "seed"};
    const char* values[] = {
        "1e1", "12.3", "jonswap", "", "50000", "a \"b\"", "[take]\nlines = []\n", "7"};
    const size_t count = sizeof(names) / sizeof(names[0]);
    char text[512];
    size_t size = sizeof(text);
    CHECK_RESULT(OCEAN_OK, ocean_text_of_values(names, values, count, text, &size));
    CHECK(strcmp(text,
                 "libocean = 1\n\n[time]\nstart = 1e1\n\n[random]\nseed = 7\n\n[[waves]]\n"
                 "wind_speed = 12.3\nfetch = 50000\nfile = \"a \\\"b\\\"\"\n\n[[waves]]\n"
                 "spectrum = \"jonswap\"\n\n[take]\nlines = []\n") == 0);
    ocean_sea* sea = open_small_sea(NULL);
    CHECK_RESULT(OCEAN_OK, ocean_values_json(sea, NULL, &size));
    char* json = calloc(size, 1);
    CHECK_RESULT(OCEAN_OK, ocean_values_json(sea, json, &size));
    check_holds(json, "\"grid.resolution\": \"64\"");
    check_holds(json, "\"waves.0.wind_speed\": ");
    free(json);
    ocean_free(sea);

    const char* unknown[] = {"[waves.16.measured_record]", "wind_sped", "waves.16.fetch"};
    const char* value = "1";
    for (size_t i = 0; i < 3; ++i) {
        size = sizeof(text);
        CHECK_RESULT(OCEAN_INVALID_VALUE,
                     ocean_text_of_values(unknown + i, &value, 1, text, &size));
    }
    const char* lines = "1\n[time]";
    CHECK_RESULT(OCEAN_INVALID_VALUE, ocean_text_of_values(names, &lines, 1, text, &size));
    CHECK_RESULT(OCEAN_INVALID_ARGUMENT, ocean_text_of_values(NULL, values, 1, text, &size));
    CHECK_RESULT(OCEAN_OK, ocean_text_of_values(NULL, NULL, 0, text, &size));
}
