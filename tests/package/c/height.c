// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The smallest host: the height of a sea at x = 10 m, y = 20 m after 12 s.
// usage: height SEA
#include <libocean.h>
#include <stdio.h>

int main(int argc, char** argv) {
    const double point[2] = {10.0, 20.0};
    float sample[9];
    ocean_sea* sea = NULL;
    if (argc != 2 || ocean_open(argv[1], NULL, &sea) ||
        ocean_query(sea, 12.0, point, 1, sample, 9)) {
        fprintf(stderr, "%s\n", argc == 2 ? ocean_last_error() : "usage: height SEA");
        return 1;
    }
    printf("%.9g\n", sample[2]);
    ocean_free(sea);
    return 0;
}
