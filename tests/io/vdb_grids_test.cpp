// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: points are read back unchanged; a fog has the cross-section of its puffs above the water,
// and the same voxels for any number of threads and both orientations; a level set has the distance
// to a slope, and no hole in a cliff.
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/points/PointAttribute.h>
#include <openvdb/points/PointCount.h>

#include "ocean/io/vdb.hpp"
#include "ocean/thread_pool.hpp"
#include "testing.hpp"
#include "vdb/vdb_grids.hpp"

using namespace ocean;
namespace points = openvdb::points;

namespace {

struct Attributes {
    openvdb::Vec3d position;
    openvdb::Vec3f velocity;
    float age, life, radius;
};

io::Points some_points(std::size_t count) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-40.0f, 40.0f);
    io::Points made;
    for (std::size_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) made.positions.push_back(number(random));
        for (int axis = 0; axis < 3; ++axis) made.velocities.push_back(number(random));
        made.ages.push_back(number(random));
        made.lives.push_back(number(random));
        made.radii.push_back(number(random));
        made.ids.push_back(std::uint64_t{random()} << 32 | random());
    }
    return made;
}

std::map<std::uint64_t, Attributes> read_points(const std::string& path) {
    openvdb::initialize();
    openvdb::io::File file(path);
    file.open();
    const auto grid = openvdb::gridPtrCast<points::PointDataGrid>(file.readGrid("spray"));
    std::map<std::uint64_t, Attributes> found;
    for (auto leaf = grid->tree().cbeginLeaf(); leaf; ++leaf) {
        const points::AttributeHandle<openvdb::Vec3f> place(leaf->constAttributeArray("P"));
        const points::AttributeHandle<openvdb::Vec3f> velocity(leaf->constAttributeArray("v"));
        const points::AttributeHandle<float> age(leaf->constAttributeArray("age"));
        const points::AttributeHandle<float> life(leaf->constAttributeArray("life"));
        const points::AttributeHandle<float> radius(leaf->constAttributeArray("pscale"));
        const points::AttributeHandle<std::int64_t> id(leaf->constAttributeArray("id"));
        for (auto index = leaf->beginIndexOn(); index; ++index) {
            const openvdb::Vec3d voxel = index.getCoord().asVec3d();
            const openvdb::Vec3d world = grid->transform().indexToWorld(place.get(*index) + voxel);
            const bool is_new =
                found
                    .emplace(static_cast<std::uint64_t>(id.get(*index)),
                             Attributes{world, velocity.get(*index), age.get(*index),
                                        life.get(*index), radius.get(*index)})
                    .second;
            EXPECT_TRUE(is_new);
        }
    }
    return found;
}

TEST(VdbPoints, AreReadBackUnchanged) {
    const io::Points given = some_points(5000);
    const std::string path = testing::TempDir() + "points.vdb";
    const io::VdbGrid grid = io::make_points(given, 2.5);
    io::write_vdb({&grid, 1}, {}, false, path);
    const auto found = read_points(path);
    ASSERT_EQ(found.size(), given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto place = found.find(given.ids[i]);
        ASSERT_NE(place, found.end());
        const Attributes& point = place->second;
        EXPECT_EQ(point.age, given.ages[i]);
        EXPECT_EQ(point.life, given.lives[i]);
        EXPECT_EQ(point.radius, given.radii[i]);
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t at = 3 * i + static_cast<std::size_t>(axis);
            EXPECT_EQ(point.velocity[axis], given.velocities[at]);
            EXPECT_NEAR(point.position[axis], static_cast<double>(given.positions[at]), 1e-6);
        }
    }
    EXPECT_LT(std::filesystem::file_size(path), io::points_vdb_bytes(5000, 5000));
    std::filesystem::remove(path);
}

TEST(VdbPoints, MayBeEmpty) {
    const std::string path = testing::TempDir() + "none.vdb";
    const io::VdbGrid grid = io::make_points({}, 2.5);
    io::write_vdb({&grid, 1}, {}, false, path);
    EXPECT_TRUE(read_points(path).empty());
    std::filesystem::remove(path);
}

const io::WorldBox kBox{{-6.0, -9.0, -4.0}, {30.0, 21.0, 25.0}};
constexpr double kVoxel = 0.5;

std::vector<io::DensityPuff> some_puffs() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::vector<io::DensityPuff> puffs;
    for (int i = 0; i < 200; ++i) {
        const double deviation = 0.4 + part(random);
        puffs.push_back(
            {{-1.0 + 26.0 * part(random), -4.0 + 20.0 * part(random), 6.0 + 12.0 * part(random)},
             deviation,
             0.1 + part(random)});
    }
    return puffs;
}

openvdb::FloatGrid::ConstPtr fog(const std::vector<io::DensityPuff>& puffs, float height,
                                 int threads, bool y_up = false) {
    ThreadPool pool(threads);
    const io::VoxelRange voxels = io::voxels_around(kBox, kVoxel, 0);
    const std::vector<float> heights(voxels.columns(), height);
    const io::VdbGrid grid = io::make_density(voxels, heights, puffs, {y_up}, pool);
    return openvdb::gridConstPtrCast<openvdb::FloatGrid>(grid.grid().grid);
}

double sum_of(const openvdb::FloatGrid& grid) {
    double sum = 0.0;
    for (auto value = grid.cbeginValueOn(); value; ++value) {
        sum += static_cast<double>(*value) * kVoxel * kVoxel * kVoxel;
    }
    return sum;
}

TEST(VdbDensity, HasTheCrossSectionOfItsPuffs) {
    const std::vector<io::DensityPuff> puffs = some_puffs();
    double area = 0.0;
    for (const io::DensityPuff& puff : puffs) area += puff.area;
    const auto grid = fog(puffs, -10.0f, 1);
    EXPECT_EQ(grid->getGridClass(), openvdb::GRID_FOG_VOLUME);
    EXPECT_EQ(grid->getName(), "density");
    EXPECT_NEAR(sum_of(*grid), area, 0.01 * area);
    // One alone is a Gaussian, also where it is narrower than a voxel.
    const io::DensityPuff one{{3.25, 4.0, 5.0}, 1.5, 2.0};
    const auto alone = fog({one}, -10.0f, 1);
    const double peak = 2.0 / std::pow(std::sqrt(2.0 * std::numbers::pi) * 1.5, 3.0);
    const auto at = [&](int i, int j, int k) {
        return static_cast<double>(alone->tree().getValue({i, j, k}));
    };
    EXPECT_NEAR(at(6, 8, 10) / peak, std::exp(-0.5 * std::pow(0.25 / 1.5, 2.0)), 0.01);
    EXPECT_NEAR(at(6, 8, 14) / at(6, 8, 10), std::exp(-0.5 * std::pow(2.0 / 1.5, 2.0)), 1e-4);
    EXPECT_NEAR(sum_of(*fog({{one.place, 0.01, 2.0}}, -10.0f, 1)), 2.0, 0.04);
}

TEST(VdbDensity, EndsAtTheWater) {
    const io::DensityPuff puff{{3.0, 4.0, 5.0}, 1.5, 2.0};
    const auto half = fog({puff}, 5.0f, 1);
    EXPECT_NEAR(sum_of(*half), 1.0, 0.01);
    EXPECT_EQ(half->tree().getValue({6, 8, 9}), 0.0f) << "half a voxel below the water";
    EXPECT_GT(half->tree().getValue({6, 8, 11}), 0.0f);
    EXPECT_TRUE(fog({puff}, 11.0f, 1)->empty());
}

TEST(VdbDensity, DoesNotDependOnThreadsOrOrientation) {
    const std::vector<io::DensityPuff> puffs = some_puffs();
    const auto one = fog(puffs, 7.0f, 1);
    const auto many = fog(puffs, 7.0f, 5);
    const auto turned = fog(puffs, 7.0f, 3, true);
    EXPECT_EQ(one->activeVoxelCount(), many->activeVoxelCount());
    EXPECT_EQ(one->activeVoxelCount(), turned->activeVoxelCount());
    EXPECT_GT(one->activeVoxelCount(), 10'000u);
    std::size_t different = 0;
    for (auto value = one->cbeginValueOn(); value; ++value) {
        const openvdb::Coord at = value.getCoord();
        different += many->tree().getValue(at) == *value ? 0u : 1u;
        // (x, y, z) -> (x, z, -y)
        different += turned->tree().getValue({at[0], at[2], -at[1]}) == *value ? 0u : 1u;
    }
    EXPECT_EQ(different, 0u);
}

openvdb::FloatGrid::ConstPtr level_set(const std::function<double(double x)>& height,
                                       double normal_z) {
    ThreadPool pool(2);
    const io::WorldBox box{{0.0, 0.0, -20.0}, {24.0, 12.0, 30.0}};
    const io::VoxelRange voxels = io::voxels_around(box, kVoxel, io::kLevelSetBand);
    std::vector<io::SurfaceColumn> columns;
    const auto width = static_cast<std::size_t>(voxels.count[0]);
    for (std::size_t at = 0; at < voxels.columns(); ++at) {
        const double x = voxels.place(0, static_cast<int>(at % width));
        columns.push_back({static_cast<float>(height(x)), static_cast<float>(normal_z)});
    }
    const io::VdbGrid grid = io::make_level_set(box, voxels, columns, {}, pool);
    return openvdb::gridConstPtrCast<openvdb::FloatGrid>(grid.grid().grid);
}

TEST(VdbLevelSet, HasTheDistanceToASlope) {
    const auto slope = [](double x) { return 0.75 * x - 8.0; };
    const auto grid = level_set(slope, 0.8);
    std::size_t near = 0;
    for (const auto [i, k] : test::pairs({6, 42}, {-30, 30})) {
        const double expected = 0.8 * (kVoxel * k - slope(kVoxel * i));
        if (std::abs(expected) > 0.99 * io::kLevelSetBand * kVoxel) continue;
        EXPECT_NEAR(static_cast<double>(grid->tree().getValue({i, 12, k})), expected, 1e-5);
        ++near;
    }
    EXPECT_GT(near, 200u);
}

/// Neighbours of which one is water and the other is not, and those among them whose distance is
/// not known.
std::pair<std::size_t, std::size_t> changes_and_holes(const openvdb::FloatGrid& grid) {
    std::size_t changes = 0, holes = 0;
    const openvdb::Coord steps[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const auto [j, i] : test::pairs({-4, 28}, {-4, 52})) {
        for (int k = -46; k < 66; ++k) {
            const openvdb::Coord at(i, j, k);
            for (const openvdb::Coord& step : steps) {
                float a = 0.0f, b = 0.0f;
                const bool known = grid.tree().probeValue(at, a);
                const bool beyond = grid.tree().probeValue(at + step, b);
                if ((a < 0.0f) == (b < 0.0f)) continue;
                ++changes;
                holes += known && beyond ? 0u : 1u;
            }
        }
    }
    return {changes, holes};
}

TEST(VdbLevelSet, HasNoHoleInACliff) {
    // As columns jump where a crest has folded over, here by more than two leaves: at the side of a
    // leaf of 4 m and within one, either way round.
    for (const double cliff : {11.8, 12.3}) {
        for (const bool falls : {true, false}) {
            const auto grid =
                level_set([&](double x) { return (x < cliff) == falls ? 9.0 : -7.0; }, 1.0);
            const auto [changes, holes] = changes_and_holes(*grid);
            EXPECT_GT(changes, 1000u);
            EXPECT_EQ(holes, 0u) << cliff << falls;
        }
    }
}

}  // namespace
