// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The coast of an island by numbers: beaches where it is sheltered, steep shores where it is
// exposed, one sea, and a water line that lies where the smoothed shore line does.
#include "ocean/internal/shoreline_profile.hpp"

#include <stdexcept>

#include "flood.hpp"
#include "ocean/terrain.hpp"
#include "test_beds.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

/// Heights on square cells, before and after.
struct Coast {
    Domain domain;
    std::vector<float> before;
    std::vector<float> after;
    ShorelineMaps maps;

    int columns() const { return domain.samples[0]; }
    int rows() const { return domain.samples[1]; }
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns()) +
               static_cast<std::size_t>(i);
    }
    void shape(ThreadPool& pool, const ShorelineSettings& settings = {}) {
        after = before;
        maps = shape_shoreline(after, domain, settings, pool);
    }
    /// Returns whether another coast has the same bits.
    bool is_same(const Coast& other) const {
        return after == other.after && maps.beach == other.maps.beach &&
               maps.cliff == other.maps.cliff && maps.shelter == other.maps.shelter &&
               maps.distance == other.maps.distance;
    }
    double slope(int i, int j) const {
        const double x = double{after[index(i + 1, j)]} - double{after[index(i - 1, j)]};
        const double y = double{after[index(i, j + 1)]} - double{after[index(i, j - 1)]};
        return std::hypot(x, y) / (2.0 * domain.step(0));
    }
};

template <typename Height>
Coast made_of(int columns, int rows, double cell, const Height& height) {
    BedGrid grid = test::grid_of(columns, rows, cell, height);
    return {grid.domain, std::move(grid.values), {}, {}};
}

/// An island of 10 km on a tile of 16 km: waves of a terrain of 512 samples on cells of 8 m (or
/// more), a drop towards the border, and a lake inland that smoothing does not close.
Coast island(int side = 2048, std::uint32_t seed = 3) {
    TerrainModel terrain;
    terrain.resolution = 512;
    terrain.patch_size = 16384.0;
    terrain.beta = 2.2;
    terrain.outer_scale = 6000.0;
    terrain.rms = 160.0;
    terrain.seed = seed;
    Terrain land(terrain);
    const Surface waves = land.surface({Channel::height}, side);
    const auto heights = waves.channel(Channel::height);
    std::size_t at = 0;
    return made_of(side, side, terrain.patch_size / side, [&](double x, double y) {
        const double r = std::hypot(x / 8192.0 - 1.0, y / 8192.0 - 1.0);
        const double u = (x - 8700.0) / 400.0, v = (y - 9000.0) / 400.0;
        return double{heights[at++]} + 250.0 - 900.0 * r * r - 800.0 * std::exp(-u * u - v * v);
    });
}

Coast shaped_island() {
    Coast coast = island();
    coast.shape(test::pool());
    return coast;
}

double percentile(std::vector<double>& values, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, values.begin() + at);
    return values[static_cast<std::size_t>(at)];
}

/// Calls use(index, i, j) for all samples but those of the border.
template <typename Use>
void for_each_inside(const Coast& coast, const Use& use) {
    for (const auto [i, j] : test::pairs({1, coast.columns() - 1}, {1, coast.rows() - 1})) {
        use(coast.index(i, j), i, j);
    }
}

/// Returns the numbers of seas, and of those that do not reach the border.
std::array<int, 2> seas_of(const Coast& coast) {
    std::vector<char> seen(coast.after.size());
    std::array<int, 2> count{};
    for (std::size_t first = 0; first < seen.size(); ++first) {
        const auto sea = test::piece_of(first, coast.columns(), coast.rows(), seen,
                                        [&](std::size_t at) { return coast.after[at] <= 0.0f; });
        if (sea.empty()) continue;
        ++count[0];
        count[1] += std::ranges::none_of(sea, [&](std::size_t at) {
            const int i = static_cast<int>(at) % coast.columns();
            const int j = static_cast<int>(at) / coast.columns();
            return i == 0 || j == 0 || i == coast.columns() - 1 || j == coast.rows() - 1;
        });
    }
    return count;
}

// ---- The island

TEST(CoastProfile, ShelteredShoresAreFlatWithABermAndExposedOnesSteepWithACliff) {
    const Coast coast = shaped_island();
    struct Shore {
        std::vector<double> slopes, belt, behind;  // belt: where the bed is 10 m deep
    } sheltered, exposed;
    for_each_inside(coast, [&](std::size_t at, int i, int j) {
        const bool is_sheltered = coast.maps.shelter[at] > 0.95f;
        if (!is_sheltered && coast.maps.shelter[at] >= 0.05f) return;
        Shore& shore = is_sheltered ? sheltered : exposed;
        const double height = double{coast.after[at]}, d = double{coast.maps.distance[at]};
        if (height < -1.0 && height > (is_sheltered ? -6.0 : -5.5)) {
            shore.slopes.push_back(coast.slope(i, j));
        }
        if (height > -10.5 && height < -9.5) shore.belt.push_back(-d);
        if (is_sheltered ? d > 18.0 && d < 40.0 : d > 25.0 && d < 35.0) {
            shore.behind.push_back(height);
        }
    });
    ASSERT_GT(sheltered.slopes.size(), 5000u);
    EXPECT_GT(1.0 / percentile(sheltered.slopes, 0.5), 29.0);
    EXPECT_LT(1.0 / percentile(sheltered.slopes, 0.5), 31.0);
    EXPECT_GT(1.0 / percentile(sheltered.slopes, 0.9), 27.0);
    EXPECT_LT(1.0 / percentile(sheltered.slopes, 0.1), 33.0);
    ASSERT_GT(exposed.slopes.size(), 5000u);
    EXPECT_GT(1.0 / percentile(exposed.slopes, 0.5), 5.9);
    EXPECT_LT(1.0 / percentile(exposed.slopes, 0.5), 6.6);
    ASSERT_GT(sheltered.behind.size(), 1000u);
    EXPECT_NEAR(percentile(sheltered.behind, 0.5), 2.0, 0.1) << "the berm";
    EXPECT_GT(percentile(exposed.behind, 0.5), 8.0) << "a cliff stands behind the shore";
    ASSERT_GT(sheltered.belt.size(), 500u);
    ASSERT_GT(exposed.belt.size(), 500u);
    EXPECT_GT(percentile(sheltered.belt, 0.5), 2.0 * percentile(exposed.belt, 0.5));
}

TEST(CoastProfile, LessLandAroundAShoreSufficesForABeachWhereBeachesSaySo) {
    // Around a round island of 600 m every shore has less than half of the land around it.
    Coast coast = made_of(128, 128, 10.0, [](double x, double y) {
        return 0.4 * (300.0 - std::hypot(x - 640.0, y - 640.0));
    });
    const auto beach_at_the_shore = [&coast](double beaches) {
        ShorelineSettings settings;
        settings.shelter = 100.0;
        settings.beaches = beaches;
        coast.shape(test::pool(), settings);
        std::vector<double> shares;
        for (std::size_t at = 0; at < coast.after.size(); ++at) {
            if (std::abs(coast.maps.distance[at]) < 10.0f) {
                shares.push_back(double{coast.maps.beach[at]});
            }
        }
        return percentile(shares, 0.5);
    };
    EXPECT_LT(beach_at_the_shore(0.0), 0.05);
    EXPECT_GT(beach_at_the_shore(0.25), 0.95);
}

TEST(CoastProfile, OneSeaWhoseLineIsTheShoreLineAndMasksThatAreSmoothShares) {
    const Coast coast = shaped_island();
    Coast raw = coast;
    raw.after = raw.before;
    EXPECT_GT(seas_of(raw)[1], 0) << "the island needs pools to lose";
    EXPECT_EQ(seas_of(coast), (std::array{1, 0}));
    // The lake, too, is land, at the least height of land away from beaches.
    const std::size_t lake = coast.index(8700 / 8, 9000 / 8);
    EXPECT_LT(coast.before[lake], -50.0f);
    EXPECT_FLOAT_EQ(coast.after[lake], 3.0f);
    std::size_t wrong = 0, low = 0, crossings = 0;
    std::size_t outside = 0, sand_and_rock = 0, beaches = 0, cliffs = 0;
    double farthest = 0.0;
    float step = 0.0f, shelter_step = 0.0f;
    const auto is_land = [&](std::size_t at) { return coast.after[at] > 0.0f; };
    for_each_inside(coast, [&](std::size_t at, int i, int j) {
        const float d = coast.maps.distance[at];
        low += d > 130.0f && coast.after[at] < 3.0f;
        wrong += is_land(at) != (d > 0.0f);
        for (const std::size_t next : {coast.index(i + 1, j), coast.index(i, j + 1)}) {
            for (const PageVector<float>* map :
                 {&coast.maps.beach, &coast.maps.cliff, &coast.maps.shelter}) {
                step = std::max(step, std::abs((*map)[at] - (*map)[next]));
            }
            if (is_land(at) == is_land(next)) continue;
            const auto zero = [&](const auto& map) {
                return double{map[at]} / (double{map[at]} - double{map[next]});
            };
            farthest = std::max(farthest, std::abs(zero(coast.after) - zero(coast.maps.distance)));
            ++crossings;
        }
        const float beach = coast.maps.beach[at], cliff = coast.maps.cliff[at];
        for (const float mask : {beach, cliff, coast.maps.shelter[at]}) {
            outside += !(mask >= 0.0f && mask <= 1.0f);
        }
        shelter_step =
            std::max(shelter_step, std::abs(coast.maps.shelter[at] - coast.maps.shelter[at - 1]));
        outside += beach > 0.0f && (d > 130.0f || d < -270.0f);
        outside += cliff > 0.0f && (d > 75.0f || d < -20.0f);
        sand_and_rock += beach > 0.75f && cliff > 0.25f;
        beaches += beach > 0.8f;
        cliffs += cliff > 0.8f;
    });
    EXPECT_EQ(low, 0u);
    EXPECT_EQ(wrong, 0u);
    ASSERT_GT(crossings, 4000u);
    EXPECT_LT(farthest, 0.1) << "a half is promised";
    EXPECT_EQ(outside, 0u);
    EXPECT_EQ(sand_and_rock, 0u);
    EXPECT_GT(beaches, 2000u);
    EXPECT_GT(cliffs, 1000u);
    // The narrowest step of a mask is the 20 m below a cliff: 1.9 / 20 a metre.
    EXPECT_LT(step, 0.75f);
    // A jump after a Gaussian of 60 m: 0.4 / 60 a metre.
    EXPECT_LT(shelter_step, 0.06f);
}

TEST(CoastProfile, OnlySteepExposedShoresHaveCliffs) {
    for (const double slope : {0.05, 0.6}) {
        // A cone, exposed all round.
        Coast cone = made_of(160, 160, 8.0, [=](double x, double y) {
            return slope * (350.0 - std::hypot(x - 636.0, y - 636.0));
        });
        cone.shape(test::pool());
        float highest = 0.0f;
        for_each_inside(cone, [&](std::size_t at, int, int) {
            highest = std::max(highest, cone.maps.cliff[at]);
        });
        if (slope < 0.1) {
            EXPECT_EQ(highest, 0.0f);
        } else {
            EXPECT_GT(highest, 0.9f);
        }
    }
}

// ---- The shore line is that of a Gaussian

TEST(CoastProfile, TheShoreLineIsThatOfTheGaussian) {
    Coast coast = made_of(220, 180, 10.0, [](double x, double y) {
        return 20.0 * std::sin(x / 190.0 + y / 700.0) + 12.0 * std::cos(y / 140.0) + 0.01 * x -
               14.0;
    });
    coast.shape(test::pool(), {.smooth = 45.0});
    // Both passes by the sum, the edge continued.
    std::vector<double> weights;
    for (int k = -20; k <= 20; ++k) weights.push_back(std::exp(-k * k / (2.0 * 4.5 * 4.5)));
    std::vector<double> rows(coast.before.size()), both(coast.before.size());
    for (const auto [j, pass] : test::pairs(coast.rows(), 2)) {
        for (int i = 0; i < coast.columns(); ++i) {
            double sum = 0.0, weight = 0.0;
            for (int k = -20; k <= 20; ++k) {
                const int x = std::clamp(pass == 0 ? i + k : i, 0, coast.columns() - 1);
                const int y = std::clamp(pass == 1 ? j + k : j, 0, coast.rows() - 1);
                const std::size_t at = coast.index(x, y);
                const double w = weights[static_cast<std::size_t>(k + 20)];
                sum += w * (pass == 0 ? double{coast.before[at]} : rows[at]);
                weight += w;
            }
            (pass == 0 ? rows : both)[coast.index(i, j)] = sum / weight;
        }
    }
    Coast sum = coast;
    sum.after.assign(both.begin(), both.end());
    ASSERT_EQ(seas_of(sum)[1], 0) << "no sea is cut off, so that the signs are the sum's";
    std::size_t other_side = 0, near = 0;
    for (std::size_t at = 0; at < both.size(); ++at) {
        const float d = coast.maps.distance[at];
        if ((d > 0.0f) != (both[at] > 0.0)) ++(std::abs(d) > 1.5f ? other_side : near);
    }
    EXPECT_EQ(other_side, 0u);
    EXPECT_LT(near, 40u);
}

// ---- Straight shores

/// A plane that falls to the sea, its shore through the middle at an angle to the rows.
Coast straight_shore(double degrees, double shift = 0.0, double slope = 0.08, int side = 400) {
    const double c = std::cos(degrees * 0.017453293), s = std::sin(degrees * 0.017453293);
    const double middle = 4.0 * (side - 1);
    return made_of(side, side, 8.0, [=](double x, double y) {
        return slope * (c * (y - middle) - s * (x - middle) - shift);
    });
}

TEST(CoastProfile, AStraightShoreHasTheDepthsOfItsLaw) {
    Coast coast = straight_shore(0.0, 3.0, 0.08, 700);
    coast.shape(test::pool(), {.smooth = 16.0});
    // The land share is 1/2: t = 2/7 of the way from 0.46 to 0.60.
    const double t = 2.0 / 7.0, b = t * t * t * (t * (6.0 * t - 15.0) + 10.0);
    const auto shelved = [](double depth) {
        return depth / std::pow(1.0 + std::pow(depth / 45.0, 4), 0.25);
    };
    int compared = 0;
    for (int j = 0; j < coast.rows(); ++j) {
        const std::size_t at = coast.index(350, j);
        const double x = -double{coast.maps.distance[at]};
        EXPECT_NEAR(double{coast.maps.shelter[at]}, b, 0.005);
        EXPECT_NEAR(-x, 8.0 * (j - 349.5) - 3.0, 0.05) << "the distance is that to the line";
        // Not where the slopes go over into each other.
        const bool steep = x > 0.0 && x<35.0, middle = x> 52.5 && x < 216.0;
        const bool outer = x > 324.0 && x < 900.0;
        if (!steep && !middle && !outer) continue;
        const double beach = outer ? 9.0 + (x - 270.0) / 90.0 : x / 30.0;
        const double exposed = steep ? 0.16 * x : 7.0 + (x - 43.75) / 40.0;
        const double depth = b * shelved(beach) + (1.0 - b) * shelved(exposed);
        EXPECT_NEAR(-double{coast.after[at]} / depth, 1.0, 0.02) << x;
        ++compared;
    }
    EXPECT_GT(compared, 90);
    // Far out lies the land's own bed, but no shoal.
    EXPECT_NEAR(double{coast.after[350]}, double{coast.before[350]}, 1e-3);
    Coast shoal = straight_shore(0.0, 0.0, 0.005, 700);
    shoal.shape(test::pool());
    EXPECT_NEAR(double{shoal.after[350]}, -36.0, 1e-3);
}

/// Returns the farthest place of a water line from the straight shore [cells], along columns.
double farthest_from(const Coast& coast, double degrees, std::vector<double>* places = nullptr) {
    const double c = std::cos(degrees * 0.017453293), s = std::sin(degrees * 0.017453293);
    double farthest = 0.0;
    for (const auto [j, i] : test::pairs({1, coast.rows()}, {60, coast.columns() - 60})) {
        const double low = double{coast.after[coast.index(i, j - 1)]};
        const double high = double{coast.after[coast.index(i, j)]};
        if ((low > 0.0) == (high > 0.0)) continue;
        const double y = j - 1 + low / (low - high);
        const double middle = 0.5 * (coast.rows() - 1);
        const double off = c * (y - middle) - s * (i - middle);
        farthest = std::max(farthest, std::abs(off));
        if (places != nullptr) places->push_back(off);
    }
    return farthest;
}

TEST(CoastProfile, AShoreAcrossTheGridHasNoStaircase) {
    for (const double degrees : {0.0, 10.0, 30.0, 45.0}) {
        // From a shore that is nearly flat to one that is a cliff.
        for (const double slope : {0.02, 0.3, 4.0}) {
            Coast coast = straight_shore(degrees, 0.0, slope, 300);
            coast.shape(test::pool());
            EXPECT_LE(farthest_from(coast, degrees), 0.25) << degrees << " degrees, " << slope;
        }
    }
}

TEST(CoastProfile, TheWaterLineMovesWithTheLand) {
    std::vector<double> before;
    for (int step = 0; step <= 10; ++step) {
        std::vector<double> now;
        Coast coast = straight_shore(30.0, 0.08 * step, 1.0, 200);
        coast.shape(test::pool());
        farthest_from(coast, 30.0, &now);
        ASSERT_EQ(now.size(), 80u);
        for (std::size_t i = 0; i < before.size(); ++i) {
            EXPECT_GT(now[i] - before[i], 0.0);
            EXPECT_LT(now[i] - before[i], 0.05) << "for 0.01 cells";
        }
        before = now;
    }
}

// ---- What does not matter

Coast small_island() {
    return made_of(301, 217, 8.0, [](double x, double y) {
        const double u = x / 1200.0 - 1.0, v = y / 860.0 - 1.0;
        return 60.0 - 130.0 * (u * u + v * v) +
               30.0 * std::sin(x / 110.0 + 1.3) * std::cos(y / 83.0) +
               9.0 * std::sin((x + 0.6 * y) / 35.0);
    });
}

TEST(CoastProfile, ATransposedLandHasATransposedCoast) {
    Coast coast = small_island(), turned = coast;
    std::swap(turned.domain.samples[0], turned.domain.samples[1]);
    std::swap(turned.domain.size[0], turned.domain.size[1]);
    for (const auto [i, j, at] : test::cells(coast.columns(), coast.rows())) {
        turned.before[turned.index(j, i)] = coast.before[at];
    }
    coast.shape(test::pool());
    turned.shape(test::pool());
    double height = 0.0, distance = 0.0, mask = 0.0;
    for (int j = 0; j < coast.rows(); ++j) {
        for (int i = 0; i < coast.columns(); ++i) {
            const std::size_t a = coast.index(i, j), b = turned.index(j, i);
            const auto off = [&](const auto& x, const auto& y) {
                return std::abs(double{x[a]} - double{y[b]});
            };
            height = std::max(height, off(coast.after, turned.after));
            distance = std::max(distance, off(coast.maps.distance, turned.maps.distance));
            mask = std::max({mask, off(coast.maps.beach, turned.maps.beach),
                             off(coast.maps.cliff, turned.maps.cliff),
                             off(coast.maps.shelter, turned.maps.shelter)});
        }
    }
    EXPECT_LT(height, 1e-3);
    EXPECT_LT(distance, 1e-2);
    EXPECT_LT(mask, 1e-3);
}

TEST(CoastProfile, NeitherOriginNorLevelMatters) {
    Coast coast = small_island(), moved = coast, raised = coast;
    coast.shape(test::pool());
    moved.domain.origin = {-4.3e6, 7.1e5};
    moved.shape(test::pool());
    EXPECT_TRUE(moved.is_same(coast));
    for (float& h : raised.before) h += 3000.0f;
    raised.shape(test::pool(), {.level = 3000.0});
    for (std::size_t at = 0; at < coast.after.size(); ++at) {
        EXPECT_NEAR(raised.after[at] - 3000.0f, coast.after[at], 2e-2f);
        EXPECT_EQ(raised.after[at] > 3000.0f, raised.maps.distance[at] > 0.0f);
        EXPECT_NE(raised.after[at], 3000.0f);
    }
}

TEST(CoastProfile, CoarseCellsHaveACoastToo) {
    Coast coast = island(64);
    ASSERT_EQ(coast.domain.step(0) > 250.0, true);
    coast.shape(test::pool());
    EXPECT_EQ(seas_of(coast)[1], 0);
    for (std::size_t at = 0; at < coast.after.size(); ++at) {
        EXPECT_EQ(coast.after[at] > 0.0f, coast.maps.distance[at] > 0.0f);
        EXPECT_GT(coast.after[at], -2000.0f);
    }
}

// ---- Progress

TEST(CoastProfile, ProgressRisesAndStopsWithTheHeightsAsTheyWere) {
    const Coast coast = small_island();
    std::vector<float> heights = coast.before;
    std::vector<double> shares;
    shape_shoreline(heights, coast.domain, {}, test::pool(),
                    [&](double share) { shares.push_back(share); });
    EXPECT_GT(shares.size(), 15u);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_EQ(shares.front(), 0.0);
    EXPECT_EQ(shares.back(), 1.0);
    EXPECT_GT(shares[shares.size() - 2], 0.9) << "the passes are counted";
    EXPECT_LT(shares[shares.size() - 2], 1.0);
    for (std::size_t stop = 0; stop < shares.size(); ++stop) {
        heights = coast.before;
        std::size_t calls = 0;
        EXPECT_THROW(shape_shoreline(heights, coast.domain, {}, test::pool(),
                                     [&](double) {
                                         if (calls++ == stop) throw std::runtime_error("stopped");
                                     }),
                     std::runtime_error);
        EXPECT_EQ(calls, stop + 1);
        EXPECT_EQ(heights, coast.before);
    }
}

}  // namespace
}  // namespace ocean
