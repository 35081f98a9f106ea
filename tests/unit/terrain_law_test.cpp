// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The law of a terrain against its equations. Files tell of its rules (BadTerrain).
#include "ocean/internal/terrain_law.hpp"

#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/measured_rings.hpp"
#include "ocean/terrain_table.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

TerrainModel power_law(double beta) {
    TerrainModel terrain;
    terrain.beta = beta;
    return terrain;
}

double log_slope(const TerrainLaw& law, double k) {
    return std::log(law.density(1.001 * k, 0.0) / law.density(k / 1.001, 0.0)) /
           (2.0 * std::log(1.001));
}

TEST(TerrainLaw, TheDensityFallsAsTwiceBeta) {
    const TerrainLaw law(power_law(1.7));
    EXPECT_NEAR(law.density(0.2, 0.0) / law.density(0.1, 0.0), std::pow(2.0, -3.4), 1e-12);
    EXPECT_NEAR(law.density(0.03, 0.04), law.density(0.05, 0.0), 1e-9 * law.density(0.05, 0.0));
    EXPECT_NEAR(law.exponent(0.3), 1.7, 1e-9);
    EXPECT_EQ(law.density(0.0, 0.0), 0.0);
    EXPECT_FALSE(law.is_absolute());
}

TEST(TerrainLaw, EachBreakChangesTheExponentOfShorterWaves) {
    TerrainModel terrain = power_law(1.1);
    terrain.breaks = {{300.0, 2.7}, {10.0, 1.9}};
    const TerrainLaw law(terrain);
    EXPECT_NEAR(log_slope(law, kTwoPi / 9000.0), -2.2, 1e-3);
    EXPECT_NEAR(log_slope(law, kTwoPi / 55.0), -5.4, 0.02);
    EXPECT_NEAR(log_slope(law, kTwoPi / 0.3), -3.8, 1e-3);
    // At a break the exponent is the mean of both sides.
    EXPECT_NEAR(log_slope(law, kTwoPi / 300.0), -3.8, 1e-2);
}

TEST(TerrainLaw, TheOuterScaleFlattensLongWaves) {
    TerrainModel terrain = power_law(2.0);
    terrain.outer_scale = 1000.0;
    const TerrainLaw law(terrain);
    const double ko = kTwoPi / 1000.0;
    EXPECT_NEAR(law.density(0.001 * ko, 0.0) * std::pow(ko, 4.0), 1.0, 1e-4);
    EXPECT_NEAR(law.density(ko, 0.0) * std::pow(ko, 4.0), 0.25, 1e-12);
    EXPECT_NEAR(log_slope(law, 100.0 * ko), -4.0, 1e-3);
}

TEST(TerrainLaw, ARidgeRaisesItsBandInItsDirection) {
    TerrainModel terrain = power_law(2.0);
    const TerrainLaw plain(terrain);
    terrain.ridge_wavelength = 100.0;
    terrain.ridge_gain = 3.0;
    terrain.ridge_width = 0.5;
    const double kr = kTwoPi / 100.0;
    const TerrainLaw all_round(terrain);
    EXPECT_NEAR(all_round.density(kr, 0.0) / plain.density(kr, 0.0), 4.0, 1e-9);
    EXPECT_NEAR(
        all_round.density(0.0, std::sqrt(2.0) * kr) / plain.density(0.0, std::sqrt(2.0) * kr),
        1.0 + 3.0 * std::exp(-0.5), 1e-9);
    terrain.ridge_direction = 90.0;
    const TerrainLaw turned(terrain);
    EXPECT_NEAR(turned.density(0.0, kr) / plain.density(0.0, kr), 4.0, 1e-9);
    EXPECT_NEAR(turned.density(kr, 0.0) / plain.density(kr, 0.0), 1.0, 1e-9);
}

TEST(TerrainLaw, AnisotropyIsTheRatioOfWavelengthsOfEqualDensity) {
    TerrainModel terrain = power_law(2.0);
    terrain.anisotropy = 3.0;
    terrain.direction = 30.0;
    const TerrainLaw law(terrain);
    const double along = kTwoPi * 30.0 / 360.0, across = along + kTwoPi / 4.0;
    const auto density = [&](double theta, double k) {
        return law.density(k * std::cos(theta), k * std::sin(theta));
    };
    EXPECT_NEAR(density(along, 0.3) / density(across, 0.1), 1.0, 1e-9);
    EXPECT_GT(density(along, 0.1), density(across, 0.1));
}

TEST(TerrainLaw, AWaveOfALimitsLengthStays) {
    TerrainModel terrain = power_law(2.0);
    terrain.shortest_wavelength = 10.0;
    terrain.longest_wavelength = 100.0;
    const TerrainLaw law(terrain);
    for (const double wavelength : {10.0, 100.0}) {
        EXPECT_GT(law.density(kTwoPi / wavelength, 0.0), 0.0) << wavelength;
    }
    for (const double wavelength : {9.99, 100.1}) {
        EXPECT_EQ(law.density(kTwoPi / wavelength, 0.0), 0.0) << wavelength;
    }
}

TEST(TerrainLaw, RingsAreMetAndContinueWithTheirSlope) {
    TerrainModel terrain;
    MeasuredRings rings;
    for (int i = 0; i < 12; ++i) {
        rings.wavenumber.push_back(0.01 * std::pow(2.0, 0.25 * i));
        rings.density.push_back(5.0 * std::pow(rings.wavenumber.back(), i < 6 ? -2.0 : -3.0));
    }
    terrain.rings = std::make_shared<const MeasuredRings>(rings);
    const TerrainLaw law(terrain);
    EXPECT_TRUE(law.is_absolute());
    for (std::size_t i = 0; i < rings.wavenumber.size(); ++i) {
        EXPECT_NEAR(law.density(rings.wavenumber[i], 0.0) / rings.density[i], 1.0, 1e-9);
    }
    EXPECT_NEAR(log_slope(law, 0.001), -2.0, 1e-6);
    EXPECT_NEAR(log_slope(law, 10.0), -3.0, 1e-6);
    terrain.rms = 20.0;
    EXPECT_FALSE(TerrainLaw(terrain).is_absolute());
}

TEST(TerrainLaw, TheTableOfAmplitudesIsThatOfTheLaw) {
    TerrainModel terrain = power_law(2.3);
    terrain.breaks = {{40.0, 1.2}};
    terrain.ridge_wavelength = 70.0;
    terrain.ridge_direction = 20.0;
    terrain.anisotropy = 2.0;
    const TerrainLaw law(terrain);
    const TerrainAmplitudes amplitude(law, 0.006, 6.0);
    for (double k = 0.0061; k < 5.9; k *= 1.0371) {
        for (const double theta : {0.1, 1.2, 4.0}) {
            const double kx = k * std::cos(theta), ky = k * std::sin(theta);
            EXPECT_NEAR(amplitude(kx, ky) / std::sqrt(law.density(kx, ky)), 1.0, 1e-6) << k;
        }
    }
}

TEST(TerrainTable, ListsOfNumbersAndPairsPassThroughText) {
    TerrainModel terrain;
    set_parameter(terrain, "breaks", "[[500, 2.5], [20, 1.9]]");
    EXPECT_EQ(get_parameter(terrain, "terrain.breaks"), "[[500, 2.5], [20, 1.9]]");
    set_parameter(terrain, "range", "-3, 4.5");
    EXPECT_EQ(get_parameter(terrain, "range"), "[-3, 4.5]");
    for (const char* bad : {"500", "500, 2, 3", "[[500, 9]]", "[[-1, 2]]", "[[500, x]]",
                            "[[500, nan]]", "1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1"}) {
        EXPECT_THROW(set_parameter(terrain, "breaks", bad), Error) << bad;
    }
    EXPECT_EQ(terrain.breaks.size(), 2u);
}

TEST(TerrainTable, AChangeDirtiesTheFirstStageThatReadsIt) {
    const TerrainModel before;
    const auto stage = [&](const char* name, const char* value) {
        TerrainModel after;
        set_parameter(after, name, value);
        return first_dirty_stage(before, after);
    };
    EXPECT_EQ(stage("mean", "5"), TerrainStage::offset);
    EXPECT_EQ(stage("beta", "2.5"), TerrainStage::filter);
    EXPECT_EQ(stage("seed", "7"), TerrainStage::noise);
    EXPECT_EQ(stage("beta", "2"), std::nullopt);
}

}  // namespace
}  // namespace ocean
