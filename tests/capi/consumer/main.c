// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The smallest host: a preset's sea, one map of heights, its highest crest.
#include <libocean.h>
#include <stdio.h>
#include <stdlib.h>

int main(void) {
    static char text[65536];
    size_t size = sizeof(text);
    ocean_sea* sea = NULL;
    ocean_output output = {NULL, 128 * 128, {OCEAN_HEIGHT}, 1, OCEAN_ZUP};
    const ocean_request request = {sizeof(request), 12.0, 128, &output, 1};
    output.data = malloc(output.count * sizeof(float));
    if (ocean_preset("beaufort_6", text, &size) || ocean_parse(text, size - 1, NULL, NULL, &sea) ||
        ocean_evaluate(sea, &request)) {
        fprintf(stderr, "%s\n", ocean_last_error());
        return 1;
    }
    float highest = 0.0f;
    for (size_t i = 0; i < output.count; ++i)
        highest = output.data[i] > highest ? output.data[i] : highest;
    printf("libocean %s: highest crest %.2f m\n", ocean_version(), highest);
    free(output.data);
    ocean_free(sea);
    return highest > 0.5f ? 0 : 1;
}
