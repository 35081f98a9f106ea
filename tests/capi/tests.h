// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The tests of libocean.h, in C99 as its users write it. Each TEST below is a function that opens
// with its claim; CMakeLists.txt reads this list and makes a ctest of each. The program runs those
// named on its command line, or all.
#ifndef LIBOCEAN_TESTS_H
#define LIBOCEAN_TESTS_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "libocean.h"

#define CAPI_TESTS(TEST)                                               \
    TEST(version_is_the_header_s)                                      \
    TEST(open_reads_files_and_refuses_bad_ones)                        \
    TEST(parse_takes_text_without_a_final_zero)                        \
    TEST(options_of_other_versions_are_understood)                     \
    TEST(null_is_refused_everywhere)                                   \
    TEST(set_and_get_go_through_the_table)                             \
    TEST(a_bed_is_copied_and_removed)                                  \
    TEST(a_region_over_a_bed_is_computed_and_maps_that_repeat_are_not) \
    TEST(bad_beds_are_refused_and_change_nothing)                      \
    TEST(texts_say_their_size_and_never_overrun)                       \
    TEST(bad_farm_requests_are_refused_and_write_nothing)              \
    TEST(what_is_not_found_has_no_text)                                \
    TEST(a_sea_of_contradictions_has_no_text)                          \
    TEST(bad_frames_have_no_time)                                      \
    TEST(headers_of_slope_tiles_describe_their_band)                   \
    TEST(bad_provenance_requests_are_refused_and_write_nothing)        \
    TEST(values_are_written_as_a_sea_file_and_read_back)               \
    TEST(requests_of_older_headers_are_understood)                     \
    TEST(cascades_have_periods_and_what_does_not_add_up_is_refused)    \
    TEST(bad_requests_are_refused_and_write_nothing)                   \
    TEST(bad_cover_powers_are_refused_and_write_nothing)               \
    TEST(detail_has_bands_and_their_slopes)                            \
    TEST(bad_detail_requests_are_refused_and_write_nothing)            \
    TEST(a_stride_leaves_what_lies_behind_each_row)                    \
    TEST(long_lists_of_points_are_answered_as_short_ones)              \
    TEST(bad_queries_are_refused_and_write_nothing)                    \
    TEST(points_are_described_in_full)                                 \
    TEST(bad_requests_for_water_are_refused)                           \
    TEST(bad_gauges_are_refused)                                       \
    TEST(the_highest_crest_is_found_in_time_and_place)                 \
    TEST(spray_is_counted_then_copied)                                 \
    TEST(a_smaller_particle_has_fewer_members_filled)                  \
    TEST(bad_spray_requests_are_refused_and_write_nothing)             \
    TEST(foam_textures_have_the_same_bits_on_any_threads)              \
    TEST(bad_foam_textures_are_refused_and_write_nothing)              \
    TEST(terrains_fill_the_buffers_of_seas)                            \
    TEST(terrains_answer_about_points)                                 \
    TEST(terrains_are_described_and_written)                           \
    TEST(bad_terrain_calls_are_refused_and_write_nothing)              \
    TEST(a_mesh_of_land_is_counted_then_copied)                        \
    TEST(bad_mesh_requests_are_refused_and_write_nothing)              \
    TEST(handles_in_two_threads_give_equal_bits)                       \
    TEST(a_host_runs_the_jobs_on_its_own_threads)                      \
    TEST(errors_are_kept_per_thread)                                   \
    TEST(errors_have_their_parts)                                      \
    TEST(a_second_thread_in_a_sea_is_told_and_free_waits)              \
    TEST(a_progress_function_ends_a_call_and_the_sea_goes_on)          \
    TEST(the_wake_of_each_hull_is_written_alone)                       \
    TEST(the_host_s_rounding_changes_nothing_and_stays)                \
    TEST(children_use_and_free_the_seas_of_their_parent)               \
    TEST(bad_lists_and_names_of_waves_are_refused)

#define DECLARE(name) void name(void);
CAPI_TESTS(DECLARE)
#undef DECLARE

extern int failures;

#define CHECK(condition)                                                            \
    do {                                                                            \
        if (!(condition)) {                                                         \
            fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
            ++failures;                                                             \
        }                                                                           \
    } while (0)

/* `part` is in the text. */
#define CHECK_HOLDS(text, part) check_holds((text), (part), __FILE__, __LINE__)
void check_holds(const char* text, const char* part, const char* file, int line);

/* The call returns this code; any but OCEAN_OK comes with a sentence. */
#define CHECK_RESULT(expected, call) check_result((expected), (call), #call, __FILE__, __LINE__)
#define OK(call) CHECK_RESULT(OCEAN_OK, call)
#define BAD_ARGUMENT(call) CHECK_RESULT(OCEAN_INVALID_ARGUMENT, call)
#define BAD_VALUE(call) CHECK_RESULT(OCEAN_INVALID_VALUE, call)
/* The call returns this code while the assignment holds for `request`, which it is undone of. */
#define CHECK_SPOILT(type, request, assignment, code, call) \
    do {                                                    \
        const type good_ = request;                         \
        assignment;                                         \
        CHECK_RESULT(code, call);                           \
        request = good_;                                    \
    } while (0)
void check_result(ocean_result expected, ocean_result got, const char* call, const char* file,
                  int line);

/* A small JONSWAP sea of 64 x 64 samples on 200 m. */
extern const char* const kSmallSea;
enum { kSmallResolution = 64, kSmallCount = 64 * 64 };

/* Opens it, or ends the program; to be freed by the caller. */
ocean_sea* open_small_sea(const ocean_options* options);

/* All that these return is released when the test ends. They are not for its threads. */
void keep(void* what, void (*release)(void*));
/* Zeros. */
void* scratch(size_t bytes);
/* The small sea, or the sea of a text, or a clone. */
ocean_sea* small_sea(const ocean_options* options);
ocean_sea* sea_of(const char* text);
ocean_sea* clone_of(const ocean_sea* sea, const ocean_options* options);
/* One planar map of a sea, of resolution^2 floats (0 = 64). */
float* planar_map(ocean_sea* sea, double time, int32_t resolution, int32_t channel);
/* The whole text of a function that fills `out`; `sea` is not used by all. */
typedef ocean_result (*text_function)(const ocean_sea* sea, char* out, size_t* size);
char* whole_text(text_function function, const ocean_sea* sea);

#endif
