// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: degrees become the metres of the ellipsoid; filled holes continue the land around them
// and leave what is known alone.
#include "ocean/internal/elevation.hpp"

#include "ocean/error.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

constexpr float kHole = std::numeric_limits<float>::quiet_NaN();

// Values of the WGS 84 ellipsoid: 2 pi a / 360 at the equator, the rest by the radii of curvature
// as published in the National Geospatial-Intelligence Agency's length-of-a-degree calculator.
TEST(Elevation, ADegreeHasTheLengthThatItHasOnTheEllipsoid) {
    EXPECT_NEAR(metres_per_degree(0.0)[0], 111319.491, 0.001);
    EXPECT_NEAR(metres_per_degree(0.0)[1], 110574.276, 0.001);
    EXPECT_NEAR(metres_per_degree(45.0)[0], 78846.835, 0.001);
    EXPECT_NEAR(metres_per_degree(45.0)[1], 111131.777, 0.002);
    EXPECT_NEAR(metres_per_degree(-60.0)[0], 55800.002, 0.001);
    EXPECT_NEAR(metres_per_degree(90.0)[0], 0.0, 1e-6);
    EXPECT_NEAR(metres_per_degree(90.0)[1], 111693.980, 0.002);
}

TEST(Elevation, CellsOfDegreesAreScaledByTheLatitudeOfTheCentre) {
    ElevationModel model;
    model.domain = {
        .origin = {-119.0, 44.0}, .size = {1.0, 2.0}, .samples = {11, 21}, .wraps = false};
    scale_degrees(model);
    EXPECT_TRUE(model.was_degrees);
    EXPECT_EQ(model.geographic_origin, (std::array{-119.0, 44.0}));
    EXPECT_DOUBLE_EQ(model.geographic_cell[0], 0.1);
    EXPECT_EQ(model.domain.origin, (std::array{0.0, 0.0}));
    EXPECT_NEAR(model.domain.step(0), 7884.6835, 1e-4);
    EXPECT_NEAR(model.domain.step(1), 11113.1777, 2e-4);
    model.domain = {.origin = {0.0, 89.0}, .size = {1.0, 2.0}, .samples = {11, 21}, .wraps = false};
    EXPECT_THROW(scale_degrees(model), Error);
}

/// A model of 9 x 13 cells of 2 m x 3 m at (100, 200) with the heights of a function of the place.
template <typename Height>
ElevationModel oblong(Height height) {
    ElevationModel model;
    model.domain = {
        .origin = {100.0, 200.0}, .size = {16.0, 36.0}, .samples = {9, 13}, .wraps = false};
    for (const auto [i, j] : test::pairs(9, 13)) {
        const auto [x, y] = model.domain.place(i, j);
        model.heights.push_back(static_cast<float>(height(x, y)));
    }
    return model;
}

TEST(Elevation, SquareCellsKeepAPlaneAndItsPlace) {
    const auto plane = [](double x, double y) { return 5.0 + 0.25 * x - 0.5 * y; };
    const ElevationModel model = oblong(plane);
    for (const double cell : {0.7, 2.0, 3.0, 4.0}) {
        const Domain grid = with_square_cells(model, cell).domain;
        const PageVector<float> heights = with_square_cells(model, cell).heights;
        EXPECT_EQ(grid.origin, model.domain.origin);
        EXPECT_DOUBLE_EQ(grid.step(0), cell);
        EXPECT_DOUBLE_EQ(grid.step(1), cell);
        EXPECT_EQ(grid.samples[1], static_cast<int>(36.0 / cell) + 1);
        std::size_t next = 0;
        for (int j = 0; j < grid.samples[1]; ++j) {
            for (int i = 0; i < grid.samples[0]; ++i, ++next) {
                const auto [x, y] = grid.place(i, j);
                EXPECT_NEAR(double{heights[next]}, plane(x, y), 2e-5) << i << " " << j;
            }
        }
    }
}

TEST(Elevation, CoarserSquareCellsHoldTheMeanAndAHoleSpreads) {
    const auto comb = [](double x, double) { return std::fmod(x, 4.0) == 0.0 ? 10.0 : 0.0; };
    ElevationModel model = oblong(comb);
    const ElevationModel coarse = with_square_cells(model, 8.0);
    ASSERT_EQ(coarse.domain.samples, (std::array{3, 5}));
    EXPECT_NEAR(double{coarse.heights[1]}, 5.0, 1e-5) << "every second cell is 10";
    model.heights[4 * 9 + 4] = kHole;
    EXPECT_TRUE(std::isnan(with_square_cells(model, 4.0).heights[3 * 5 + 2]));
    EXPECT_THROW(with_square_cells(model, 100.0), Error);
}

TEST(Elevation, TheSummaryLeavesHolesOut) {
    ElevationModel model;
    model.heights = {1.0f, kHole, 3.0f, 5.0f};
    const ElevationSummary summary = summarize(model);
    EXPECT_EQ(summary.lowest, 1.0f);
    EXPECT_EQ(summary.highest, 5.0f);
    EXPECT_EQ(summary.holes, 1u);
    EXPECT_DOUBLE_EQ(summary.mean, 3.0);
    EXPECT_NEAR(summary.rms, std::sqrt(8.0 / 3.0), 1e-12);
    model.heights = {kHole, kHole};
    EXPECT_EQ(summarize(model).holes, 2u);
    EXPECT_EQ(summarize(model).highest, 0.0f);
}

/// A slope with a curved part that solves Laplace's equation: x^2 - y^2.
float land(int i, int j) {
    const double x = 0.1 * (i - 30), y = 0.1 * (j - 20);
    return static_cast<float>(300.0 + 4.0 * x - 7.0 * y + 2.0 * (x * x - y * y));
}

TEST(Elevation, FilledHolesContinueTheLandAroundThem) {
    constexpr int kColumns = 61, kRows = 40;
    std::vector<float> heights;
    for (const auto [i, j] : test::pairs(kColumns, kRows)) {
        const bool lake = std::hypot(i - 25, j - 18) < 11.0;
        const bool speck = i == 50 && j % 9 == 4;
        heights.push_back(lake || speck ? kHole : land(i, j));
    }
    const std::vector<float> before = heights;
    fill_holes(heights, kColumns);
    for (std::size_t n = 0; n < heights.size(); ++n) {
        const int i = static_cast<int>(n) % kColumns, j = static_cast<int>(n) / kColumns;
        if (std::isnan(before[n])) {
            EXPECT_NEAR(heights[n], land(i, j), 0.01) << i << " " << j;
        } else {
            EXPECT_EQ(std::memcmp(&heights[n], &before[n], sizeof(float)), 0);
        }
    }
}

TEST(Elevation, AHoleAtTheEdgeIsFilledAndAModelOfHolesIsNot) {
    std::vector<float> edge = {kHole, kHole, kHole, 4.0f, 4.0f, 4.0f};
    fill_holes(edge, 3);
    for (const float height : edge) EXPECT_NEAR(height, 4.0f, 1e-3f);
    std::vector<float> holes(6, kHole);
    EXPECT_THROW(fill_holes(holes, 3), Error);
}

}  // namespace
}  // namespace ocean
