// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A frame of a million vertices, with all that a stage has, from its maps to a whole file: of the
// processor's time, the system's for the file included; other work counts for less there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "ocean/io/usd.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

TEST(UsdSpeed, AFrameOf1024SquaredTakesAFifthOfASecond) {
    const test::TemporaryFolder folder;
    const Surface surface = test::sample_surface(1024);
    double least = 1e9;
    for (int run = 0; run < 5; ++run) {
        const std::clock_t start = std::clock();
        const io::Mesh mesh = io::make_patch_mesh(surface, io::Faces::none);
        ASSERT_FALSE(mesh.velocities.empty() || mesh.foam.empty());
        io::write_usd_frame(mesh, {}, 1.0, folder.file("a.usdc"));
        least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::printf("a frame of 1024 x 1024: %.3f s\n", least);
    EXPECT_LT(least, 0.2);
}

}  // namespace
}  // namespace ocean
