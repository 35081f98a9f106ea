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

void check_holds(const char* text, const char* part, const char* file, int line) {
    if (strstr(text, part) != NULL) return;
    fprintf(stderr, "%s:%d: '%s' is not in: %s\n", file, line, part, text);
    ++failures;
}

static struct kept {
    struct kept* next;
    void* what;
    void (*release)(void*);
}* all_kept = NULL;

void keep(void* what, void (*release)(void*)) {
    struct kept* kept = malloc(sizeof(*kept));
    kept->next = all_kept;
    kept->what = what;
    kept->release = release;
    all_kept = kept;
}

static void release_all(void) {
    while (all_kept != NULL) {
        struct kept* kept = all_kept;
        all_kept = kept->next;
        kept->release(kept->what);
        free(kept);
    }
}

static void free_sea(void* sea) {
    ocean_free(sea);
}

void* scratch(size_t bytes) {
    void* memory = calloc(bytes, 1);
    keep(memory, free);
    return memory;
}

ocean_sea* open_small_sea(const ocean_options* options) {
    ocean_sea* sea = NULL;
    if (ocean_parse(kSmallSea, strlen(kSmallSea), NULL, options, &sea) != OCEAN_OK) {
        fprintf(stderr, "the small sea does not open: %s\n", ocean_last_error());
        exit(1);
    }
    return sea;
}

ocean_sea* small_sea(const ocean_options* options) {
    ocean_sea* sea = open_small_sea(options);
    keep(sea, free_sea);
    return sea;
}

ocean_sea* sea_of(const char* text) {
    ocean_sea* sea = NULL;
    OK(ocean_parse(text, strlen(text), NULL, NULL, &sea));
    keep(sea, free_sea);
    return sea;
}

ocean_sea* clone_of(const ocean_sea* sea, const ocean_options* options) {
    ocean_sea* clone = NULL;
    OK(ocean_clone(sea, options, &clone));
    keep(clone, free_sea);
    return clone;
}

char* whole_text(text_function function, const ocean_sea* sea) {
    size_t size = 0;
    char* text;
    OK(function(sea, NULL, &size));
    text = scratch(size + 1);
    OK(function(sea, text, &size));
    CHECK(strlen(text) + 1 == size);
    return text;
}

float* planar_map(ocean_sea* sea, double time, int32_t resolution, int32_t channel) {
    const size_t side = resolution > 0 ? (size_t)resolution : kSmallResolution;
    ocean_output output = {.channels = 1};
    ocean_request request = {.struct_size = sizeof(ocean_request), .output_count = 1};
    output.count = side * side;
    output.data = scratch(output.count * sizeof(float));
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
        release_all();
        printf("%s %s\n", failures == before ? "passed" : "FAILED", tests[i].name);
        ++ran;
    }
    if (ran == 0) fprintf(stderr, "no test of that name\n");
    return failures > 0 || ran == 0;
}
