// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Carved land by numbers: an island drains, has the exponent asked for, is the same land on every
// grid, and its age is the solution of the equation.
#include "ocean/internal/stream_power.hpp"

#include "land/streams/stream_creep.hpp"
#include "land/streams/stream_land.hpp"
#include "stream_island.hpp"

namespace ocean {
namespace {

using test::StreamIsland;

/// Returns a level of the island, made once.
const StreamLevel& island_level(int n) {
    static std::map<int, StreamLevel> levels;
    if (!levels.contains(n)) levels.emplace(n, StreamIsland().level(n));
    return levels.at(n);
}

StreamLand carved(int n, const StreamSettings& settings, int threads = 2) {
    ThreadPool pool(threads);
    return carve(
        settings, n, n, StreamIsland::kSide / n,
        [](int columns, int, double) { return island_level(columns); }, pool);
}

const StreamLand& island(int n) {
    static std::map<int, StreamLand> lands;
    if (!lands.contains(n)) lands.emplace(n, carved(n, {}));
    return lands.at(n);
}

StreamGrid grid_of(const StreamLand& land) {
    return {land.columns, land.rows, land.cell};
}

/// Drainage by the steepest of eight neighbours, found without the library's tree.
struct PlainDrainage {
    std::vector<std::uint8_t> directions;  // kOutlet where no neighbour is lower, too
    std::vector<double> areas;             // [m2]
    int pits = 0;                          // cells without a lower neighbour that are no outlets
};

PlainDrainage plain_drainage(const StreamGrid& grid, std::span<const float> heights,
                             const std::vector<std::uint8_t>& outlets) {
    const Neighbours neighbours(grid);
    PlainDrainage drainage{std::vector<std::uint8_t>(grid.size(), kOutlet),
                           std::vector<double>(grid.size(), grid.cell * grid.cell)};
    std::vector<CellIndex> by_height(grid.size());
    for (CellIndex p = 0; p < grid.size(); ++p) {
        by_height[p] = p;
        if (outlets[p] != 0) continue;
        double best = 0.0;
        neighbours.each(p, [&](int q, CellIndex r) {
            const double slope = (double{heights[p]} - double{heights[r]}) / grid.distance(q);
            if (slope <= best) return;
            best = slope;
            drainage.directions[p] = static_cast<std::uint8_t>(q);
        });
        if (best == 0.0) ++drainage.pits;
    }
    std::ranges::sort(by_height, [&](CellIndex a, CellIndex b) { return heights[a] > heights[b]; });
    for (const CellIndex p : by_height) {
        const int q = drainage.directions[p];
        if (q != kOutlet) drainage.areas[neighbours.towards(p, q)] += drainage.areas[p];
    }
    return drainage;
}

/// Returns the exponent of slope by area: a line through the mean logarithms of half e-foldings of
/// area from 1e5 to 2e7 m2. Slopes are divided by the uplift, which rises inland as areas fall.
double exponent_of(const StreamGrid& grid, std::span<const float> heights,
                   std::span<const std::uint8_t> directions, const auto& areas,
                   const std::vector<float>& uplift) {
    struct Bin {
        double count = 0.0, log_area = 0.0, log_slope = 0.0;
    };
    const Neighbours neighbours(grid);
    std::map<int, Bin> bins;
    for (CellIndex p = 0; p < grid.size(); ++p) {
        const auto area = static_cast<double>(areas[p]);
        if (directions[p] == kOutlet || area < 1e5 || area > 2e7) continue;
        const int q = directions[p];
        const double drop = double{heights[p]} - double{heights[neighbours.towards(p, q)]};
        Bin& bin = bins[static_cast<int>(std::floor(2.0 * std::log(area)))];
        bin.count += 1.0;
        bin.log_area += std::log(area);
        bin.log_slope += std::log(std::max(drop / grid.distance(q) / double{uplift[p]}, 1e-9));
    }
    test::LineFit line;
    for (const auto& [key, bin] : bins) {
        if (bin.count <= 20.0) continue;
        line.add(bin.log_area / bin.count, bin.log_slope / bin.count);
    }
    return -line.slope();
}

/// Returns the share of valley chords that lie within 5 degrees of the grid's eight directions:
/// chords from each cell with at least min_area [m2] to the cells 8 .. 16 steps downstream.
double chords_along_the_grid(const StreamGrid& grid, std::span<const std::uint8_t> directions,
                             std::span<const float> areas, float min_area) {
    const Neighbours neighbours(grid);
    const auto columns = static_cast<CellIndex>(grid.columns);
    double all = 0.0, along = 0.0;
    for (CellIndex p = 0; p < grid.size(); ++p) {
        if (areas[p] < min_area) continue;
        CellIndex q = p;
        for (int step = 1; step <= 16 && directions[q] != kOutlet; ++step) {
            q = neighbours.towards(q, directions[q]);
            if (step < 8) continue;
            const double x = static_cast<double>(q % columns) - static_cast<double>(p % columns);
            const double y = static_cast<double>(q / columns) - static_cast<double>(p / columns);
            const double eighths = std::atan2(y, x) / (kPi / 4.0);
            all += 1.0;
            if (std::abs(eighths - std::round(eighths)) * 45.0 <= 5.0) along += 1.0;
        }
    }
    return along / all;
}

/// Returns the correlation of heights with the means of a grid twice as fine, on land.
double correlation_with_finer(const StreamLand& land, const StreamLand& fine,
                              const std::vector<std::uint8_t>& outlets) {
    test::LineFit line;
    const StreamGrid fine_grid = grid_of(fine);
    for (const auto [i, j, p] : test::cells(land.columns, land.rows)) {
        if (outlets[p] != 0) continue;
        double mean = 0.0;
        for (const auto [di, dj] : test::pairs(2, 2)) {
            mean += 0.25 * double{fine.height[fine_grid.index(2 * i + di, 2 * j + dj)]};
        }
        line.add(double{land.height[p]}, mean);
    }
    return line.correlation();
}

TEST(StreamPower, EveryCellDrainsAfterCreepAtAnyAge) {
    StreamLand land = island(512);
    for (const double age : {1.0, 0.5, 0.1, 0.0}) {
        set_age(land, age, test::pool());
        EXPECT_EQ(plain_drainage(grid_of(land), land.height, island_level(512).outlet).pits, 0)
            << "age " << age;
    }
    EXPECT_EQ(
        plain_drainage(grid_of(island(1024)), island(1024).height, island_level(1024).outlet).pits,
        0);
}

TEST(StreamPower, SlopesFallWithAreaByTheExponent) {
    for (const double exponent : {0.45, 0.3}) {
        StreamSettings settings;
        settings.exponent = exponent;
        settings.creep = 0.0;
        const int n = 512;
        const StreamLand land = carved(n, settings);
        const std::vector<float>& uplift = island_level(n).uplift;
        const StreamGrid grid = grid_of(land);
        EXPECT_NEAR(
            exponent_of(grid, land.height, land.tree->directions, land.area, uplift) / exponent,
            1.0, 0.01);
        const PlainDrainage plain = plain_drainage(grid, land.height, island_level(n).outlet);
        EXPECT_NEAR(
            exponent_of(grid, land.height, plain.directions, plain.areas, uplift) / exponent, 1.0,
            0.02);
    }
}

TEST(StreamPower, AFinerGridShowsTheSameLandWhoseValleysFollowNoGridButTheSeed) {
    const StreamLand& land = island(1024);
    EXPECT_GT(correlation_with_finer(island(512), land, island_level(512).outlet), 0.99);
    for (const float min_area : {1e5f, 1e6f}) {  // 10 of 45 degrees are 22 %
        EXPECT_LT(chords_along_the_grid(grid_of(land), land.tree->directions, land.area, min_area),
                  0.29)
            << min_area << " m2";
    }
    StreamSettings other;
    other.seed = 2;
    EXPECT_NE(carved(64, other).height, carved(64, {}).height);
}

TEST(StreamPower, BitsDoNotDependOnThreads) {
    const StreamLand one = carved(256, {}, 1);
    for (const int threads : {2, 5}) {
        StreamLand land = carved(256, {}, threads);
        EXPECT_EQ(land.height, one.height);
        EXPECT_EQ(land.area, one.area);
        EXPECT_EQ(land.channel, one.channel);
        EXPECT_EQ(land.wetness, one.wetness);
        EXPECT_EQ(land.deposit, one.deposit);
        EXPECT_EQ(land.tree->response, one.tree->response);
        ThreadPool pool(threads), one_thread(1);
        StreamLand aged = one;
        set_age(aged, 0.3, one_thread);
        set_age(land, 0.3, pool);
        EXPECT_EQ(land.height, aged.height);
        EXPECT_EQ(land.deposit, aged.deposit);
    }
}

TEST(StreamPower, AgeIsTheSameFromTheSolutionAndFromTheSlider) {
    StreamSettings young;
    young.age = 0.35;
    const StreamLand asked = carved(256, young);
    StreamLand set = carved(256, {});
    const PageVector<float> steady = set.height;
    set_age(set, 0.35, test::pool());
    EXPECT_EQ(set.height, asked.height);
    EXPECT_EQ(set.wetness, asked.wetness);
    EXPECT_EQ(set.deposit, asked.deposit);
    EXPECT_EQ(set.settings, asked.settings);
    set_age(set, 1.0, test::pool());
    EXPECT_EQ(set.height, steady);
}

TEST(StreamPower, OlderLandIsHigher) {
    StreamLand land = island(512);
    PageVector<float> before;
    double mean_before = -1.0;
    for (const double age : {0.0, 0.05, 0.2, 0.5, 0.8, 1.0}) {
        set_age(land, age, test::pool());
        double mean = 0.0;
        for (std::size_t p = 0; p < land.height.size(); ++p) {
            mean += static_cast<double>(land.height[p]);
            // The last flood raises flat land by 0.1 mm a cell.
            if (before.empty()) continue;
            ASSERT_GT(land.height[p], before[p] - 0.1f) << "age " << age;
        }
        EXPECT_GT(mean, mean_before);
        mean_before = mean;
        before = land.height;
    }
}

/// Returns uncrept land of the island with another uplift on the finest of its levels, which
/// coarser levels sample.
StreamLand uncrept_land(int n, const std::vector<float>& uplift) {
    StreamSettings settings;
    settings.creep = 0.0;
    return carve(
        settings, n, n, StreamIsland::kSide / n,
        [&](int columns, int, double) {
            StreamLevel level = island_level(columns);
            const int step = n / columns;
            const StreamGrid grid{columns, columns, 1.0}, fine{n, n, 1.0};
            for (const auto [i, j] : test::pairs(columns, columns)) {
                level.uplift[grid.index(i, j)] = uplift[fine.index(i * step, j * step)];
            }
            return level;
        },
        test::pool());
}

/// Returns the rms difference of an age's heights from those of implicit steps [Braun and Willett
/// 2013] on the same tree, as a share of their rms. The steps smear what travels upstream over the
/// square root of the cells that it passes, so each cell is divided into `parts`.
double error_of_age(const std::vector<float>& uplift, double age, std::size_t parts, int steps) {
    StreamLand land = uncrept_land(128, uplift);
    set_age(land, age, test::pool());
    const StreamTree& tree = *land.tree;
    std::vector<CellIndex> upstream;
    for (CellIndex p = 0; p < tree.grid.size(); ++p) {
        if (tree.directions[p] != kOutlet) upstream.push_back(p);
    }
    std::ranges::sort(
        upstream, [&](CellIndex a, CellIndex b) { return tree.response[a] < tree.response[b]; });
    const Neighbours neighbours(tree.grid);
    std::vector<double> z(tree.grid.size() * parts, 0.0);
    const double dt = age * double{tree.last_response} / steps;
    for (int step = 0; step < steps; ++step) {
        for (const CellIndex p : upstream) {
            const CellIndex r = neighbours.towards(p, tree.directions[p]);
            const double f = dt * static_cast<double>(parts) /
                             (double{tree.response[p]} - double{tree.response[r]});
            double below = z[(r + 1) * parts - 1];
            for (std::size_t part = 0; part < parts; ++part) {
                double& here = z[p * parts + part];
                here = (here + dt * double{uplift[p]} + f * below) / (1.0 + f);
                below = here;
            }
        }
    }
    double difference = 0.0, square = 0.0;
    for (const CellIndex p : upstream) {
        const double stepped = z[(p + 1) * parts - 1];
        difference += std::pow(stepped - double{land.height[p]}, 2.0);
        square += stepped * stepped;
    }
    return std::sqrt(difference / square);
}

TEST(StreamPower, AgeIsTheSolutionOfTheEquation) {
    const std::vector<float> uniform(128 * 128, 1.0f);
    // The uplift of the island rises inland fourfold.
    for (const std::vector<float>& uplift : {uniform, island_level(128).uplift}) {
        const double coarse = error_of_age(uplift, 0.4, 1, 100);
        const double fine = error_of_age(uplift, 0.4, 8, 400);
        EXPECT_LT(fine, 0.04);
        EXPECT_LT(fine, 0.5 * coarse) << "the steps do not converge to the land";
    }
}

TEST(StreamPower, CreepSpreadsACrestByItsReachOnAnyGrid) {
    for (const double cell : {2.0, 8.0, 25.0}) {
        const int n = static_cast<int>(1000.0 / cell);
        const StreamGrid grid{n, 40, cell};
        const double reach = 55.0;
        for (const bool along_x : {true, false}) {
            const StreamGrid turned = along_x ? grid : StreamGrid{40, n, cell};
            std::vector<float> heights(turned.size(), 0.0f), channel(turned.size(), 0.0f);
            std::vector<std::uint8_t> directions(turned.size(), 0);
            const auto at = [&](int k, int line) {
                return along_x ? turned.index(k, line) : turned.index(line, k);
            };
            for (int line = 0; line < 40; ++line) heights[at(n / 2, line)] = 100.0f;
            const StreamProgress none;
            StreamWork work(test::pool(), none, 1.0);
            creep(turned, reach, channel, directions, heights, work);
            double sum = 0.0, moment = 0.0;
            for (int k = 0; k < n; ++k) {
                const auto h = static_cast<double>(heights[at(k, 17)]);
                EXPECT_GE(h, -1e-4);
                sum += h;
                moment += h * std::pow((k - n / 2) * cell, 2.0);
            }
            EXPECT_NEAR(sum, 100.0, 0.01);
            EXPECT_NEAR(std::sqrt(moment / sum), reach / std::sqrt(2.0), 0.01 * reach);
        }
    }
}

TEST(StreamPower, CreepLeavesChannelsAndOutlets) {
    StreamSettings bare;
    bare.creep = 0.0;
    const StreamLand before = carved(256, bare);
    const StreamLand& after = island(256);
    ASSERT_EQ(before.area, after.area);
    double crest = 0.0, bed = 0.0, crests = 0.0, beds = 0.0;
    for (std::size_t p = 0; p < after.height.size(); ++p) {
        const auto change = static_cast<double>(after.height[p] - before.height[p]);
        if (after.channel[p] > 0.99f) {
            bed += std::abs(change);
            beds += 1.0;
        } else if (after.area[p] <= 2.0f * 64.0f * 64.0f && island_level(256).outlet[p] == 0) {
            crest += change;
            crests += 1.0;
        }
    }
    EXPECT_LT(bed / beds, 0.1);
    EXPECT_LT(crest / crests, -0.3);
}

TEST(StreamPower, MasksFollowTheLand) {
    const StreamLand& land = island(512);
    const std::vector<std::uint8_t>& outlets = island_level(512).outlet;
    std::array<double, 2> wetness{}, deposit{}, count{};
    for (std::size_t p = 0; p < land.height.size(); ++p) {
        for (const float mask : {land.channel[p], land.wetness[p], land.deposit[p]}) {
            ASSERT_TRUE(mask >= 0.0f && mask <= 1.0f);
        }
        if (outlets[p] != 0) continue;
        const double ratio = static_cast<double>(land.area[p]) / kChannelArea;
        ASSERT_NEAR(land.channel[p], ratio * ratio / (1.0 + ratio * ratio), 1e-6);
        const bool is_river = land.area[p] > 1e6f;
        const bool is_crest = land.area[p] < 3000.0f;
        if (!is_river && !is_crest) continue;
        const std::size_t side = is_river ? 1 : 0;
        wetness[side] += static_cast<double>(land.wetness[p]);
        deposit[side] += static_cast<double>(land.deposit[p]);
        count[side] += 1.0;
    }
    EXPECT_LT(wetness[0] / count[0], 0.2);
    EXPECT_GT(wetness[1] / count[1], 0.7);
    EXPECT_LT(deposit[0] / count[0], 0.2);
    EXPECT_GT(deposit[1] / count[1], 0.7);
}

}  // namespace
}  // namespace ocean
