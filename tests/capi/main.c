// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs the tests of tests.h, and what they share.
#include "tests.h"

int failures = 0;

const char* const kSmallSea =
    "libocean = 1\n"
    "[grid]\n"
    "resolution = 64\n"
    "patch_size = 200.0\n"
    "[[waves]]\n"
    "spectrum = \"jonswap\"\n"
    "wind_speed = 12.0\n"
    "wind_direction = 30.0\n";

void check_result(ocean_result expected, ocean_result got, const char* call, const char* file,
                  int line) {
    if (got != expected) {
        fprintf(stderr, "%s:%d: %s returned %d, not %d: %s\n", file, line, call, (int)got,
                (int)expected, ocean_last_error());
        ++failures;
    } else if (expected != OCEAN_OK && strlen(ocean_last_error()) < 10) {
        fprintf(stderr, "%s:%d: %s failed without a sentence\n", file, line, call);
        ++failures;
    }
}

ocean_sea* open_small_sea(const ocean_options* options) {
    ocean_sea* sea = NULL;
    if (ocean_parse(kSmallSea, strlen(kSmallSea), NULL, options, &sea) != OCEAN_OK) {
        fprintf(stderr, "the small sea does not open: %s\n", ocean_last_error());
        exit(1);
    }
    return sea;
}

float* planar_map(ocean_sea* sea, double time, int32_t resolution, int32_t channel) {
    const size_t side = resolution > 0 ? (size_t)resolution : kSmallResolution;
    ocean_output output = {.channels = 1};
    ocean_request request = {.struct_size = sizeof(ocean_request), .output_count = 1};
    output.count = side * side;
    output.data = calloc(output.count, sizeof(float));
    output.channel[0] = channel;
    request.time = time;
    request.resolution = resolution;
    request.outputs = &output;
    CHECK_RESULT(OCEAN_OK, ocean_evaluate(sea, &request));
    return output.data;
}

struct test {
    const char* name;
    void (*run)(void);
};
#define ENTRY(name) {#name, name},
static const struct test tests[] = {CAPI_TESTS(ENTRY)};

int main(int argc, char** argv) {
    const size_t count = sizeof(tests) / sizeof(tests[0]);
    int ran = 0;
    for (size_t i = 0; i < count; ++i) {
        int asked = argc < 2;
        for (int a = 1; a < argc; ++a) asked |= strcmp(argv[a], tests[i].name) == 0;
        if (!asked) continue;
        const int before = failures;
        tests[i].run();
        printf("%s %s\n", failures == before ? "passed" : "FAILED", tests[i].name);
        ++ran;
    }
    if (ran == 0) fprintf(stderr, "no test of that name\n");
    return failures > 0 || ran == 0;
}
