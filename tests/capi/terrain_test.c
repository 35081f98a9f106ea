// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Terrains through libocean.h: what lands in a host's buffers, and what is refused.
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "tests.h"

enum { kSide = 64, kUntouched = 77 };
static const char kLand[] =
    "libocean = 1\n[terrain]\nresolution = 64\npatch_size = 640.0\nrms = 12.0\nmean = 100.0\n";

static void free_land(void* land) {
    ocean_terrain_free(land);
}

static ocean_terrain* land_of(const char* text) {
    ocean_terrain* terrain = NULL;
    OK(ocean_terrain_parse(text, strlen(text), NULL, NULL, &terrain));
    keep(terrain, free_land);
    return terrain;
}

static ocean_result evaluate(ocean_terrain* terrain, float* data, int32_t channel) {
    ocean_output output = {.data = data, .count = kSide * kSide, .channels = 1};
    ocean_request request = {.struct_size = sizeof(ocean_request), .output_count = 1};
    output.channel[0] = channel;
    request.outputs = &output;
    request.output_size = sizeof(ocean_output);
    return ocean_terrain_evaluate(terrain, &request);
}

void terrains_fill_the_buffers_of_seas(void) {
    static float heights[kSide * kSide], clone_heights[kSide * kSide];
    ocean_terrain* terrain = land_of(kLand);
    OK(evaluate(terrain, heights, OCEAN_HEIGHT));

    ocean_terrain* clone = NULL;
    OK(ocean_terrain_clone(terrain, NULL, &clone));
    keep(clone, free_land);
    OK(ocean_terrain_set(terrain, "beta", "2.5"));
    OK(evaluate(clone, clone_heights, OCEAN_HEIGHT));
    CHECK(memcmp(heights, clone_heights, sizeof(heights)) == 0);
    OK(evaluate(terrain, clone_heights, OCEAN_HEIGHT));
    CHECK(memcmp(heights, clone_heights, sizeof(heights)) != 0);
    ocean_terrain_free(NULL);
}

void terrains_answer_about_points(void) {
    const double xy[4] = {70.0, 50.0, -640.0, 10.0};
    ocean_sample samples[2];
    double error = -1.0;
    ocean_query_request request = {.struct_size = sizeof(request),
                                   .xy = xy,
                                   .count = 2,
                                   .samples = samples,
                                   .sample_size = sizeof(ocean_sample),
                                   .exact = 1,
                                   .height_error = &error};
    OK(ocean_terrain_query_points(land_of(kLand), &request));
    for (int p = 0; p < 2; ++p) {
        CHECK(fabs(samples[p].height - 100.0) < 60.0 && samples[p].normal[2] > 0.0f);
        CHECK(samples[p].foam == 0.0f && samples[p].velocity[2] == 0.0f);
    }
    CHECK(error >= 0.0);
}

void terrains_are_described_and_written(void) {
    ocean_terrain* terrain = land_of(kLand);
    char text[4096];
    size_t size = sizeof(text);
    OK(ocean_terrain_text(terrain, text, &size));
    char other[4096];
    size = sizeof(other);
    OK(ocean_terrain_text(land_of(text), other, &size));
    CHECK(strcmp(text, other) == 0);

    char value[64];
    OK(ocean_terrain_get(terrain, "rms", value, sizeof(value)));
    CHECK(strcmp(value, "12") == 0);
    size = 0;
    OK(ocean_terrain_state_json(terrain, NULL, &size));
    CHECK(size > 100);
    size = sizeof(other);
    OK(ocean_terrain_provenance_json(terrain, "height", OCEAN_TNB, other, &size));
    CHECK(strstr(other, "\"ocean:terrain\"") != NULL && strstr(other, "\"ocean:field\"") != NULL);
    size = sizeof(other);
    OK(ocean_terrain_preset(NULL, other, &size));
    CHECK_HOLDS(other, "\"tujunga\"");
    size = sizeof(other);
    OK(ocean_terrain_preset("tujunga", other, &size));
    CHECK_HOLDS(other, "[terrain]");
    size = 0;
    OK(ocean_terrain_parameters_json(NULL, &size));
    static float noise[kSide * kSide];
    OK(ocean_terrain_stage(terrain, "noise", noise, kSide * kSide));
}

void bad_terrain_calls_are_refused_and_write_nothing(void) {
    static float heights[kSide * kSide];
    ocean_terrain* terrain = land_of(kLand);
    heights[0] = kUntouched;
    CHECK_RESULT(OCEAN_UNSUPPORTED, evaluate(terrain, heights, OCEAN_FOAM));
    BAD_ARGUMENT(evaluate(terrain, heights, 99));
    BAD_ARGUMENT(evaluate(NULL, heights, OCEAN_HEIGHT));
    CHECK(heights[0] == kUntouched);
    BAD_VALUE(ocean_terrain_set(terrain, "beta", "9"));
    CHECK(strcmp(ocean_last_error_field(OCEAN_ERROR_PARAMETER), "terrain.beta") == 0);
    BAD_VALUE(ocean_terrain_set(terrain, "wind_speed", "9"));
    const char* const names[] = {"longest_wavelength", "shortest_wavelength"};
    const char* const values[] = {"50", "60"};
    BAD_VALUE(ocean_terrain_set_all(terrain, names, values, 2));
    char value[64];
    OK(ocean_terrain_get(terrain, "longest_wavelength", value, sizeof(value)));
    CHECK(strcmp(value, "0") == 0);
    BAD_ARGUMENT(ocean_terrain_stage(terrain, "noise", heights, 5));
    BAD_ARGUMENT(ocean_terrain_stage(terrain, "smoke", heights, kSide * kSide));
    ocean_terrain* none = NULL;
    const char sea[] = "libocean = 1\n[water]\n";
    CHECK_RESULT(OCEAN_BAD_FILE, ocean_terrain_parse(sea, sizeof(sea) - 1, NULL, NULL, &none));
    CHECK_RESULT(OCEAN_BAD_FILE, ocean_terrain_open("/nonexistent.toml", NULL, &none));
    CHECK_RESULT(OCEAN_NOT_FOUND, ocean_terrain_preset("nowhere", value, &(size_t){sizeof(value)}));
    CHECK(none == NULL);
}

static ocean_mesh_request around(double x) {
    return (ocean_mesh_request){.struct_size = sizeof(ocean_mesh_request),
                                .x = x,
                                .z = 150.0,
                                .ground = 100.0,
                                .farthest = 2000.0,
                                .spacing = 4.0};
}

void a_mesh_of_land_is_counted_then_copied(void) {
    ocean_terrain* terrain = land_of(kLand);
    ocean_mesh_request request = around(0.0);
    size_t vertices = 0, triangles = 0, again = 0;
    OK(ocean_terrain_mesh(terrain, &request, &vertices, &triangles));
    CHECK(vertices > 1000 && triangles > vertices && triangles < 2 * vertices);
    double* positions = scratch(3 * vertices * sizeof(double));
    uint32_t* corners = scratch(3 * triangles * sizeof(uint32_t));
    request.positions = positions;
    request.corners = corners;
    request.vertex_capacity = vertices;
    request.triangle_capacity = triangles;
    OK(ocean_terrain_mesh(terrain, &request, &vertices, &again));
    CHECK(again == triangles);
    request.vertex_capacity = vertices - 1;
    positions[0] = kUntouched;
    CHECK_RESULT(OCEAN_BUFFER_TOO_SMALL,
                 ocean_terrain_mesh(terrain, &request, &vertices, &triangles));
    CHECK(positions[0] == kUntouched && again == triangles);

    /* A change between the calls is seen. */
    ocean_mesh_request counts = around(0.0);
    OK(ocean_terrain_mesh(terrain, &counts, &vertices, &triangles));
    OK(ocean_terrain_set(terrain, "mean", "700"));
    request.vertex_capacity = vertices;
    OK(ocean_terrain_mesh(terrain, &request, &vertices, &triangles));
    CHECK(positions[2] > 500.0);

    /* So is another place. */
    OK(ocean_terrain_mesh(terrain, &counts, &vertices, &triangles));
    ocean_mesh_request there = around(5000.0);
    size_t there_vertices = 0;
    OK(ocean_terrain_mesh(terrain, &there, &there_vertices, &triangles));
    positions = scratch(3 * there_vertices * sizeof(double));
    there.positions = positions;
    there.corners = scratch(3 * triangles * sizeof(uint32_t));
    there.vertex_capacity = there_vertices;
    there.triangle_capacity = triangles;
    OK(ocean_terrain_mesh(terrain, &there, &there_vertices, &triangles));
    for (size_t v = 0; v < there_vertices; ++v) CHECK(positions[3 * v] > 1000.0);
}

void bad_mesh_requests_are_refused_and_write_nothing(void) {
    ocean_terrain* terrain = land_of(kLand);
    size_t vertices = kUntouched, triangles = kUntouched;
    ocean_mesh_request request = around(0.0);
    double place[3];
#define REFUSED(code, assignment)                               \
    CHECK_SPOILT(ocean_mesh_request, request, assignment, code, \
                 ocean_terrain_mesh(terrain, &request, &vertices, &triangles))
    REFUSED(OCEAN_INVALID_ARGUMENT, request.positions = place);
    REFUSED(OCEAN_INVALID_VALUE, request.x = NAN);
    REFUSED(OCEAN_INVALID_VALUE, request.range = 20.0);
    REFUSED(OCEAN_INVALID_VALUE, request.spacing = -1.0);
    REFUSED(OCEAN_INVALID_VALUE, request.farthest = NAN);
    BAD_ARGUMENT(ocean_terrain_mesh(terrain, NULL, &vertices, &triangles));
    BAD_ARGUMENT(ocean_terrain_mesh(terrain, &request, NULL, &triangles));
    CHECK(vertices == kUntouched && triangles == kUntouched);
}
