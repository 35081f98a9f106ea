// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the processor time of a level set from a million columns with OpenVDB's own conversion
// of a closed mesh. Both alternate in the same run, so that other work slows them equally. The mesh
// has a sixteenth of the columns, or the test would take longer than all others in its folder.
#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

#include <cstdio>
#include <ctime>

#include "ocean/internal/modes.hpp"
#include "ocean/io/vdb.hpp"
#include "ocean/ocean.hpp"
#include "testing.hpp"

using namespace ocean;

namespace {

constexpr int kSide = 1024;
constexpr int kMeshSide = kSide / 4;
constexpr double kVoxel = 500.0 / kSide;
constexpr double kBottom = -8.0;
constexpr double kTime = 3.0;

/// Returns the processor time of all threads [s].
double seconds(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Ocean windy_sea(int side) {
    Parameters parameters;
    parameters.grid.resolution = side;
    parameters.grid.patch_size = kVoxel * side;
    parameters.waves.front().wind_speed = 12.0;
    return Ocean(parameters);
}

/// Makes the grid `surface` as `ocean bake` does, including the inversion of the displacement.
void by_columns(Ocean& sea, double crest) {
    constexpr double kPeriod = kVoxel * kSide;
    const io::WorldBox box{{0.0, 0.0, kBottom}, {kPeriod, kPeriod, crest}};
    const io::VoxelRange voxels = io::voxels_around(box, kVoxel, io::kLevelSetBand);
    const auto width = static_cast<std::size_t>(voxels.count[0]);
    std::vector<WorldPoint> points;
    for (std::size_t at = 0; at < voxels.columns(); ++at) {
        points.push_back({voxels.place(0, static_cast<int>(at % width)),
                          voxels.place(1, static_cast<int>(at / width))});
    }
    std::vector<QuerySample> samples(points.size());
    sea.query(kTime, points, samples, {.foam = false});
    std::vector<io::SurfaceColumn> columns;
    for (const QuerySample& sample : samples) {
        columns.push_back(
            {static_cast<float>(sample.height), static_cast<float>(sample.normal[2])});
    }
    io::make_level_set(box, voxels, columns, {}, sea.pool());
}

/// The surface as quads, with walls and a bottom.
void by_mesh(Ocean& sea) {
    const Surface surface =
        sea.evaluate(kTime, {Channel::dx, Channel::dy, Channel::height}, kMeshSide);
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec4I> quads;
    const auto n = static_cast<unsigned>(kMeshSide);
    const auto top = [n](unsigned i, unsigned j) { return j * (n + 1) + i; };
    const auto low = [n, top](unsigned i, unsigned j) { return (n + 1) * (n + 1) + top(i, j); };
    for (const bool is_top : {true, false}) {
        for (const auto [i, j] : test::pairs<unsigned>(n + 1, n + 1)) {
            const std::size_t at = (j % n) * std::size_t{n} + i % n;
            const double x = kVoxel * i + static_cast<double>(surface.channel(Channel::dx)[at]);
            const double y = kVoxel * j + static_cast<double>(surface.channel(Channel::dy)[at]);
            const double z =
                is_top ? static_cast<double>(surface.channel(Channel::height)[at]) : kBottom;
            points.emplace_back(x, y, z);
        }
    }
    for (const auto [i, j] : test::pairs<unsigned>(n, n)) {
        quads.emplace_back(top(i, j), top(i, j + 1), top(i + 1, j + 1), top(i + 1, j));
        quads.emplace_back(low(i, j), low(i + 1, j), low(i + 1, j + 1), low(i, j + 1));
    }
    for (unsigned k = 0; k < n; ++k) {
        quads.emplace_back(top(k, 0), top(k + 1, 0), low(k + 1, 0), low(k, 0));
        quads.emplace_back(top(k, n), low(k, n), low(k + 1, n), top(k + 1, n));
        quads.emplace_back(top(0, k), low(0, k), low(0, k + 1), top(0, k + 1));
        quads.emplace_back(top(n, k), top(n, k + 1), low(n, k + 1), low(n, k));
    }
    const auto transform = openvdb::math::Transform::createLinearTransform(kVoxel);
    const auto grid = openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*transform, points, quads);
    EXPECT_GT(grid->activeVoxelCount(), 1'000'000u / 16);
}

TEST(VdbSpeed, AMillionColumnsAreFortyTimesAsFastAsAMesh) {
    openvdb::initialize();
    Ocean sea = windy_sea(kSide);
    Ocean small = windy_sea(kMeshSide);
    by_columns(sea, 6.0);  // maps and caches are there for both
    small.modes();
    double columns = 1e9, mesh = 1e9;
    for (int run = 0; run < 2; ++run) {
        columns = std::min(columns, seconds([&] { by_columns(sea, 6.0); }));
        mesh = std::min(mesh, seconds([&] { by_mesh(small); }));
    }
    constexpr double kParts = (kSide / kMeshSide) * (kSide / kMeshSide);
    std::printf("%d columns: %.3f s; from a mesh: %.2f s, %.0f times as long\n", kSide * kSide,
                columns, kParts * mesh, kParts * mesh / columns);
    // Forty, and the walls of the smaller mesh, which has more of them for its surface.
    EXPECT_GT(kParts * mesh, 48.0 * columns);
}

}  // namespace
