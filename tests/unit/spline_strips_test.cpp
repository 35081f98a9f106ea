// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The strips for which pass one runs, and that a point reads, and no others: storing all of them is
// a quarter of what a point at a new time costs, and making three too many a third.
#include "waves/query/spline_strips.hpp"

#include <set>
#include <string>
#include <vector>

#include "ocean/thread_pool.hpp"
#include "test_seas.hpp"
#include "waves/query/query_folds.hpp"
#include "waves/query/spline_map.hpp"

namespace ocean {
namespace {

TEST(SplineStrips, SweepThoseOfTheFirstRequestAndOfTheTimeBeforeAndThenAllOthers) {
    ThreadPool pool(2);
    const Modes modes = test::modes_of(test::wind_sea(64, 150.0));
    SplineMap map({256, modes.lattice.period}, pool);
    const MapOutput output =
        map.output({Linear::height, Linear::height, Linear::height, Linear::height});
    SplineStrips strips(modes, 256, spline_factor(modes, 64, 256), pool);
    ASSERT_EQ(strips.count(), 8);
    const auto begin = [&](double time) { strips.begin(modes, time, {&output, 1}, pool); };
    const auto make = [&](const std::vector<int>& wanted) { strips.make(wanted, &pool); };
    const auto swept = [&] {
        std::string digits;
        for (int strip = 0; strip < strips.count(); ++strip) {
            if (strips.is_swept(strip)) digits += std::to_string(strip);
        }
        return digits;
    };
    begin(1.0);
    EXPECT_EQ(swept(), "");
    make({2, 3});
    EXPECT_EQ(swept(), "23");
    make({3});
    EXPECT_EQ(swept(), "23");
    begin(2.0);
    EXPECT_EQ(swept(), "");
    make({5});
    EXPECT_EQ(swept(), "235");
    strips.need(6);
    EXPECT_EQ(swept(), "01234567");
    EXPECT_FALSE(strips.has(2));
    begin(3.0);
    make({0});
    EXPECT_EQ(swept(), "056");
    begin(4.0);
    strips.sweep_all(pool);
    EXPECT_EQ(swept(), "01234567");
}

TEST(FoldIndex, ReadsTheStripsNearABlockOfPointsThatItsLabelsReach) {
    ThreadPool pool(1);
    const int size = 512;
    const double period = 512.0;  // a label each metre
    const SplineMap map({size, period}, pool);
    FoldIndex folds(period, size, pool);
    const auto strips_of = [&](double reach, WorldPoint point) {
        folds.begin(1.0, reach);
        std::set<int> strips;
        folds.each_column(map, folds.block_of(point.x, point.y), FoldIndex::kBlock,
                          [&](int column) { strips.insert(column / FoldIndex::kBlock); });
        return strips;
    };
    using Strips = std::set<int>;
    for (const double reach : {0.0, 7.0, 14.0}) {
        EXPECT_EQ(strips_of(reach, {170.0, 3.0}), (Strips{4, 5, 6})) << reach;
        EXPECT_EQ(strips_of(reach, {1.0, 500.0}), (Strips{0, 1, 15})) << reach;
    }
    for (const double reach : {20.0, 30.0}) {
        EXPECT_EQ(strips_of(reach, {170.0, 3.0}), (Strips{3, 4, 5, 6, 7})) << reach;
    }
    EXPECT_EQ(strips_of(40.0, {170.0, 3.0}), (Strips{2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(strips_of(400.0, {170.0, 3.0}).size(), 16u);
}

}  // namespace
}  // namespace ocean
