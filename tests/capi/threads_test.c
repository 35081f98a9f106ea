// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Several handles at once, and what each thread keeps for itself.
#if !defined(_WIN32)
#define _POSIX_C_SOURCE 200809L
#endif
#include <fenv.h>

#include "tests.h"

#if defined(_WIN32)
#include <windows.h>
typedef HANDLE thread_handle;
typedef LPTHREAD_START_ROUTINE thread_body;
#define THREAD_BODY(name, argument) static DWORD WINAPI name(LPVOID argument)
static void start(thread_handle* thread, thread_body body, void* argument) {
    *thread = CreateThread(NULL, 0, body, argument, 0, NULL);
}
static void join(thread_handle thread) {
    WaitForSingleObject(thread, INFINITE);
    CloseHandle(thread);
}
#else
#include <pthread.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
typedef pthread_t thread_handle;
typedef void* (*thread_body)(void*);
#define THREAD_BODY(name, argument) static void* name(void* argument)
static void start(thread_handle* thread, thread_body body, void* argument) {
    if (pthread_create(thread, NULL, body, argument) != 0) exit(1);
}
static void join(thread_handle thread) {
    pthread_join(thread, NULL);
}
#endif

enum { kFrames = 8, kChannels = 4 };

/* One handle's work: a few frames, in an order of its own. */
struct job {
    int32_t threads;
    int backwards;
    ocean_result result;
    float* frames;
};

THREAD_BODY(evaluate_frames, argument) {
    struct job* job = argument;
    ocean_options options = {.struct_size = sizeof(ocean_options)};
    ocean_sea* sea = NULL;
    options.threads = job->threads;
    job->result = ocean_parse(kSmallSea, strlen(kSmallSea), NULL, &options, &sea);
    for (int step = 0; step < kFrames && job->result == OCEAN_OK; ++step) {
        const int frame = job->backwards ? kFrames - 1 - step : step;
        ocean_output output = {.count = kSmallCount * kChannels,
                               .channel = {OCEAN_DX, OCEAN_HEIGHT, OCEAN_NX, OCEAN_VZ},
                               .channels = 4};
        ocean_request request = {.struct_size = sizeof(ocean_request), .output_count = 1};
        output.data = job->frames + (size_t)frame * kSmallCount * kChannels;
        request.time = 0.5 * frame;
        request.outputs = &output;
        job->result = ocean_evaluate(sea, &request);
    }
    ocean_free(sea);
    return 0;
}

void handles_in_two_threads_give_equal_bits(void) {
    const size_t bytes = (size_t)kFrames * kSmallCount * kChannels * sizeof(float);
    struct job jobs[2] = {{1, 0, OCEAN_INTERNAL, NULL}, {3, 1, OCEAN_INTERNAL, NULL}};
    thread_handle threads[2];
    for (int i = 0; i < 2; ++i) {
        jobs[i].frames = calloc(bytes, 1);
        start(&threads[i], evaluate_frames, &jobs[i]);
    }
    for (int i = 0; i < 2; ++i) join(threads[i]);
    CHECK(jobs[0].result == OCEAN_OK && jobs[1].result == OCEAN_OK);
    CHECK(memcmp(jobs[0].frames, jobs[1].frames, bytes) == 0);
    /* Each of them the frame of its time, not one for all. */
    CHECK(memcmp(jobs[0].frames, jobs[0].frames + kSmallCount * kChannels,
                 kSmallCount * kChannels * sizeof(float)) != 0);
    for (int i = 0; i < 2; ++i) free(jobs[i].frames);
}

struct error_job {
    int clean_before;
    int own_after;
};
THREAD_BODY(fail_here, argument) {
    struct error_job* job = argument;
    size_t size = 0;
    job->clean_before = strcmp(ocean_last_error(), "") == 0 &&
                        strcmp(ocean_last_error_field(OCEAN_ERROR_WHAT), "") == 0 &&
                        strcmp(ocean_last_error_field(OCEAN_ERROR_PARAMETER), "") == 0 &&
                        strcmp(ocean_last_error_field(OCEAN_ERROR_VALUE), "") == 0 &&
                        strcmp(ocean_last_error_field(OCEAN_ERROR_ALLOWED), "") == 0;
    ocean_preset("typhoon", NULL, &size);
    job->own_after = strstr(ocean_last_error(), "typhoon") != NULL;
    return 0;
}

/* A host that runs jobs each on a thread of its own, backwards, or leaves them all to the library.
 */
struct jobs_host {
    int lazy;
    int calls;
    int32_t most;
};
struct one_job {
    ocean_job job;
    void* work;
    int32_t index;
};
THREAD_BODY(run_one_job, argument) {
    const struct one_job* one = argument;
    one->job(one->work, one->index);
    return 0;
}
static void run_jobs(void* user, ocean_job job, void* work, int32_t count) {
    struct jobs_host* host = user;
    thread_handle threads[8];
    struct one_job jobs[8];
    ++host->calls;
    if (count > host->most) host->most = count;
    if (host->lazy || count > 8) return;
    for (int32_t i = count - 1; i >= 0; --i) {
        jobs[i].job = job;
        jobs[i].work = work;
        jobs[i].index = i;
        start(&threads[i], run_one_job, &jobs[i]);
    }
    for (int32_t i = 0; i < count; ++i) join(threads[i]);
}

void a_host_runs_the_jobs_on_its_own_threads(void) {
    float* expected = planar_map(small_sea(NULL), 3.0, 0, OCEAN_HEIGHT);
    for (int lazy = 0; lazy < 2; ++lazy) {
        struct jobs_host host = {lazy, 0, 0};
        const ocean_options options = {
            .struct_size = sizeof(options), .threads = 3, .run_jobs = run_jobs, .jobs_user = &host};
        ocean_sea* sea = small_sea(&options);
        float* map = planar_map(sea, 3.0, 0, OCEAN_HEIGHT);
        const int calls = host.calls;
        CHECK(memcmp(map, expected, kSmallCount * sizeof(float)) == 0);
        CHECK(calls > 0 && host.most == 3);
        map = planar_map(clone_of(sea, NULL), 3.0, 0, OCEAN_HEIGHT);
        CHECK(memcmp(map, expected, kSmallCount * sizeof(float)) == 0);
        CHECK(host.calls > calls);
    }
}

void errors_are_kept_per_thread(void) {
    struct error_job job = {0, 0};
    thread_handle thread;
    size_t size = 0;
    CHECK_RESULT(OCEAN_NOT_FOUND, ocean_preset("breeze", NULL, &size));
    start(&thread, fail_here, &job);
    join(thread);
    CHECK(job.clean_before && job.own_after);
    CHECK_HOLDS(ocean_last_error(), "breeze");
    /* A success leaves it alone. */
    OK(ocean_preset(NULL, NULL, &size));
    CHECK_HOLDS(ocean_last_error(), "breeze");
}

/* What a progress function is told, and what it does. */
struct host {
    int inside; /* a call is under way */
    int go_on;  /* it may end */
    int answer; /* what the function returns */
    int told;   /* how often foam was reported */
    int freed;
    ocean_result result;
    ocean_sea* sea;
};

static int is_set(const int* flag) {
    return __atomic_load_n(flag, __ATOMIC_ACQUIRE);
}
static void set(int* flag) {
    __atomic_store_n(flag, 1, __ATOMIC_RELEASE);
}

static int32_t wait_inside(void* user, int64_t done, int64_t total) {
    struct host* host = user;
    if (total > 0 && done <= total) ++host->told;
    set(&host->inside);
    while (!is_set(&host->go_on)) {
    }
    return host->answer;
}

static ocean_options watched_by(struct host* host) {
    ocean_options options = {.struct_size = sizeof(ocean_options), .threads = 1};
    options.progress = wait_inside;
    options.user = host;
    return options;
}

static ocean_result evaluate_foam(ocean_sea* sea, double time, float* foam) {
    ocean_output output = {.count = kSmallCount, .channel = {OCEAN_FOAM}, .channels = 1};
    ocean_request request = {.struct_size = sizeof(ocean_request), .output_count = 1};
    output.data = foam;
    request.time = time;
    request.outputs = &output;
    return ocean_evaluate(sea, &request);
}

THREAD_BODY(follow_foam, argument) {
    struct host* host = argument;
    static float foam[kSmallCount];
    host->result = evaluate_foam(host->sea, 5.0, foam);
    return 0;
}

THREAD_BODY(free_sea, argument) {
    struct host* host = argument;
    ocean_free(host->sea);
    set(&host->freed);
    return 0;
}

void a_second_thread_in_a_sea_is_told_and_free_waits(void) {
    struct host host = {0, 0, 0, 0, 0, OCEAN_INTERNAL, NULL};
    const ocean_options options = watched_by(&host);
    const double place[2] = {1.0, 2.0};
    float sample[9];
    char text[64];
    size_t size = 0;
    int32_t resolution = 0;
    ocean_sea* clone = NULL;
    thread_handle threads[2];
    host.sea = open_small_sea(&options);
    start(&threads[0], follow_foam, &host);
    while (!is_set(&host.inside)) {
    }
    CHECK_RESULT(OCEAN_BUSY, ocean_query(host.sea, 1.0, place, 1, sample, 9));
    CHECK_RESULT(OCEAN_BUSY, ocean_set(host.sea, "wind_speed", "3"));
    CHECK_RESULT(OCEAN_BUSY, ocean_perform(host.sea, 0.0, "wind_speed", "3"));
    CHECK_RESULT(OCEAN_BUSY, ocean_get(host.sea, "wind_speed", text, sizeof(text)));
    CHECK_RESULT(OCEAN_BUSY, ocean_text(host.sea, NULL, &size));
    CHECK_RESULT(OCEAN_BUSY, ocean_map_resolution(host.sea, &resolution));
    CHECK_RESULT(OCEAN_BUSY, ocean_clone(host.sea, NULL, &clone));
    CHECK(clone == NULL);
    start(&threads[1], free_sea, &host);
    for (int i = 0; i < 20000; ++i) { /* a few hundredths of a second */
        CHECK(ocean_query(host.sea, 1.0, place, 1, sample, 9) == OCEAN_BUSY);
    }
    CHECK(!is_set(&host.freed));
    set(&host.go_on);
    for (int i = 0; i < 2; ++i) join(threads[i]);
    CHECK(is_set(&host.freed));
    CHECK(host.result == OCEAN_OK);
    CHECK(host.told > 100);
}

void a_progress_function_ends_a_call_and_the_sea_goes_on(void) {
    struct host host = {0, 1, 1, 0, 0, OCEAN_INTERNAL, NULL};
    ocean_options options = watched_by(&host);
    float* foam = scratch(kSmallCount * sizeof(float));
    float* expected;
    ocean_sea* sea = small_sea(&options);
    CHECK_RESULT(OCEAN_CANCELLED, evaluate_foam(sea, 5.0, foam));
    CHECK(host.told == 1);
    host.answer = 0;
    OK(evaluate_foam(sea, 5.0, foam));
    expected = planar_map(small_sea(NULL), 5.0, 0, OCEAN_FOAM);
    CHECK(memcmp(foam, expected, kSmallCount * sizeof(float)) == 0);
    options.foam_start = 2;
    sea = NULL;
    BAD_ARGUMENT(ocean_parse(kSmallSea, strlen(kSmallSea), NULL, &options, &sea));
    options.foam_start = 0;
    options.reserved = 1;
    BAD_ARGUMENT(ocean_parse(kSmallSea, strlen(kSmallSea), NULL, &options, &sea));
    CHECK(sea == NULL);
}

void the_host_s_rounding_changes_nothing_and_stays(void) {
    ocean_sea* sea = open_small_sea(NULL);
    ocean_sea* other = open_small_sea(NULL);
    float* expected = planar_map(sea, 7.0, 0, OCEAN_FOAM);
    float* map;
    CHECK(fesetround(FE_UPWARD) == 0);
    map = planar_map(other, 7.0, 0, OCEAN_FOAM);
    CHECK(fegetround() == FE_UPWARD);
    BAD_VALUE(ocean_set(other, "wind_speed", "x"));
    CHECK(fegetround() == FE_UPWARD);
    ocean_free(other);
    CHECK(fegetround() == FE_UPWARD);
    fesetround(FE_TONEAREST);
    CHECK(memcmp(expected, map, kSmallCount * sizeof(float)) == 0);
    /* A pool whose threads began under other modes. */
    fesetround(FE_DOWNWARD);
    other = open_small_sea(NULL);
    fesetround(FE_TONEAREST);
    map = planar_map(other, 7.0, 0, OCEAN_FOAM);
    CHECK(memcmp(expected, map, kSmallCount * sizeof(float)) == 0);
    ocean_free(other);
    ocean_free(sea);
}

#if defined(_WIN32)
void children_use_and_free_the_seas_of_their_parent(void) {}
#else
enum { kForks = 1000, kPatience = 120 /* s, in which none must hang */ };

void children_use_and_free_the_seas_of_their_parent(void) {
    const ocean_options two = {.struct_size = sizeof(ocean_options), .threads = 2};
    ocean_sea* sea = open_small_sea(&two);
    float* expected = planar_map(sea, 3.0, 0, OCEAN_HEIGHT);
    alarm(kPatience);
    for (int i = 0; i < kForks; ++i) {
        int status = 1;
        const pid_t child = fork();
        if (child < 0) {
            CHECK(child >= 0);
            break;
        }
        if (child == 0) {
            int right = 1;
            if (i % 4 != 0) {
                float* map = planar_map(sea, 3.0, 0, OCEAN_HEIGHT);
                right = memcmp(map, expected, kSmallCount * sizeof(float)) == 0;
            }
            if (i % 2 == 0) ocean_free(sea);
            _exit(right && failures == 0 ? 0 : 1);
        }
        CHECK(waitpid(child, &status, 0) == child);
        CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
    alarm(0);
    expected = planar_map(sea, 4.0, 0, OCEAN_HEIGHT); /* the parent's goes on */
    ocean_free(sea);
}
#endif
