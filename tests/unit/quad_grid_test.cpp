// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps of a coast between their samples: blocks of labels read what a single label reads, whatever
// their order and wherever they lie.
#include "field/quad_grid.hpp"

#include "testing.hpp"

namespace ocean {
namespace {

Domain grid() {
    return {{-30.0, 12.0}, {4.0 * 40, 4.0 * 24}, {41, 25}, false};
}

QuadGrid waves_of_four_lengths() {
    const Domain domain = grid();
    std::array<std::vector<float>, 4> fields;
    for (const auto [i, j] : test::pairs(domain.samples[0], domain.samples[1])) {
        for (std::size_t f = 0; f < 4; ++f) {
            const double k = 0.1 * static_cast<double>(f + 1);
            fields[f].push_back(static_cast<float>(std::sin(k * i + 0.3 * j)));
        }
    }
    return QuadGrid(domain, {fields[0], fields[1], fields[2], fields[3]});
}

struct Labels {
    std::vector<double> x, y;
};

/// Rows of labels that cross the border, a row whose labels are far apart, and labels that go west.
std::vector<Labels> blocks_of_labels() {
    std::vector<Labels> blocks(4);
    for (int i = 0; i < 64; ++i) {
        blocks[0].x.push_back(-40.0 + 1.1 * i);
        blocks[0].y.push_back(i < 40 ? 20.0 : 21.0);
        blocks[1].x.push_back(-60.0 + 4.7 * i);
        blocks[1].y.push_back(110.0);
        blocks[2].x.push_back(120.0 - 2.3 * i);
        blocks[2].y.push_back(5.0);
        if (i >= 23) continue;
        blocks[3].x.push_back(-30.0 + 31.0 * (i % 5));
        blocks[3].y.push_back(50.0 + 0.1 * (i / 3));
    }
    return blocks;
}

TEST(QuadGrid, BlocksHaveTheBitsOfSingleReads) {
    const QuadGrid map = waves_of_four_lengths();
    for (const Labels& labels : blocks_of_labels()) {
        GridPlaces places;
        QuadBlock block;
        QuadBlock values;
        places.find(map.domain(), labels.x.size(), labels.x.data(), labels.y.data());
        map.read(places, true, block);
        map.read(places, false, values);
        for (std::size_t i = 0; i < labels.x.size(); ++i) {
            const QuadSample single = map.read(labels.x[i], labels.y[i]);
            for (std::size_t f = 0; f < 4; ++f) {
                const int field = static_cast<int>(f);
                EXPECT_EQ(block.value[f][i], single.value[field]);
                EXPECT_EQ(block.by_x[f][i], single.by_x[field]);
                EXPECT_EQ(block.by_y[f][i], single.by_y[field]);
                EXPECT_EQ(values.value[f][i], single.value[field]);
            }
        }
    }
}

TEST(QuadGrid, PassesThroughItsSamplesAndSlopesAreItsDerivatives) {
    const QuadGrid map = waves_of_four_lengths();
    constexpr double kStep = 0.05;
    for (int n = 0; n < 20; ++n) {
        const auto [x, y] = map.domain().place(1 + n, 2 + n % 20);
        const QuadSample at = map.read(x, y);
        EXPECT_NEAR(at.value[1], std::sin(0.2 * (1 + n) + 0.3 * (2 + n % 20)), 1e-6);
        const QuadSample between = map.read(x + 1.3, y + 0.7);
        const QuadSample east = map.read(x + 1.3 + kStep, y + 0.7);
        const QuadSample west = map.read(x + 1.3 - kStep, y + 0.7);
        const QuadSample north = map.read(x + 1.3, y + 0.7 + kStep);
        const QuadSample south = map.read(x + 1.3, y + 0.7 - kStep);
        // Differences of floats of 1 over 0.1 m are exact to 1e-6, and their step errs by 2e-7.
        const double by_x = static_cast<double>(east.value[2] - west.value[2]) / (2.0 * kStep);
        const double by_y = static_cast<double>(north.value[2] - south.value[2]) / (2.0 * kStep);
        EXPECT_NEAR(between.by_x[2], by_x, 1e-5);
        EXPECT_NEAR(between.by_y[2], by_y, 1e-5);
    }
}

}  // namespace
}  // namespace ocean
