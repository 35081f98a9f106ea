// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Carved land on small grids: sides, borders, outlets, hollows, refusals, progress.

#include <stdexcept>
#include <tuple>

#include "land/streams/stream_coarse.hpp"
#include "land/streams/stream_flood.hpp"
#include "land/streams/stream_heights.hpp"
#include "land/streams/stream_tree.hpp"
#include "ocean/internal/stream_power.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

/// Returns rough land without a direction; its west side is an outlet, or it has none.
StreamLevel rough_level(int columns, int rows, bool has_outlets = true) {
    StreamLevel level;
    for (const auto [i, j] : test::pairs(columns, rows)) {
        level.start.push_back(static_cast<float>(hash_of(7, i, j) % 1000) * 0.05f);
        level.uplift.push_back(0.1f + 0.9f * static_cast<float>(hash_of(8, i, j) % 100) / 100.0f);
        level.outlet.push_back(has_outlets && i == 0 ? 1 : 0);
    }
    return level;
}

StreamSource rough_source() {
    return [](int columns, int rows, double) { return rough_level(columns, rows); };
}

/// A grid at work, on one thread.
struct SmallLand {
    StreamGrid grid;
    std::vector<float> heights;
    std::vector<std::uint8_t> directions;
    ThreadPool pool{1};
    StreamProgress none;
    StreamWork work{pool, none, 1.0};

    SmallLand(int columns, int rows, double cell, float height, std::uint8_t direction)
        : grid{columns, rows, cell},
          heights(grid.size(), height),
          directions(grid.size(), direction) {}
    float& height(int i, int j) { return heights[grid.index(i, j)]; }
    std::uint8_t& direction(int i, int j) { return directions[grid.index(i, j)]; }
};

/// Returns a source of that level alone.
StreamSource source_of(const StreamLevel& level) {
    return [&level](int, int, double) { return level; };
}

/// Returns the number of cells without a lower neighbour that are no outlets.
int pits(int columns, int rows, std::span<const float> heights,
         const std::vector<std::uint8_t>& outlets) {
    const Neighbours neighbours({columns, rows, 1.0});
    int count = 0;
    for (CellIndex p = 0; p < heights.size(); ++p) {
        bool drains = outlets[p] != 0;
        neighbours.each(p, [&](int, CellIndex r) { drains |= heights[r] < heights[p]; });
        count += drains ? 0 : 1;
    }
    return count;
}

TEST(StreamGrid, LandOfAnySidesDrainsToItsOutlets) {
    constexpr std::array<std::array<int, 2>, 7> kSides = {
        {{2, 2}, {2, 300}, {300, 2}, {65, 37}, {129, 97}, {9, 700}, {128, 128}}};
    for (const auto& [columns, rows] : kSides) {
        for (const double age : {1.0, 0.3}) {
            StreamSettings settings;
            settings.age = age;
            const StreamLand land =
                carve(settings, columns, rows, 20.0, rough_source(), test::pool());
            const StreamLevel level = rough_level(columns, rows);
            EXPECT_EQ(pits(columns, rows, land.height, level.outlet), 0)
                << columns << " x " << rows << ", age " << age;
            EXPECT_TRUE(std::ranges::all_of(land.height, [](float h) { return std::isfinite(h); }));
        }
    }
}

TEST(StreamGrid, SourceIsAskedForHalvedSidesFromTheCoarsest) {
    std::vector<std::tuple<int, int, double>> asked;
    const StreamSource source = [&](int columns, int rows, double cell) {
        asked.emplace_back(columns, rows, cell);
        return rough_level(columns, rows);
    };
    carve({}, 201, 130, 10.0, source, test::pool());
    const std::vector<std::tuple<int, int, double>> expected = {
        {51, 33, 40.0}, {101, 65, 20.0}, {201, 130, 10.0}};
    EXPECT_EQ(asked, expected);
}

TEST(StreamGrid, OutletsKeepTheirHeights) {
    StreamLevel fine;
    const StreamSource source = [&](int columns, int rows, double) {
        fine = rough_level(columns, rows);
        for (std::size_t p = 0; p < fine.start.size(); ++p) {
            if (fine.outlet[p] != 0) fine.start[p] = -static_cast<float>(p % 40);
        }
        return fine;
    };
    const StreamLand land = carve({}, 100, 90, 15.0, source, test::pool());
    for (std::size_t p = 0; p < land.height.size(); ++p) {
        if (fine.outlet[p] == 0) continue;
        EXPECT_EQ(land.height[p], fine.start[p]);
        EXPECT_EQ(land.channel[p], 0.0f);
        EXPECT_EQ(land.wetness[p], 1.0f);
        EXPECT_EQ(land.deposit[p], 0.0f);
    }
}

TEST(StreamGrid, AllWaterLeavesByTheOutlets) {
    const int columns = 130, rows = 97;
    const StreamLand land = carve({}, columns, rows, 3.0, rough_source(), test::pool());
    const StreamLevel level = rough_level(columns, rows);
    double sum = 0.0;
    for (std::size_t p = 0; p < land.area.size(); ++p) {
        EXPECT_GE(land.area[p], 9.0f);
        if (level.outlet[p] != 0) sum += static_cast<double>(land.area[p]);
    }
    EXPECT_EQ(sum, 9.0 * columns * rows);
}

TEST(StreamGrid, LandWithoutOutletsDrainsToTheLowestCellOfTheBorder) {
    const int columns = 40, rows = 30;
    StreamLevel level = rough_level(columns, rows, false);
    level.start[15 * columns + 20] = -50.0f;         // inside: no way out
    level.start[7 * columns + columns - 1] = -3.0f;  // on the east side
    level.start[12 * columns] = -3.0f;               // as low, but later
    const StreamLand land = carve({}, columns, rows, 30.0, source_of(level), test::pool());
    EXPECT_EQ(land.area[7 * columns + columns - 1], 900.0f * columns * rows);
    EXPECT_EQ(land.height[7 * columns + columns - 1], -3.0f);
}

TEST(StreamGrid, UpliftOfZeroStillDrains) {
    StreamLevel level = rough_level(64, 64);
    std::ranges::fill(level.uplift, 0.0f);
    for (float& h : level.start) h += 5000.0f;  // a float's steps there are 0.0005 m
    const StreamLand land = carve({}, 64, 64, 1.0, source_of(level), test::pool());
    EXPECT_EQ(pits(64, 64, land.height, level.outlet), 0);
}

TEST(StreamGrid, FloodLeavesAHollowByItsLowestRim) {
    // A hollow of depth 1 within a rim of 9, which has a gap of 5 to the east; the border is 0.
    SmallLand land(7, 7, 1.0, 0.0f, kUnseen);
    for (const auto [i, j] : test::pairs(7, 7)) {
        const int ring = std::max(std::abs(i - 3), std::abs(j - 3));
        land.height(i, j) = ring == 3 ? 0.0f : ring == 2 ? 9.0f : 2.0f;
        if (ring == 3) land.direction(i, j) = kOutlet;
    }
    land.height(5, 3) = 5.0f;
    land.height(3, 3) = 1.0f;
    std::vector<float> level = land.heights;
    std::vector<std::uint8_t> ways = land.directions;
    flood(land.grid, FloodTo::carve, level, ways, land.work);
    for (const auto [i, j] : test::pairs({2, 5}, {2, 5})) {
        EXPECT_EQ(level[land.grid.index(i, j)], 5.0f);
    }
    EXPECT_EQ(level[land.grid.index(5, 3)], 5.0f);
    EXPECT_EQ(level[land.grid.index(1, 3)], 9.0f);
    EXPECT_EQ(ways[land.grid.index(4, 3)], kFlooded | 0);  // to the gap in the east

    flood(land.grid, FloodTo::drain, land.heights, land.directions, land.work);
    std::vector<std::uint8_t> outlets;
    for (const std::uint8_t d : land.directions) outlets.push_back(d == kOutlet ? 1 : 0);
    EXPECT_EQ(pits(7, 7, land.heights, outlets), 0);
    EXPECT_NEAR(land.height(3, 3), 5.0f, 1e-3f);
}

TEST(StreamGrid, TheWayOutOfAHollowFollowsItsValley) {
    // A floor of 2 with a trench of 1 along j = 3, within a rim of 9 whose gap is at the trench.
    SmallLand land(9, 5, 1.0, 2.0f, kUnseen);
    for (int j = 0; j < 5; ++j) {
        land.height(0, j) = land.height(7, j) = 9.0f;
        land.height(8, j) = 0.0f;
        land.direction(8, j) = kOutlet;
    }
    for (int i = 1; i < 7; ++i) land.height(i, 3) = 1.0f;
    land.height(7, 3) = 5.0f;
    flood(land.grid, FloodTo::carve, land.heights, land.directions, land.work);
    for (int i = 1; i < 7; ++i) EXPECT_EQ(land.direction(i, 3), kFlooded | 0) << i;  // to the east
}

TEST(StreamGrid, FloodTiesGoByIndex) {
    // Level ground of two outlets: each cell joins the way that came first.
    SmallLand land(9, 3, 1.0, 4.0f, kUnseen);
    land.direction(0, 1) = land.direction(8, 1) = kOutlet;
    flood(land.grid, FloodTo::drain, land.heights, land.directions, land.work);
    EXPECT_LT(land.height(3, 1), land.height(4, 1));
    EXPECT_LT(land.height(5, 1), land.height(4, 1));
    EXPECT_EQ(land.height(3, 1), land.height(5, 1));
    // (4, 0) is reached from (3, 0), the first of the cells of its height.
    EXPECT_EQ(land.direction(4, 0) & kDirectionBits, 4);
}

/// Returns the share of cells of a plane, inside its border, that drain to direction 0, east, or
/// else to direction 1, of a plane that falls at `angle` [degrees] from east to north.
std::array<double, 2> shares_of_plane(double angle, std::uint32_t seed) {
    SmallLand land(64, 64, 10.0, 0.0f, 6);
    const double turn = angle / 180.0 * 3.14159265358979;
    for (const auto [i, j] : test::pairs(64, 64)) {
        land.height(i, j) = static_cast<float>(-5.0 * (std::cos(turn) * i + std::sin(turn) * j));
    }
    choose_receivers(land.grid, seed, land.heights, land.directions, land.work);
    std::array<double, 2> shares{};
    for (const auto [i, j] : test::pairs({1, 63}, {1, 63})) {
        const std::uint8_t q = land.direction(i, j);
        if (q < 2) shares[q] += 1.0 / (62.0 * 62.0);
    }
    return shares;
}

TEST(StreamGrid, CellsDrainDownTheSteepestSlopeAndTakeTurnsBetweenTwo) {
    EXPECT_GT(shares_of_plane(2.0, 1)[0], 0.99);
    EXPECT_GT(shares_of_plane(43.0, 1)[1], 0.99);
    const std::array<double, 2> between = shares_of_plane(22.5, 1);
    EXPECT_NEAR(between[0], 0.5, 0.05);
    EXPECT_NEAR(between[1], 0.5, 0.05);
    const std::array<double, 2> nearer = shares_of_plane(18.0, 1);
    EXPECT_NEAR(nearer[0], 0.7, 0.05);
    EXPECT_NEAR(nearer[1], 0.3, 0.05);
    EXPECT_NE(between, shares_of_plane(22.5, 2));
}

TEST(StreamGrid, AFinerLevelReadsTheChangeOfTheCoarserOneAroundItsPlace) {
    const StreamGrid grid{40, 30, 8.0};
    std::vector<float> start(grid.size()), heights(grid.size());
    for (const auto [i, j, p] : test::cells(grid.columns, grid.rows)) {
        start[p] = static_cast<float>(hash_of(3, i, j) % 1000);
        heights[p] = start[p] + 5.0f * static_cast<float>(i) + 3.0f * static_cast<float>(j);
    }
    const CoarseHeights coarse(1, grid, start, heights), other(2, grid, start, heights);
    double sum = 0.0, square = 0.0, seeds = 0.0;
    for (const auto [i, j] : test::pairs({4, 76}, {4, 56})) {
        const double at_centre = 5.0 * (0.5 * i - 0.25) + 3.0 * (0.5 * j - 0.25);
        const double shift = static_cast<double>(coarse.change_at(i, j)) - at_centre;
        ASSERT_LE(std::abs(shift), 0.6 * (5.0 + 3.0) + 1e-3);
        sum += shift / (72.0 * 52.0);
        square += shift * shift / (72.0 * 52.0);
        seeds += std::abs(static_cast<double>(coarse.change_at(i, j) - other.change_at(i, j)));
    }
    EXPECT_NEAR(sum, 0.0, 0.2);
    EXPECT_GT(std::sqrt(square), 0.5);
    EXPECT_GT(seeds, 1.0);
}

TEST(StreamGrid, YoungLandIsAtTheHeightOfItsOutlets) {
    StreamSettings settings;
    settings.age = 0.0;
    StreamLevel level = rough_level(60, 50);
    for (std::size_t p = 0; p < level.start.size(); ++p) {
        if (level.outlet[p] != 0) level.start[p] = -700.0f;
    }
    const StreamLand land = carve(settings, 60, 50, 10.0, source_of(level), test::pool());
    const auto [low, high] = std::ranges::minmax(land.height);
    EXPECT_EQ(low, -700.0f);
    EXPECT_LT(high, -699.9f);
}

TEST(StreamGrid, SteadySlopeIsThePowerLawOfArea) {
    StreamSettings settings;
    settings.exponent = 0.45;
    for (const double cell : {0.5, 16.0}) {
        const SteadySlope slope(settings, cell);
        for (const std::uint32_t count :
             {1u, 2u, 3u, 77u, 1000u, 123456u, 98765432u, 0xFFFFFFFFu}) {
            const double ratio = std::max(1.0, count * cell * cell / settings.hillslope_area);
            const double law = settings.slope * std::pow(ratio, -settings.exponent);
            EXPECT_NEAR(slope(count) / law, 1.0, 3e-6) << count << " cells of " << cell << " m";
        }
    }
}

TEST(StreamGrid, ProgressRisesToOneAndStopsWithTheLandAsItWas) {
    std::vector<double> shares;
    carve({}, 300, 300, 10.0, rough_source(), test::pool(),
          [&](double share) { shares.push_back(share); });
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    ASSERT_FALSE(shares.empty());
    EXPECT_GE(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 1.0);
    const StreamProgress stop = [](double) { throw std::runtime_error("stopped"); };
    EXPECT_THROW(carve({}, 64, 64, 10.0, rough_source(), test::pool(), stop), std::runtime_error);
    StreamLand land = carve({}, 64, 64, 10.0, rough_source(), test::pool());
    const PageVector<float> before = land.height;
    EXPECT_THROW(set_age(land, 0.2, test::pool(), stop), std::runtime_error);
    EXPECT_EQ(land.height, before);
    EXPECT_EQ(land.settings.age, 1.0);
    set_age(land, 0.2, test::pool());
    EXPECT_NE(land.height, before);
}

/// Returns whether carve refuses its arguments as invalid.
bool is_refused(const StreamSettings& settings, int columns, int rows, double cell,
                const StreamSource& source = rough_source()) {
    return test::refusal_of([&] {
               carve(settings, columns, rows, cell, source, test::pool());
           }).kind == ErrorKind::invalid_value;
}

TEST(StreamGrid, RefusesSettingsOutOfRange) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [&](double StreamSettings::*member, double value) {
        StreamSettings settings;
        settings.*member = value;
        return is_refused(settings, 16, 16, 10.0);
    };
    EXPECT_FALSE(refused(&StreamSettings::age, 0.0));
    for (const double age : {-0.1, 1.1, kNan}) EXPECT_TRUE(refused(&StreamSettings::age, age));
    EXPECT_TRUE(refused(&StreamSettings::exponent, -1.0));
    EXPECT_TRUE(refused(&StreamSettings::hillslope_area, 0.0));
    EXPECT_TRUE(refused(&StreamSettings::slope, 0.0));
    EXPECT_TRUE(refused(&StreamSettings::max_slope, kNan));
    EXPECT_TRUE(refused(&StreamSettings::creep, -1.0));
    EXPECT_TRUE(is_refused({}, 1, 16, 10.0));
    EXPECT_TRUE(is_refused({}, 16, 0, 10.0));
    EXPECT_TRUE(is_refused({}, 65536, 65536, 10.0));
    EXPECT_TRUE(is_refused({}, 16, 16, 0.0));
}

TEST(StreamGrid, RefusesLevelsOfWrongSizesOrNumbers) {
    const auto refused = [](const std::function<void(StreamLevel&)>& spoil) {
        StreamLevel level = rough_level(16, 16);
        spoil(level);
        return is_refused({}, 16, 16, 10.0, source_of(level));
    };
    EXPECT_FALSE(refused([](StreamLevel&) {}));
    EXPECT_TRUE(refused([](StreamLevel& level) { level.start.pop_back(); }));
    EXPECT_TRUE(refused([](StreamLevel& level) { level.uplift.clear(); }));
    EXPECT_TRUE(refused([](StreamLevel& level) { level.outlet.push_back(0); }));
    EXPECT_TRUE(refused([](StreamLevel& level) { level.start[200] = std::nanf(""); }));
    EXPECT_TRUE(refused([](StreamLevel& level) { level.start[200] = 1e30f; }));
    EXPECT_TRUE(refused([](StreamLevel& level) { level.uplift[255] = 1.5f; }));
    EXPECT_TRUE(refused([](StreamLevel& level) { level.uplift[255] = std::nanf(""); }));
}

}  // namespace
}  // namespace ocean
