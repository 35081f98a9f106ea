// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The smallest C++ program: the height of a sea at x = 10 m, y = 20 m after 12 s.
// usage: height SEA
#include <cstdio>
#include <ocean/error.hpp>
#include <ocean/ocean.hpp>
#include <ocean/seafile.hpp>

int main(int argc, char** argv) {
    if (argc != 2) return std::fputs("usage: height SEA\n", stderr), 1;
    try {
        ocean::Ocean sea(ocean::read_sea(argv[1]));
        const ocean::WorldPoint point{10.0, 20.0};
        ocean::QuerySample sample;
        sea.query(12.0, {&point, 1}, {&sample, 1}, {.foam = false});
        std::printf("%.9g\n", static_cast<float>(sample.height));
    } catch (const ocean::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
