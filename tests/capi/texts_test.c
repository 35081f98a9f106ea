// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Text results of libocean.h: their sizes, and what they hold.
#include "tests.h"

static const char kBuoy[] = LIBOCEAN_TEST_DATA "/spectra/ndbc_41010.data_spec";

/* One way to ask for each text; `sea` is not used by all. */
typedef ocean_result (*text_function)(const ocean_sea* sea, char* out, size_t* size);

static ocean_result sea_text(const ocean_sea* sea, char* out, size_t* size) {
    return ocean_text(sea, out, size);
}
static ocean_result state(const ocean_sea* sea, char* out, size_t* size) {
    return ocean_state_json(sea, out, size);
}
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

/* The whole text, to be freed by the caller. */
static char* whole_text(text_function function, const ocean_sea* sea) {
    size_t size = 0;
    char* text;
    CHECK_RESULT(OCEAN_OK, function(sea, NULL, &size));
    text = calloc(size + 1, 1);
    CHECK_RESULT(OCEAN_OK, function(sea, text, &size));
    CHECK(strlen(text) + 1 == size);
    return text;
}

void texts_say_their_size_and_never_overrun(void) {
    const text_function functions[] = {sea_text, state,        parameters, records,
                                       preset,   preset_names, water_types};
    ocean_sea* sea = open_small_sea(NULL);
    for (size_t i = 0; i < sizeof(functions) / sizeof(functions[0]); ++i) {
        size_t needed = 12345;
        size_t size;
        char* text;
        CHECK_RESULT(OCEAN_OK, functions[i](sea, NULL, &needed));
        CHECK(needed > 10 && needed != 12345);
        text = malloc(needed + 1);
        memset(text, '#', needed + 1);
        size = needed - 1;
        CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL, functions[i](sea, text, &size));
        CHECK(size == needed && text[0] == '#' && text[needed - 1] == '#');
        size = 0;
        CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL, functions[i](sea, text, &size));
        CHECK(size == needed && text[0] == '#');
        CHECK_RESULT(OCEAN_OK, functions[i](sea, text, &size));
        CHECK(size == needed && text[needed - 1] == '\0' && text[needed] == '#');
        CHECK(strlen(text) == needed - 1);
        free(text);
    }
    ocean_free(sea);
}

void resolved_text_gives_the_same_sea(void) {
    ocean_sea* sea = open_small_sea(NULL);
    ocean_sea* again = NULL;
    char* text;
    char* text_again;
    float* map;
    float* map_again;
    CHECK_RESULT(OCEAN_OK, ocean_set(sea, "wind_speed", "9.123456789012345"));
    text = whole_text(sea_text, sea);
    CHECK_RESULT(OCEAN_OK, ocean_parse(text, strlen(text), NULL, NULL, &again));
    if (again != NULL) {
        text_again = whole_text(sea_text, again);
        CHECK(strcmp(text, text_again) == 0);
        map = planar_map(sea, 12.0, 0, OCEAN_HEIGHT);
        map_again = planar_map(again, 12.0, 0, OCEAN_HEIGHT);
        CHECK(memcmp(map, map_again, kSmallCount * sizeof(float)) == 0);
        free(map);
        free(map_again);
        free(text_again);
    }
    free(text);
    ocean_free(again);
    ocean_free(sea);
}

/* The text would not open; the sentence is that of whoever asks the sea for anything else. */
static void check_contradiction(ocean_sea* sea, const char* sentence) {
    char text[32];
    size_t size = sizeof(text);
    CHECK_RESULT(OCEAN_INVALID_VALUE, ocean_text(sea, NULL, &size));
    CHECK(strstr(ocean_last_error(), sentence) != NULL);
    CHECK_RESULT(OCEAN_INVALID_VALUE, ocean_state_json(sea, text, &size));
    CHECK(strstr(ocean_last_error(), sentence) != NULL);
}

void a_sea_of_contradictions_has_no_text(void) {
    ocean_sea* sea = open_small_sea(NULL);
    char* text;
    CHECK_RESULT(OCEAN_OK, ocean_set(sea, "shortest_wavelength", "5"));
    CHECK_RESULT(OCEAN_OK, ocean_set(sea, "longest_wavelength", "4"));
    check_contradiction(sea, "surface.longest_wavelength = 4 m: must be more than");
    CHECK_RESULT(OCEAN_OK, ocean_set(sea, "longest_wavelength", "6"));
    CHECK_RESULT(OCEAN_OK, ocean_set(sea, "spectrum", "measured"));
    check_contradiction(sea, "needs waves.0.file");
    CHECK_RESULT(OCEAN_OK, ocean_set(sea, "spectrum", "jonswap"));
    CHECK_RESULT(OCEAN_INVALID_VALUE, ocean_set(sea, "file", "a\nb"));
    text = whole_text(sea_text, sea);
    CHECK(strstr(text, "longest_wavelength = 6") != NULL);
    free(text);
    ocean_free(sea);
}

void presets_open(void) {
    char* names = whole_text(preset_names, NULL);
    char* text = whole_text(preset, NULL);
    size_t size = 0;
    ocean_sea* sea = NULL;
    CHECK(names[0] == '[' && names[strlen(names) - 1] == ']');
    CHECK(strstr(names, "\"beaufort_12\"") != NULL);
    CHECK(strstr(names, "\"seed_thesis\"") != NULL);
    CHECK_RESULT(OCEAN_OK, ocean_parse(text, strlen(text), NULL, NULL, &sea));
    CHECK_RESULT(OCEAN_NOT_FOUND, ocean_preset("beaufort_13", NULL, &size));
    ocean_free(sea);
    free(text);
    free(names);
}

void records_of_a_buoy_are_listed(void) {
    char* json = whole_text(records, NULL);
    size_t size = 0;
    CHECK(json[0] == '[');
    CHECK(strstr(json, "\"significant_wave_height\"") != NULL);
    CHECK_RESULT(OCEAN_BAD_FILE, ocean_records_json("no such buoy", NULL, &size));
    free(json);
}

void water_types_are_listed(void) {
    char* json = whole_text(water_types, NULL);
    CHECK(json[0] == '[');
    CHECK(strstr(json, "\"jerlov_i\"") != NULL && strstr(json, "\"jerlov_9c\"") != NULL);
    CHECK(strstr(json, "\"absorption\": [0.277, 0.0724, 0.0572]") != NULL);
    free(json);
}
