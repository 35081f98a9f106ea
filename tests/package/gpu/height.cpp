// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The height of a sea at the label x = 0, y = 0 after 12 s, by a GPU and by the processor.
// usage: height SEA
#include <cstdio>
#include <ocean/error.hpp>
#include <ocean/gl/backend.hpp>
#include <ocean/ocean.hpp>
#include <ocean/seafile.hpp>

int main(int argc, char** argv) {
    if (argc != 2) return std::fputs("usage: height SEA\n", stderr), 1;
    try {
        for (const ocean::Backend& backend : {ocean::gl::kBackend, ocean::Backend::cpu}) {
            ocean::Ocean sea(ocean::read_sea(argv[1]), {.backend = backend});
            const ocean::Surface map = sea.evaluate(12.0, {ocean::Channel::height});
            std::printf("%.9g\n", map.channel(ocean::Channel::height)[0]);
        }
    } catch (const ocean::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
