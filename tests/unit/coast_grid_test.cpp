// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Parts of a coast on small grids: blurs have the variance that was requested, distances
// are those to the line, seas are found, and no grid is too small.

#include "field/grid_blur.hpp"
#include "field/zero_line.hpp"
#include "land/shoreline/map_seas.hpp"
#include "ocean/internal/shoreline_profile.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

Domain domain_of(int columns, int rows, double cell) {
    return {{}, {cell * (columns - 1), cell * (rows - 1)}, {columns, rows}, false};
}

// ---- Blur

TEST(CoastBlur, HasTheVarianceThatWasRequested) {
    for (const double deviation : {1.0, 1.7, 5.0, 12.3}) {
        const SampleGrid grid{201, 203};
        std::vector<float> map(grid.count());
        map[grid.index(100, 101)] = 1.0f;
        GridPasses passes(test::pool(), {}, kBlurPasses);
        blur(map, grid, deviation, passes);
        double sum = 0.0, x = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
        for (const auto [i, j, at] : test::cells(grid.columns, grid.rows)) {
            const double w = double{map[at]};
            sum += w;
            x += w * (i - 100);
            xx += w * (i - 100) * (i - 100);
            yy += w * (j - 101) * (j - 101);
            xy += w * (i - 100) * (j - 101);
        }
        EXPECT_NEAR(sum, 1.0, 1e-5);
        EXPECT_NEAR(x, 0.0, 1e-4 * deviation);
        EXPECT_NEAR(xx / (deviation * deviation), 1.0, 1e-4) << deviation;
        EXPECT_NEAR(yy / (deviation * deviation), 1.0, 1e-4) << deviation;
        EXPECT_NEAR(xy / (deviation * deviation), 0.0, 1e-4);
        const double peak = 1.0 / (2.0 * 3.14159265 * deviation * deviation);
        EXPECT_NEAR(double{map[grid.index(100, 101)]} / peak, 1.0, deviation < 2.0 ? 0.15 : 0.08);
    }
}

TEST(CoastBlur, ContinuesTheEdgeAndKeepsPlanes) {
    const SampleGrid grid{90, 33};
    std::vector<float> level(grid.count(), 7.0f), slope(grid.count()), step(grid.count());
    for (const auto [i, j, at] : test::cells(grid.columns, grid.rows)) {
        slope[at] = 0.5f * static_cast<float>(i);
        step[at] = i < 45 ? 0.0f : 1.0f;
    }
    for (std::vector<float>* map : {&level, &slope, &step}) {
        GridPasses passes(test::pool(), {}, kBlurPasses);
        blur(*map, grid, 4.0, passes);
    }
    for (const auto [i, j, at] : test::cells(grid.columns, grid.rows)) {
        EXPECT_NEAR(level[at], 7.0f, 1e-5f);
        if (i >= 16 && i < 74) {
            EXPECT_NEAR(slope[at], 0.5f * static_cast<float>(i), 1e-4f);
        }
        EXPECT_EQ(step[at], step[grid.index(i, 0)]) << "no row differs";
    }
    // Beyond the edge the first value goes on: the mean of |x| of a Gaussian is 0.8 deviations.
    EXPECT_NEAR(slope[grid.index(0, 5)], 0.5f * 4.0f * 0.399f, 0.02f);
    // More of the same than the grid has.
    GridPasses passes(test::pool(), {}, kBlurPasses);
    blur(level, grid, 1e9, passes);
    EXPECT_NEAR(level[0], 7.0f, 1e-5f);
}

// ---- Distance

struct Distances {
    SampleGrid grid;
    std::vector<float> map;
    std::vector<float> distance;
    std::vector<std::uint32_t> nearest;

    Distances(SampleGrid size, std::vector<float> heights)
        : grid(size), map(std::move(heights)), distance(grid.count()), nearest(grid.count()) {
        ThreadPool pool(3);
        GridPasses passes(pool, {}, kDistancePasses);
        std::vector<float> offsets(grid.count());
        zero_line_distance(map, grid, offsets, distance, nearest, passes);
    }
};

/// The line of a map by the definition: its ends in every square, sides of the square in turn.
std::vector<std::array<double, 4>> line_of(const SampleGrid& grid, const std::vector<float>& map) {
    std::vector<std::array<double, 4>> parts;
    constexpr int kX[] = {0, 1, 1, 0}, kY[] = {0, 0, 1, 1};
    for (const auto [i, j] : test::pairs(grid.columns - 1, grid.rows - 1)) {
        std::vector<std::array<double, 2>> ends;
        double h[4];
        for (int c = 0; c < 4; ++c) h[c] = double{map[grid.index(i + kX[c], j + kY[c])]};
        for (int c = 0; c < 4; ++c) {
            const int d = (c + 1) % 4;
            if ((h[c] > 0.0) == (h[d] > 0.0)) continue;
            const double t = h[c] / (h[c] - h[d]);
            ends.push_back({i + kX[c] + t * (kX[d] - kX[c]), j + kY[c] + t * (kY[d] - kY[c])});
        }
        if (ends.size() == 2) parts.push_back({ends[0][0], ends[0][1], ends[1][0], ends[1][1]});
        if (ends.size() == 4) {
            // The ends beside a corner of water belong together.
            const std::size_t s = h[0] > 0.0 ? 0 : 1;
            parts.push_back({ends[s][0], ends[s][1], ends[s + 1][0], ends[s + 1][1]});
            const std::size_t a = s + 2, b = (s + 3) % 4;
            parts.push_back({ends[a][0], ends[a][1], ends[b][0], ends[b][1]});
        }
    }
    return parts;
}

double distance_to(const std::vector<std::array<double, 4>>& line, double x, double y) {
    double least = HUGE_VAL;
    for (const auto& [ax, ay, bx, by] : line) {
        const double length = std::hypot(bx - ax, by - ay);
        double t = 0.0;
        if (length > 0.0) {
            t = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / (length * length);
        }
        t = std::clamp(t, 0.0, 1.0);
        least = std::min(least, std::hypot(ax + t * (bx - ax) - x, ay + t * (by - ay) - y));
    }
    return least;
}

TEST(CoastDistance, IsThatToTheLine) {
    // Whole and broken waves with islands, pools, saddles and lines that end at the border.
    for (const SampleGrid grid : {SampleGrid{47, 38}, SampleGrid{19, 53}, SampleGrid{33, 2}}) {
        std::vector<float> map;
        for (const auto [i, j] : test::pairs(grid.columns, grid.rows)) {
            const double x = i, y = j;
            map.push_back(
                static_cast<float>(std::sin(0.31 * x + 0.07 * y) * std::cos(0.27 * y - 0.1 * x) +
                                   0.3 * std::sin(2.1 * x) * std::sin(1.9 * y)));
        }
        const Distances found(grid, map);
        const auto line = line_of(grid, map);
        for (const auto [i, j, at] : test::cells(grid.columns, grid.rows)) {
            const double exact = distance_to(line, i, j);
            const double near = std::abs(double{found.distance[at]});
            EXPECT_EQ(found.distance[at] > 0.0f, map[at] > 0.0f);
            EXPECT_NEAR(near, exact, exact < 2.4 ? 1e-5 : 0.1) << i << ' ' << j;
            EXPECT_GE(near, exact - 1e-5);
            const int x = static_cast<int>(found.nearest[at]) % grid.columns;
            const int y = static_cast<int>(found.nearest[at]) / grid.columns;
            ASSERT_LT(y, grid.rows);
            EXPECT_LE(std::hypot(x - i, y - j), exact + 1.3);
            EXPECT_LE(distance_to(line, x, y), 0.5001);
        }
    }
}

TEST(CoastDistance, IsExactBesideAStraightLineOfAnyDirection) {
    for (const double degrees : {0.0, 10.0, 30.0, 45.0, 77.0, 90.0, 200.0}) {
        const double c = std::cos(degrees * 0.017453293), s = std::sin(degrees * 0.017453293);
        const SampleGrid grid{120, 100};
        std::vector<float> map;
        for (const auto [i, j] : test::pairs(grid.columns, grid.rows)) {
            map.push_back(static_cast<float>(0.3 * (c * (i - 60.3) + s * (j - 49.6))));
        }
        const Distances found(grid, map);
        double largest = 0.0;
        for (const auto [i, j, at] : test::cells(grid.columns, grid.rows)) {
            const double exact = c * (i - 60.3) + s * (j - 49.6);
            const double foot_x = i - c * exact, foot_y = j - s * exact;
            if (foot_x < 1 || foot_y < 1 || foot_x > 118 || foot_y > 98) continue;
            largest = std::max(largest, std::abs(double{found.distance[at]} - exact));
        }
        EXPECT_LT(largest, 1e-4) << degrees;
    }
}

TEST(CoastDistance, LandOnTheLineIsLand) {
    const Distances found({2, 2}, {1e-38f, -1e5f, 0.0f, -3.0f});
    EXPECT_GT(found.distance[0], 0.0f);
    EXPECT_LT(found.distance[0], 1e-5f);
    EXPECT_EQ(found.distance[2], 0.0f);
    EXPECT_LT(found.distance[1], -0.9f);
}

// ---- Seas

/// Returns the picture after raise_cut_off_seas: '.' is water, '#' land.
std::vector<std::string> raised(const std::vector<std::string>& picture) {
    const SampleGrid grid{static_cast<int>(picture[0].size()), static_cast<int>(picture.size())};
    std::vector<float> map;
    for (const std::string& row : picture) {
        for (const char c : row) map.push_back(c == '#' ? 2.0f : c == '0' ? 0.0f : -1.0f);
    }
    raise_cut_off_seas(map, grid);
    std::vector<std::string> result = picture;
    for (std::size_t j = 0; j < picture.size(); ++j) {
        for (std::size_t i = 0; i < picture[j].size(); ++i) {
            result[j][i] = map[j * picture[j].size() + i] > 0.0f ? '#' : '.';
        }
    }
    return result;
}

TEST(CoastSeas, WaterThatDoesNotReachTheBorderIsRaised) {
    const std::vector<std::string> pools = {"#########",  //
                                            "#..##.0.#",  //
                                            "#.#.#.#.#",  //
                                            "#..##...#",  //
                                            "#########"};
    EXPECT_EQ(raised(pools), std::vector<std::string>(5, "#########"));
    // A way out stays, however long; a step across a corner is none.
    const std::vector<std::string> spiral = {"#########",  //
                                             "#.......#",  //
                                             "#.#####.#",  //
                                             "#.#.###.#",  //
                                             "#.#.....#",  //
                                             "#.#######"};
    std::vector<std::string> with_exit = spiral;
    EXPECT_EQ(raised(spiral), spiral);
    with_exit[5] = "#########";
    EXPECT_EQ(raised(with_exit), std::vector<std::string>(6, "#########"));
    EXPECT_EQ(raised({"#.##", "##.#", "####"}), (std::vector<std::string>{"#.##", "####", "####"}));
    // Seas that each reach the border stay two; forks join late.
    const std::vector<std::string> two = {"..#..", "..#..", "..#.."};
    EXPECT_EQ(raised(two), two);
    const std::vector<std::string> comb = {"#######", "#.#.#.#", "#.#.#.#", "#.....#", "###.###"};
    EXPECT_EQ(raised(comb), comb);
    // Each side of the border counts.
    for (const std::vector<std::string>& bay : {std::vector<std::string>{"####", "##..", "####"},
                                                {"####", "..##", "####"},
                                                {"#.##", "#.##", "####"},
                                                {"####", "#.##", "#.##"}}) {
        EXPECT_EQ(raised(bay), bay);
    }
    EXPECT_EQ(raised({"..", ".."}), (std::vector<std::string>{"..", ".."}));
}

// ---- The whole, on grids and settings at their limits

TEST(CoastProfile, NoGridIsTooSmallAndNoNumberIsBroken) {
    for (const double cell : {0.01, 8.0, 3000.0}) {
        for (const auto& [columns, rows] :
             {std::array{2, 2}, std::array{2, 33}, std::array{40, 2}, std::array{17, 16}}) {
            std::vector<float> heights;
            for (int k = 0; k < columns * rows; ++k) {
                heights.push_back(k % columns < columns / 2 ? -1e5f : 9e4f);
            }
            ShorelineSettings extreme{.beach_slope = 1e-6,
                                      .berm = 1e-6,
                                      .face = 10.0,
                                      .closure = 1e4,
                                      .shelf = 1e-6,
                                      .smooth = 1e-6,
                                      .shelter = 1e6,
                                      .width = 1e-6};
            for (const ShorelineSettings& settings : {ShorelineSettings(), extreme}) {
                std::vector<float> shaped = heights;
                const ShorelineMaps maps =
                    shape_shoreline(shaped, domain_of(columns, rows, cell), settings, test::pool());
                for (std::size_t k = 0; k < shaped.size(); ++k) {
                    EXPECT_TRUE(std::isfinite(shaped[k]));
                    EXPECT_TRUE(std::isfinite(maps.distance[k]));
                    EXPECT_NE(shaped[k], 0.0f);
                    EXPECT_EQ(shaped[k] > 0.0f, maps.distance[k] > 0.0f);
                    for (const PageVector<float>* map : {&maps.beach, &maps.cliff, &maps.shelter}) {
                        EXPECT_GE((*map)[k], 0.0f);
                        EXPECT_LE((*map)[k], 1.0f);
                    }
                }
            }
        }
    }
}

TEST(CoastProfile, AGridWithoutAShoreKeepsItsHeights) {
    const Domain domain = domain_of(60, 50, 8.0);
    for (const float level : {12.0f, -12.0f}) {
        std::vector<float> heights(domain.count());
        for (std::size_t k = 0; k < heights.size(); ++k) {
            heights[k] = level + static_cast<float>(k % 7);
        }
        const std::vector<float> before = heights;
        const ShorelineMaps maps = shape_shoreline(heights, domain, {}, test::pool());
        EXPECT_EQ(heights, before);
        for (std::size_t k = 0; k < heights.size(); ++k) {
            EXPECT_EQ(maps.distance[k], level > 0.0f ? kNoShore : -kNoShore);
            EXPECT_EQ(maps.beach[k], 0.0f);
            EXPECT_EQ(maps.cliff[k], 0.0f);
            EXPECT_EQ(maps.shelter[k], 0.0f);
        }
    }
}

TEST(CoastProfile, LakesAloneAreFilledAndSmallRocksSunk) {
    const Domain domain = domain_of(80, 70, 8.0);
    for (const float side : {1.0f, -1.0f}) {
        std::vector<float> heights(domain.count(), 9.0f * side);
        // A lake of 160 m that smoothing does not close, a rock of 8 m that it removes.
        const int size = side > 0.0f ? 20 : 1;
        for (const auto [i, j] : test::pairs({30, 30 + size}, {20, 20 + size})) {
            heights[static_cast<std::size_t>(80 * j + i)] = -6.0f * side;
        }
        const ShorelineMaps maps = shape_shoreline(heights, domain, {}, test::pool());
        for (std::size_t k = 0; k < heights.size(); ++k) {
            EXPECT_GT(heights[k] * side, 0.0f);
            EXPECT_EQ(maps.distance[k], side * kNoShore);
            EXPECT_EQ(maps.beach[k], 0.0f);
        }
    }
}

TEST(CoastProfile, RefusesWhatItCannotShape) {
    const Domain good = domain_of(8, 6, 8.0);
    std::vector<float> heights(good.count(), 1.0f);
    heights[7] = -4.0f;
    const std::vector<float> before = heights;
    const auto refuses = [&](const Domain& domain, const ShorelineSettings& settings) {
        const auto shape = [&] { shape_shoreline(heights, domain, settings, test::pool()); };
        return test::refusal_of(shape).kind == ErrorKind::invalid_value && heights == before;
    };
    Domain bad = good;
    bad.wraps = true;
    bad.size = {64.0, 48.0};
    EXPECT_EQ(bad.step(0), bad.step(1));
    EXPECT_TRUE(refuses(bad, {}));
    bad = good;
    bad.size[1] *= 1.01;
    EXPECT_TRUE(refuses(bad, {}));
    bad.size = {0.0, 0.0};
    EXPECT_TRUE(refuses(bad, {}));
    EXPECT_TRUE(refuses(domain_of(8, 7, 8.0), {}));
    bad = good;
    bad.samples = {48, 1};
    EXPECT_TRUE(refuses(bad, {}));
    for (double ShorelineSettings::*const number :
         {&ShorelineSettings::beach_slope, &ShorelineSettings::berm, &ShorelineSettings::face,
          &ShorelineSettings::closure, &ShorelineSettings::shelf, &ShorelineSettings::smooth,
          &ShorelineSettings::shelter, &ShorelineSettings::width}) {
        for (const double value : {0.0, -1.0, 1e9, HUGE_VAL, std::nan("")}) {
            ShorelineSettings settings;
            settings.*number = value;
            EXPECT_TRUE(refuses(good, settings)) << value;
        }
    }
    EXPECT_TRUE(refuses(good, {.level = std::nan("")}));
    heights[9] = std::numeric_limits<float>::infinity();
    EXPECT_THROW(shape_shoreline(heights, good, {}, test::pool()), Error);
    EXPECT_EQ(shoreline_bytes(100), 2400u);
}

}  // namespace
}  // namespace ocean
