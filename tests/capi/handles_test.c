// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Opening, describing and changing a sea through libocean.h.
#include "tests.h"

/* LIBOCEAN_TEST_DATA: the folder tests/data, as an absolute path or relative to where this runs. */
static const char kBuoy[] = LIBOCEAN_TEST_DATA "/spectra/ndbc_41010.data_spec";

void version_is_the_header_s(void) {
    CHECK(ocean_abi_version() == OCEAN_ABI_VERSION);
    CHECK(strcmp(ocean_version(), LIBOCEAN_TEST_VERSION) == 0);
    CHECK(strcmp(ocean_last_error(), "") == 0 || failures > 0);
}

void open_reads_files_and_refuses_bad_ones(void) {
    static const char path[] = "capi_test_sea.toml";
    ocean_sea* sea = NULL;
    FILE* file = fopen(path, "wb");
    CHECK(file != NULL);
    if (file == NULL) return;
    fputs(kSmallSea, file);
    fclose(file);
    OK(ocean_open(path, NULL, &sea));
    remove(path);
    ocean_free(sea);

    sea = NULL;
    CHECK_RESULT(OCEAN_BAD_FILE, ocean_open("no such file.toml", NULL, &sea));
    CHECK_HOLDS(ocean_last_error(), "no such file.toml");
    CHECK(sea == NULL);
}

void parse_takes_text_without_a_final_zero(void) {
    static const char wrong[] = "libocean = 1\n[grid]\nresolution = 100\n";
    ocean_sea* sea = NULL;
    char* text = scratch(strlen(kSmallSea));
    memcpy(text, kSmallSea, strlen(kSmallSea));
    OK(ocean_parse(text, strlen(kSmallSea), NULL, NULL, &sea));
    ocean_free(sea);

    sea = NULL;
    BAD_VALUE(ocean_parse(wrong, strlen(wrong), NULL, NULL, &sea));
    CHECK_HOLDS(ocean_last_error(), ":3:");
    CHECK_HOLDS(ocean_last_error(), "100");
    CHECK(sea == NULL);
    ocean_free(NULL);
}

/* What a host compiled against a newer header might pass. */
struct newer_options {
    ocean_options known;
    int32_t unknown[4];
};

static ocean_result parse_with(const ocean_options* options) {
    ocean_sea* sea = NULL;
    const ocean_result result = ocean_parse(kSmallSea, strlen(kSmallSea), NULL, options, &sea);
    CHECK((sea != NULL) == (result == OCEAN_OK));
    ocean_free(sea);
    return result;
}

void options_of_other_versions_are_understood(void) {
    const size_t refused[] = {0, 1, 4, 10, 4100, (size_t)-1};
    ocean_options options = {
        .struct_size = sizeof(ocean_options), .threads = 2, .backend = OCEAN_RADIX2};
    struct newer_options newer;
    OK(parse_with(&options));
    for (size_t i = 0; i < sizeof(refused) / sizeof(refused[0]); ++i) {
        options.struct_size = refused[i];
        BAD_ARGUMENT(parse_with(&options));
        CHECK_HOLDS(ocean_last_error(), "struct_size");
    }
    /* An older one without backend: what stands there is not read. */
    options.struct_size = offsetof(ocean_options, backend);
    options.backend = 1000;
    OK(parse_with(&options));

    memset(&newer, 0, sizeof(newer));
    newer.known.struct_size = sizeof(newer);
    OK(parse_with(&newer.known));
    newer.unknown[3] = 1;
    CHECK_RESULT(OCEAN_UNSUPPORTED, parse_with(&newer.known));

    options.struct_size = sizeof(options);
    BAD_ARGUMENT(parse_with(&options));
    options.backend = OCEAN_GL;
    CHECK_RESULT(OCEAN_UNSUPPORTED, parse_with(&options));
    options.backend = OCEAN_CPU;
    options.threads = -1;
    BAD_ARGUMENT(parse_with(&options));
    options.threads = 1025;
    BAD_ARGUMENT(parse_with(&options));
}

void null_is_refused_everywhere(void) {
    ocean_sea* sea = small_sea(NULL);
    ocean_sea* other = NULL;
    ocean_request request = {.struct_size = sizeof(ocean_request), .output_count = 1};
    char text[64];
    size_t size = sizeof(text);
    BAD_ARGUMENT(ocean_clone(NULL, NULL, &other));
    BAD_ARGUMENT(ocean_open(NULL, NULL, &other));
    BAD_ARGUMENT(ocean_open("x", NULL, NULL));
    BAD_ARGUMENT(ocean_parse(NULL, 0, NULL, NULL, &other));
    BAD_ARGUMENT(ocean_parse("", 0, NULL, NULL, NULL));
    BAD_ARGUMENT(ocean_set(NULL, "fps", "24"));
    BAD_ARGUMENT(ocean_set(sea, NULL, "24"));
    BAD_ARGUMENT(ocean_set(sea, "fps", NULL));
    BAD_ARGUMENT(ocean_get(NULL, "fps", text, size));
    BAD_ARGUMENT(ocean_get(sea, NULL, text, size));
    BAD_ARGUMENT(ocean_get(sea, "fps", NULL, size));
    BAD_ARGUMENT(ocean_text(NULL, text, &size));
    BAD_ARGUMENT(ocean_text(sea, text, NULL));
    BAD_ARGUMENT(ocean_parameters_json(text, NULL));
    BAD_ARGUMENT(ocean_state_json(NULL, text, &size));
    BAD_ARGUMENT(ocean_state_json(sea, text, NULL));
    BAD_ARGUMENT(ocean_records_json(NULL, text, &size));
    BAD_ARGUMENT(ocean_records_json(kBuoy, text, NULL));
    BAD_ARGUMENT(ocean_preset(NULL, text, NULL));
    BAD_ARGUMENT(ocean_evaluate(NULL, &request));
    BAD_ARGUMENT(ocean_evaluate(sea, NULL));
    BAD_ARGUMENT(ocean_evaluate(sea, &request));
    BAD_ARGUMENT(ocean_query(NULL, 0.0, NULL, 0, NULL, 0));
    CHECK(size == sizeof(text));
    CHECK(other == NULL);
}

static int has_value(const ocean_sea* sea, const char* name, const char* value) {
    char text[64] = "before";
    OK(ocean_get(sea, name, text, sizeof(text)));
    return strcmp(text, value) == 0;
}

void set_and_get_go_through_the_table(void) {
    ocean_sea* sea = small_sea(NULL);
    char text[32];
    OK(ocean_set(sea, "wind_speed", "17.5"));
    CHECK(has_value(sea, "waves.0.wind_speed", "17.5"));
    CHECK(has_value(sea, "peak_period", ""));

    BAD_VALUE(ocean_set(sea, "wind_speed", "-3"));
    BAD_VALUE(ocean_set(sea, "wind_sped", "3"));
    CHECK_HOLDS(ocean_last_error(), "wind_speed");
    BAD_VALUE(ocean_set(sea, "cascades", "6"));
    BAD_VALUE(ocean_get(sea, "nothing", text, sizeof(text)));
    CHECK(has_value(sea, "wind_speed", "17.5"));

    strcpy(text, "before");
    CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL, ocean_get(sea, "wind_speed", text, 4));
    CHECK(strcmp(text, "before") == 0);
    OK(ocean_get(sea, "wind_speed", text, 5));
}

static int has_parts(const char* what, const char* parameter, const char* value,
                     const char* allowed) {
    return strcmp(ocean_last_error_field(OCEAN_ERROR_WHAT), what) == 0 &&
           strcmp(ocean_last_error_field(OCEAN_ERROR_PARAMETER), parameter) == 0 &&
           strcmp(ocean_last_error_field(OCEAN_ERROR_VALUE), value) == 0 &&
           strcmp(ocean_last_error_field(OCEAN_ERROR_ALLOWED), allowed) == 0;
}

/* A host marks the field that is wrong, and takes no sentence apart. */
void errors_have_their_parts(void) {
    const ocean_options options = {.struct_size = sizeof(ocean_options), .threads = 2000};
    char text[4];
    char* name = scratch(5001);
    ocean_sea* sea = small_sea(NULL);
    BAD_VALUE(ocean_set(sea, "fetch", "5"));
    CHECK(has_parts("is out of range", "waves.0.fetch", "5", "1000 .. 10000000 m"));
    CHECK(strcmp(ocean_last_error(),
                 "waves.0.fetch = 5: is out of range; allowed: 1000 .. 10000000 m") == 0);
    /* A success leaves them alone, and so does whoever reads them. */
    OK(ocean_set(sea, "fetch", "5000"));
    CHECK(strcmp(ocean_last_error_field(OCEAN_ERROR_PARAMETER), "waves.0.fetch") == 0);
    CHECK(strcmp(ocean_last_error_field(-1), "") == 0);
    CHECK(strcmp(ocean_last_error_field(OCEAN_ERROR_ALLOWED + 1), "") == 0);

    BAD_ARGUMENT(ocean_clone(sea, &options, &(ocean_sea*){NULL}));
    CHECK(has_parts("", "threads", "2000", "0 (the cores this process may use) .. 1024"));
    /* Nothing of the failure before stays in one that has no such part. */
    CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL, ocean_get(sea, "spectrum", text, sizeof(text)));
    CHECK(has_parts(ocean_last_error(), "", "", ""));
    /* As long as they may be, and never half a character. */
    name[0] = 'x';
    for (int i = 1; i < 4999; i += 2) memcpy(name + i, "\xc3\xa4", 2);
    name[4999] = '\0';
    BAD_VALUE(ocean_set(sea, "take", name));
    CHECK(strlen(ocean_last_error_field(OCEAN_ERROR_VALUE)) < 2048);
}

void bad_lists_and_names_of_waves_are_refused(void) {
    const char* const limits[] = {"shortest_wavelength", "longest_wavelength"};
    const char* const metres[] = {"50", "100"};
    ocean_sea* sea = small_sea(NULL);
    OK(ocean_set_all(sea, limits, metres, 2));
    OK(ocean_set_all(sea, NULL, NULL, 0));
    BAD_ARGUMENT(ocean_set_all(sea, limits, NULL, 2));
    BAD_ARGUMENT(ocean_set_all(NULL, limits, metres, 2));
    BAD_VALUE(ocean_add_waves(sea, "waves.2"));
    BAD_VALUE(ocean_add_waves(sea, "swell"));
    BAD_VALUE(ocean_add_waves(sea, "waves.-1"));
    BAD_VALUE(ocean_remove_waves(sea, "waves.0"));
    BAD_VALUE(ocean_remove_waves(sea, "waves.1"));
    for (int i = 1; i < 16; ++i) OK(ocean_add_waves(sea, "waves.1"));
    BAD_VALUE(ocean_add_waves(sea, "waves.1"));
    OK(ocean_perform(sea, 10.0, "waves.1.wind_direction", "80"));
    BAD_VALUE(ocean_perform(sea, 9.0, "wind_speed", "8"));
    BAD_VALUE(ocean_perform(sea, 20.0, "grid.resolution", "128"));
}
