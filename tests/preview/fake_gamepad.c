/* SPDX-FileCopyrightText: The libocean authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * A gamepad that a file moves, for machines on which no input device can be made: loaded before
 * GLFW (LD_PRELOAD) it answers in its place. The file that FAKE_GAMEPAD names begins with "gamepad"
 * or, for one whose layout nobody knows, "joystick"; then come six axes (left x, y, right x, y,
 * left and right trigger) and four buttons (A, B, X, Y), as numbers. Without the file nothing is
 * plugged in. Each time that the program asks whether it is there, the file that FAKE_GAMEPAD_SEEN
 * names is written: how often it has asked since the other file changed, and what that holds. */
#include <GLFW/glfw3.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static float axes[6];
static unsigned char buttons[4];

/* 0: nothing, 1: a gamepad, 2: a joystick. */
static int read_file(void) {
    const char* path = getenv("FAKE_GAMEPAD");
    FILE* file = path ? fopen(path, "r") : NULL;
    char kind[16] = "";
    int pressed[4] = {0, 0, 0, 0};
    if (!file) return 0;
    const int read =
        fscanf(file, "%15s %f %f %f %f %f %f %d %d %d %d", kind, &axes[0], &axes[1], &axes[2],
               &axes[3], &axes[4], &axes[5], &pressed[0], &pressed[1], &pressed[2], &pressed[3]);
    fclose(file);
    if (read != 11) return 0;
    for (int i = 0; i < 4; ++i) buttons[i] = (unsigned char)pressed[i];
    return strcmp(kind, "gamepad") == 0 ? 1 : 2;
}

/* The first line of the file that moves it; empty without one. */
static void first_line(char* line, int size) {
    const char* name = getenv("FAKE_GAMEPAD");
    FILE* file = name ? fopen(name, "r") : NULL;
    line[0] = '\0';
    if (!file) return;
    if (!fgets(line, size, file)) line[0] = '\0';
    fclose(file);
}

static void tell_seen(void) {
    static char last[256];
    static int times;
    char line[256], beside[4096];
    const char* name = getenv("FAKE_GAMEPAD_SEEN");
    FILE* file;
    if (!name) return;
    first_line(line, sizeof line);
    times = strcmp(line, last) == 0 ? times + 1 : 1;
    strcpy(last, line);
    snprintf(beside, sizeof beside, "%s.new", name);
    file = fopen(beside, "w");
    if (!file) return;
    fprintf(file, "%d %s", times, line);
    fclose(file);
    rename(beside, name);
}

int glfwJoystickPresent(int joystick) {
    if (joystick != GLFW_JOYSTICK_1) return GLFW_FALSE;
    tell_seen();
    return read_file() != 0 ? GLFW_TRUE : GLFW_FALSE;
}

int glfwGetGamepadState(int joystick, GLFWgamepadstate* state) {
    if (joystick != GLFW_JOYSTICK_1 || read_file() != 1) return GLFW_FALSE;
    memset(state, 0, sizeof *state);
    memcpy(state->axes, axes, sizeof axes);
    memcpy(state->buttons, buttons, sizeof buttons);
    return GLFW_TRUE;
}

const float* glfwGetJoystickAxes(int joystick, int* count) {
    *count = joystick == GLFW_JOYSTICK_1 && read_file() != 0 ? 6 : 0;
    return *count ? axes : NULL;
}

const unsigned char* glfwGetJoystickButtons(int joystick, int* count) {
    *count = joystick == GLFW_JOYSTICK_1 && read_file() != 0 ? 4 : 0;
    return *count ? buttons : NULL;
}
