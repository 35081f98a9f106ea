// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Text results of libocean.h: their sizes, and what they hold.
#include "tests.h"

static const char kBuoy[] = LIBOCEAN_TEST_DATA "/spectra/ndbc_41010.data_spec";

static ocean_result parameters(const ocean_sea* sea, char* out, size_t* size) {
    (void)sea;
    return ocean_parameters_json(out, size);
}
static ocean_result records(const ocean_sea* sea, char* out, size_t* size) {
    (void)sea;
    return ocean_records_json(kBuoy, out, size);
}
static ocean_result preset(const ocean_sea* sea, char* out, size_t* size) {
    (void)sea;
    return ocean_preset("beaufort_6", out, size);
}
static ocean_result preset_names(const ocean_sea* sea, char* out, size_t* size) {
    (void)sea;
    return ocean_preset(NULL, out, size);
}

static ocean_result water_types(const ocean_sea* sea, char* out, size_t* size) {
    (void)sea;
    return ocean_water_types_json(out, size);
}

static const int32_t kFrames[] = {3, 1, 2};
static ocean_farm_request farm_request(void) {
    const ocean_farm_request request = {.struct_size = sizeof(request),
                                        .engine = "slurm",
                                        .output = "out/sea.####.exr",
                                        .frames = kFrames,
                                        .frame_count = 3};
    return request;
}
static ocean_result farm_job(const ocean_sea* sea, char* out, size_t* size) {
    const ocean_farm_request request = farm_request();
    return ocean_farm_job_json(sea, &request, out, size);
}

void bad_farm_requests_are_refused_and_write_nothing(void) {
    ocean_sea* sea = small_sea(NULL);
    ocean_farm_request request = farm_request();
    char out[8] = "#######";
    size_t size;
#define REFUSED(code, assignment)                               \
    size = sizeof(out);                                         \
    CHECK_SPOILT(ocean_farm_request, request, assignment, code, \
                 ocean_farm_job_json(sea, &request, out, &size))
    REFUSED(OCEAN_INVALID_VALUE, request.engine = "slum");
    CHECK_HOLDS(ocean_last_error(), "did you mean slurm");
    REFUSED(OCEAN_INVALID_VALUE, request.frame_count = 0);
    REFUSED(OCEAN_INVALID_VALUE, request.render = "scene.obj");
    REFUSED(OCEAN_INVALID_ARGUMENT, request.engine = NULL);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.output = NULL);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.frames = NULL);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.option_count = 1);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.minutes = -1);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.reserved = 1);
    REFUSED(OCEAN_INVALID_ARGUMENT, request.struct_size = 8);
#undef REFUSED
    BAD_ARGUMENT(ocean_farm_job_json(sea, NULL, out, &size));
    BAD_ARGUMENT(ocean_farm_job_json(NULL, &request, out, &size));
    CHECK(strcmp(out, "#######") == 0);
}

void texts_say_their_size_and_never_overrun(void) {
    const text_function functions[] = {ocean_text, ocean_state_json, parameters,  records,
                                       preset,     preset_names,     water_types, farm_job};
    ocean_sea* sea = small_sea(NULL);
    for (size_t i = 0; i < sizeof(functions) / sizeof(functions[0]); ++i) {
        size_t needed = 12345;
        size_t size;
        char* text;
        OK(functions[i](sea, NULL, &needed));
        CHECK(needed > 10 && needed != 12345);
        text = scratch(needed + 1);
        memset(text, '#', needed + 1);
        size = needed - 1;
        CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL, functions[i](sea, text, &size));
        CHECK(size == needed && text[0] == '#' && text[needed - 1] == '#');
        size = 0;
        CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL, functions[i](sea, text, &size));
        CHECK(size == needed && text[0] == '#');
        OK(functions[i](sea, text, &size));
        CHECK(size == needed && text[needed - 1] == '\0' && text[needed] == '#');
        CHECK(strlen(text) == needed - 1);
    }
}

/* The text would not open; the sentence is that of whoever asks the sea for anything else. */
static void check_contradiction(ocean_sea* sea, const char* sentence) {
    char text[32];
    size_t size = sizeof(text);
    BAD_VALUE(ocean_text(sea, NULL, &size));
    CHECK_HOLDS(ocean_last_error(), sentence);
    BAD_VALUE(ocean_state_json(sea, text, &size));
    CHECK_HOLDS(ocean_last_error(), sentence);
}

void a_sea_of_contradictions_has_no_text(void) {
    ocean_sea* sea = small_sea(NULL);
    OK(ocean_set(sea, "shortest_wavelength", "5"));
    OK(ocean_set(sea, "longest_wavelength", "4"));
    check_contradiction(sea, "surface.longest_wavelength = 4 m: must be more than");
    OK(ocean_set(sea, "longest_wavelength", "6"));
    OK(ocean_set(sea, "spectrum", "measured"));
    check_contradiction(sea, "needs waves.0.file");
    OK(ocean_set(sea, "spectrum", "jonswap"));
    BAD_VALUE(ocean_set(sea, "file", "a\nb"));
    CHECK_HOLDS(whole_text(ocean_text, sea), "longest_wavelength = 6");
}

void what_is_not_found_has_no_text(void) {
    size_t size = 0;
    CHECK_RESULT(OCEAN_NOT_FOUND, ocean_preset("beaufort_13", NULL, &size));
    CHECK_RESULT(OCEAN_BAD_FILE, ocean_records_json("no such buoy", NULL, &size));
}
