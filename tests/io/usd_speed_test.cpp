// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the processor time of a frame with a million vertices and all attributes, from its maps
// to the file, with that of writing as many raw bytes. Both alternate in the same run, so that
// other work on the machine slows them equally.

#include <cstdio>
#include <ctime>

#include "ocean/internal/io/usd.hpp"
#include "sample_surface.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

/// Returns the processor time, including that of the system for files [s].
template <typename Work>
double seconds(const Work& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(UsdSpeed, AFrameOf1024SquaredIsNearlyAsFastAsItsBytes) {
    const test::TemporaryFolder folder;
    using enum Channel;
    const Surface surface =
        test::sample_surface(1024, 0.0, {dx, dy, height, nx, ny, nz, foam, vx, vy, vz});
    const std::string frame = folder.file("a.usdc");
    const std::string copy = folder.file("b");
    std::string bytes;
    double making = 1e9, writing = 1e9;
    for (int run = 0; run < 5; ++run) {
        making = std::min(making, seconds([&] {
                              const io::Mesh mesh = io::make_patch_mesh(surface, io::Faces::none);
                              ASSERT_TRUE(mesh.find("velocity") && mesh.find("foam"));
                              io::write_usd_frame(mesh, {}, 1.0, frame);
                          }));
        if (run == 0) bytes = test::read_bytes(frame);
        writing = std::min(writing, seconds([&] {
                               std::ofstream(copy, std::ios::binary)
                                   << std::string(bytes);  // copied once in memory, as a mesh is
                           }));
        std::filesystem::remove(copy);
    }
    ASSERT_GT(bytes.size(), 40'000'000u);
    std::printf("a frame of 1024 x 1024: %.3f s; its %zu bytes: %.3f s\n", making, bytes.size(),
                writing);
    EXPECT_LT(making, 10.0 * writing);
}

}  // namespace
}  // namespace ocean
