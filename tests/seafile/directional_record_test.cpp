// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Directions of files in libocean's convention: every quadrant, axes in any order, sectors, the
// energy of each frequency row, and moments from mean and spread against the distribution itself.
#include "ocean/internal/directional_record.hpp"

#include "helpers.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
using enum DirectionConvention;

/// A record of two frequencies whose rows are `row` and twice `row`.
SpectrumRecord filled(const std::vector<double>& bins, const std::vector<double>& row,
                      DirectionConvention convention, double to_per_degree = 1.0) {
    EXPECT_EQ(DirectionAxis::fault(bins), "");
    SpectrumRecord record;
    record.frequency = {0.1, 0.2};
    std::vector<double> values = row;
    for (const double value : row) values.push_back(2.0 * value);
    DirectionAxis(bins, convention).fill(record, values, to_per_degree);
    EXPECT_EQ(record_fault(record), "");
    return record;
}

double at(const SpectrumRecord& record, double direction) {
    const auto found = std::find_if(record.direction.begin(), record.direction.end(),
                                    [&](double d) { return std::abs(d - direction) < 1e-9; });
    EXPECT_NE(found, record.direction.end()) << direction;
    if (found == record.direction.end()) return kNaN;
    return record.directional_density[static_cast<std::size_t>(found - record.direction.begin())];
}

std::vector<double> even_bins(std::size_t count, double first = 0.0) {
    std::vector<double> bins;
    for (std::size_t j = 0; j < count; ++j) {
        bins.push_back(first + 360.0 / static_cast<double>(count) * static_cast<double>(j));
    }
    return bins;
}

TEST(TravelDirection, IsRightInEveryQuadrant) {
    struct Case {
        double file, from, to;  // the angle of the file, and its meaning in either nautical sense
    };
    for (const Case& c : {Case{0, 270, 90},
                          {45, 225, 45},
                          {90, 180, 0},
                          {135, 135, 315},
                          {180, 90, 270},
                          {225, 45, 225},
                          {270, 0, 180},
                          {315, 315, 135},
                          {-45, 315, 135},
                          {360, 270, 90},
                          {720, 270, 90}}) {
        EXPECT_DOUBLE_EQ(travel_direction(c.file, from_nautical), c.from) << c.file;
        EXPECT_DOUBLE_EQ(travel_direction(c.file, to_nautical), c.to) << c.file;
        EXPECT_DOUBLE_EQ(coming_from(c.from), std::fmod(c.file + 360.0, 360.0)) << c.file;
    }
    EXPECT_DOUBLE_EQ(travel_direction(-90.0, to_cartesian), 270.0);
    EXPECT_EQ(travel_direction(-1e-20, to_cartesian), 0.0) << "360 is not below 360";
    EXPECT_TRUE(std::isnan(travel_direction(kNaN, from_nautical))) << "missing stays missing";
    EXPECT_TRUE(std::isnan(coming_from(kNaN)));
}

TEST(DirectionAxis, ABinKeepsItsValueInEveryConventionAndOrder) {
    const std::vector<double> bins = even_bins(8);
    const std::vector<double> row = {1, 2, 3, 4, 5, 6, 7, 8};
    const SpectrumRecord from = filled(bins, row, from_nautical);
    EXPECT_EQ(from.direction, bins) << "ascending, whatever the file's order";
    for (std::size_t j = 0; j < bins.size(); ++j) {
        EXPECT_EQ(at(from, travel_direction(bins[j], from_nautical)), row[j]);
    }
    EXPECT_EQ(at(from, 270.0), 1.0) << "from the north is to the south";
    const std::vector<double> descending(bins.rbegin(), bins.rend());
    const std::vector<double> back(row.rbegin(), row.rend());
    EXPECT_EQ(filled(descending, back, from_nautical).directional_density,
              from.directional_density);
    std::vector<double> wrapped = bins;
    for (double& d : wrapped) d = d > 180.0 ? d - 360.0 : d;
    EXPECT_EQ(filled(wrapped, row, from_nautical).directional_density, from.directional_density);
}

TEST(DirectionAxis, TheBinThatClosesTheCircleCountsOnce) {
    std::vector<double> bins = even_bins(12);
    bins.push_back(360.0);
    std::vector<double> row(13, 1.0);
    const SpectrumRecord record = filled(bins, row, from_nautical);
    EXPECT_EQ(record.direction.size(), 12u);
    EXPECT_NEAR(record.density[0], 360.0, 1e-9);
    const SpectrumRecord half = filled({-180, -90, 0, 90, 180}, {1, 1, 1, 1, 1}, to_cartesian);
    EXPECT_EQ(half.direction, (std::vector<double>{0, 90, 180, 270}));
    EXPECT_NEAR(half.density[1], 720.0, 1e-9);
}

TEST(DirectionAxis, ASectorIsZeroOutsideAndHasTheEnergyOfItsBins) {
    std::vector<double> bins;
    for (double d = 300.0; d <= 420.0; d += 10.0) bins.push_back(d);  // across north
    const double count = static_cast<double>(bins.size());
    const SpectrumRecord record = filled(bins, std::vector<double>(bins.size(), 0.5), to_cartesian);
    EXPECT_EQ(record.direction.size(), bins.size() + 2);
    EXPECT_NEAR(record.density[0], 0.5 * count * 10.0, 1e-9);
    EXPECT_EQ(at(record, 290.0), 0.0);
    EXPECT_EQ(at(record, 70.0), 0.0);
    EXPECT_EQ(at(record, 300.0), 0.5);
    EXPECT_EQ(at(record, 60.0), 0.5);
}

TEST(DirectionAxis, CoarseOrUnevenBinsOfAWholeCircleAreNoSector) {
    EXPECT_EQ(filled({0, 120, 240}, {1, 1, 1}, to_cartesian).direction.size(), 3u);
    const SpectrumRecord uneven =
        filled({0, 10, 40, 100, 180, 270}, {1, 1, 1, 1, 1, 1}, to_cartesian);
    EXPECT_EQ(uneven.direction.size(), 6u);
    EXPECT_NEAR(uneven.density[0], 360.0, 1e-9);
}

TEST(DirectionAxis, DensityIsTheIntegralOfThePiecewiseLinearRow) {
    const std::vector<double> bins = {5, 20, 50, 90, 150, 200, 260, 330};
    const std::vector<double> row = {1, 4, 9, 2, 0, 3, 5, 7};
    const SpectrumRecord record = filled(bins, row, to_nautical, std::numbers::pi / 180.0);
    double integral = 0.0;
    for (std::size_t j = 0; j < bins.size(); ++j) {
        const std::size_t next = (j + 1) % bins.size();
        const double step = bins[next] - bins[j] + (next == 0 ? 360.0 : 0.0);
        integral += 0.5 * (row[j] + row[next]) * step * kDegree;
    }
    EXPECT_NEAR(record.density[0], integral, 1e-12);
    EXPECT_NEAR(record.density[1], 2.0 * integral, 1e-12);
}

TEST(DirectionAxis, AMissingValueIsZero) {
    const SpectrumRecord record = filled({0, 90, 180, 270}, {1, kNaN, 1, 1}, to_cartesian);
    EXPECT_EQ(at(record, 90.0), 0.0);
    EXPECT_NEAR(record.density[0], 270.0, 1e-9);
}

TEST(DirectionAxis, FaultsOfBinsAreNamed) {
    const std::pair<std::vector<double>, std::string> broken[] = {
        {{}, "at least 3 directions"},
        {{0, 180}, "at least 3 directions"},
        {{0, 180, 360}, "at least 3 directions"},
        {std::vector<double>(721, 0.0), "at most 720"},
        {{0, 90, kNaN}, "not a number of degrees"},
        {{0, 90, 1e300}, "not a number of degrees"},
        {{0, 90, std::numeric_limits<double>::infinity()}, "not a number of degrees"},
        {{0, 90, 90, 180}, "appears twice"},
        {{0, 90, 180, 450}, "appears twice"},
        {{0, 90, 180, 270, 360, 720}, "appears twice"},
    };
    for (const auto& [bins, words] : broken) {
        EXPECT_TRUE(test::says(DirectionAxis::fault(bins), words))
            << DirectionAxis::fault(bins) << " | " << words;
    }
    EXPECT_EQ(DirectionAxis::fault(even_bins(720)), "");
    EXPECT_EQ(DirectionAxis::fault(std::vector<double>{350, 0, 10}), "");
}

TEST(MeanAndSpread, TheFirstMomentHasTheMeanAndTheSpread) {
    for (const double spread : {1.0, 20.0, 40.0, 70.0}) {
        for (const double mean : {10.0, 100.0, 190.0, 280.0}) {
            SpectrumRecord record;
            append_mean_and_spread(record, mean, spread);
            const std::complex<double> c1(record.a1[0], record.b1[0]);
            EXPECT_NEAR(std::sqrt(2.0 * (1.0 - std::abs(c1))) / kDegree, spread, 1e-9);
            EXPECT_NEAR(std::abs(c1 - std::polar(std::abs(c1), mean * kDegree)), 0.0, 1e-12);
        }
    }
}

TEST(MeanAndSpread, LimitsAndMissingValues) {
    SpectrumRecord record;
    append_mean_and_spread(record, 90.0, 0.0);
    append_mean_and_spread(record, 90.0, 170.0);
    append_mean_and_spread(record, kNaN, 20.0);
    append_mean_and_spread(record, 90.0, kNaN);
    EXPECT_NEAR(record.b1[0], 1.0, 1e-12);
    EXPECT_TRUE(std::isnan(record.a2[0]) && std::isnan(record.b2[0])) << "nobody measured it";
    EXPECT_NEAR(std::hypot(record.a1[1], record.b1[1]), 0.0, 1e-12);
    for (const std::size_t i : {2u, 3u}) {
        EXPECT_TRUE(std::isnan(record.a1[i]) && std::isnan(record.b1[i]) &&
                    std::isnan(record.a2[i]) && std::isnan(record.b2[i]));
    }
}

TEST(MeanAndPrincipal, TheSecondMomentIsOfTwiceTheAngle) {
    SpectrumRecord record;
    append_mean_and_principal(record, 90.0, 45.0, 0.8, 0.6);
    append_mean_and_principal(record, 180.0, 180.0, 1.0, 0.5);
    const double wanted[2][4] = {{0.0, 0.8, 0.0, 0.6}, {-1.0, 0.0, 0.5, 0.0}};
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(record.a1[i], wanted[i][0], 1e-12) << i;
        EXPECT_NEAR(record.b1[i], wanted[i][1], 1e-12) << i;
        EXPECT_NEAR(record.a2[i], wanted[i][2], 1e-12) << i;
        EXPECT_NEAR(record.b2[i], wanted[i][3], 1e-12) << i;
    }
}

TEST(Moments, OneMissingOfABinIsAllMissingAndAllMissingIsNone) {
    for (std::size_t missing = 0; missing < 4; ++missing) {
        std::array<double, 4> moments = {0.1, 0.2, 0.3, 0.4};
        moments[missing] = kNaN;
        SpectrumRecord record;
        append_moments(record, moments);
        EXPECT_TRUE(std::isnan(record.a1[0]) && std::isnan(record.b1[0]) &&
                    std::isnan(record.a2[0]) && std::isnan(record.b2[0]));
        append_moments(record, {0.1, 0.2, 0.3, 0.4});
        drop_unknown_moments(record);
        ASSERT_EQ(record.a1.size(), 2u);
        EXPECT_EQ(record.b2[1], 0.4);
        record.a1.pop_back(), record.b1.pop_back(), record.a2.pop_back(), record.b2.pop_back();
        drop_unknown_moments(record);
        EXPECT_FALSE(record.has_moments());
    }
}

}  // namespace
}  // namespace ocean::test
