// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Several handles at once, and what each thread keeps for itself.
#if !defined(_WIN32)
#define _POSIX_C_SOURCE 200809L
#endif
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
    ocean_options options = {sizeof(ocean_options), 0, OCEAN_CPU};
    ocean_sea* sea = NULL;
    options.threads = job->threads;
    job->result = ocean_parse(kSmallSea, strlen(kSmallSea), NULL, &options, &sea);
    for (int step = 0; step < kFrames && job->result == OCEAN_OK; ++step) {
        const int frame = job->backwards ? kFrames - 1 - step : step;
        ocean_output output = {
            NULL, kSmallCount * kChannels, {OCEAN_DX, OCEAN_HEIGHT, OCEAN_NX, OCEAN_VZ}, 4, 0};
        ocean_request request = {sizeof(ocean_request), 0.0, 0, NULL, 1};
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
    job->clean_before = strcmp(ocean_last_error(), "") == 0;
    ocean_preset("typhoon", NULL, &size);
    job->own_after = strstr(ocean_last_error(), "typhoon") != NULL;
    return 0;
}

void errors_are_kept_per_thread(void) {
    struct error_job job = {0, 0};
    thread_handle thread;
    size_t size = 0;
    CHECK_RESULT(OCEAN_NOT_FOUND, ocean_preset("breeze", NULL, &size));
    start(&thread, fail_here, &job);
    join(thread);
    CHECK(job.clean_before && job.own_after);
    CHECK(strstr(ocean_last_error(), "breeze") != NULL);
    /* A success leaves it alone. */
    CHECK_RESULT(OCEAN_OK, ocean_preset(NULL, NULL, &size));
    CHECK(strstr(ocean_last_error(), "breeze") != NULL);
}
