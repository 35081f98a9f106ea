/* SPDX-FileCopyrightText: The libocean authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * Screens of other content scales, which X has one of at a time: loaded before GLFW (LD_PRELOAD) it
 * answers for the screen that a window is on. The file that FAKE_SCREEN names holds its scale; when
 * that changes, the window has gone to another screen, and is told so when it looks for events.
 * Without the file the scale is 1. */
#define _GNU_SOURCE
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

static GLFWwindow* window;
static GLFWwindowcontentscalefun listener;
static float told = 1.0f;

static float scale_now(void) {
    const char* path = getenv("FAKE_SCREEN");
    FILE* file = path ? fopen(path, "r") : NULL;
    float scale = 1.0f;
    if (!file) return scale;
    if (fscanf(file, "%f", &scale) != 1) scale = 1.0f;
    fclose(file);
    return scale;
}

static void tell_change(void) {
    const float scale = scale_now();
    if (scale == told) return;
    told = scale;
    if (listener) listener(window, scale, scale);
}

void glfwGetWindowContentScale(GLFWwindow* of, float* x, float* y) {
    (void)of;
    *x = *y = told;
}

GLFWwindowcontentscalefun glfwSetWindowContentScaleCallback(GLFWwindow* of,
                                                            GLFWwindowcontentscalefun callback) {
    GLFWwindowcontentscalefun before = listener;
    window = of;
    listener = callback;
    told = scale_now();
    return before;
}

void glfwPollEvents(void) {
    void (*original)(void) = (void (*)(void))dlsym(RTLD_NEXT, "glfwPollEvents");
    original();
    tell_change();
}

void glfwWaitEventsTimeout(double seconds) {
    void (*original)(double) = (void (*)(double))dlsym(RTLD_NEXT, "glfwWaitEventsTimeout");
    original(seconds);
    tell_change();
}
