// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The division of a sea into bands and sectors: that it is a partition, and that the variances of
// its pairs are those of the spectrum.
#include "coast/statics/shore_bands.hpp"

#include <set>

#include "ocean/internal/cascades.hpp"
#include "ocean/internal/dispersion.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

constexpr double kDegree = kTwoPi / 360.0;

/// Returns a sea of the density 1 m^2 s/rad^2 from omega = low to high, in all directions.
DirectionalSpectrum even_sea(double low, double high) {
    constexpr int kDirections = 8;
    const std::size_t size = 2 * DirectionalSpectrum::row_size(kDirections);
    auto density = std::make_shared<double[]>(size);
    std::fill_n(density.get(), size, 1.0);
    return {{low, high}, kDirections, density, {kTwoPi, kTwoPi}};
}

/// The outer edges lie on a lattice of an eighth of an octave.
const double kEdgeLattice = std::exp2(0.125);

double variance_of(const ShoreBands& bands) {
    double sum = 0.0;
    for (const ShoreWaves& waves : bands.waves) sum += waves.variance;
    return sum;
}

std::set<int> sectors_of(const ShoreBands& bands) {
    std::set<int> sectors;
    for (const ShoreWaves& waves : bands.waves) sectors.insert(waves.sector);
    return sectors;
}

// Each direction is in the sector whose centre is nearest; the lower edge belongs to a sector, the
// upper one to the next, and whole turns change nothing.
TEST(ShoreBands, ADirectionIsInOneSector) {
    for (int degree = -720; degree <= 720; ++degree) {
        const int sector = ShoreBands::sector_of((degree + 0.5) * kDegree);
        ASSERT_GE(sector, 0);
        ASSERT_LT(sector, kShoreSectors);
        const double beside = (degree + 0.5) * kDegree - sector_centre(sector);
        EXPECT_LT(std::abs(std::remainder(beside, kTwoPi)), 0.5 * kSectorWidth) << degree;
    }
    EXPECT_EQ(ShoreBands::sector_of(0.0), 0);
    EXPECT_EQ(ShoreBands::sector_of(-1e-300), 0);
    EXPECT_EQ(ShoreBands::sector_of(kPi), 5);
    EXPECT_EQ(ShoreBands::sector_of(-kPi), 5);
}

// A wavenumber is in the band between whose edges it lies; an edge belongs to the band above it.
TEST(ShoreBands, AWavenumberIsInOneBand) {
    ShoreBands bands;
    bands.edges = {1.0, 2.0, 4.0, 8.0, 16.0};
    const double below = std::nextafter(1.0, 0.0);
    EXPECT_EQ(bands.band_of(below), -1);
    EXPECT_EQ(bands.band_of(std::nan("")), -1);
    for (int b = 0; b < kShoreBands; ++b) {
        const double low = bands.edges[static_cast<std::size_t>(b)];
        EXPECT_EQ(bands.band_of(low), b);
        EXPECT_EQ(bands.band_of(2.0 * low * below), b);
        EXPECT_EQ(bands.centre(b), 1.5 * low);
    }
    EXPECT_EQ(bands.band_of(16.0), -1);
}

// The variance of a pair is the integral of the spectrum over it: of an even sea the area, 40
// degrees times the difference of the frequencies of its edges.
TEST(ShoreBands, AnEvenSeaHasPairsInProportionToTheirArea) {
    Parameters parameters;
    parameters.grid.resolution = 512;
    parameters.grid.patch_size = 300.0;
    const ShoreBands bands = choose_bands(even_sea(0.5, 1.0), parameters);
    ASSERT_EQ(bands.waves.size(), static_cast<std::size_t>(kShoreBands * kShoreSectors));
    const Dispersion dispersion(parameters.water);
    for (std::size_t i = 0; i < bands.waves.size(); ++i) {
        const ShoreWaves& waves = bands.waves[i];
        EXPECT_EQ(bands.find(waves.band, waves.sector), static_cast<int>(i));
        EXPECT_EQ(waves.sector * kShoreBands + waves.band, static_cast<int>(i));  // their order
        const auto b = static_cast<std::size_t>(waves.band);
        const double width = std::min(dispersion.angular_frequency(bands.edges[b + 1]), 1.0) -
                             std::max(dispersion.angular_frequency(bands.edges[b]), 0.5);
        EXPECT_NEAR(waves.variance, width * kSectorWidth, 1e-10);
    }
    // 2e-4 of the frequencies lie below this wavenumber.
    const double lowest = dispersion.wavenumber(0.5 + 2e-4 * 0.5);
    EXPECT_LE(bands.edges.front(), lowest);
    EXPECT_GT(bands.edges.front(), lowest / kEdgeLattice);
    EXPECT_GE(bands.edges.back(), dispersion.wavenumber(1.0));
    EXPECT_LT(bands.edges.back(), dispersion.wavenumber(1.0) * kEdgeLattice);
}

// A wind sea: four bands of one ratio, below which at most 2e-4 of the variance is; what the pairs
// lack are pairs of less than half a percent.
TEST(ShoreBands, AWindSeaIsDividedWhereItsVarianceIs) {
    for (const double depth : {std::numeric_limits<double>::infinity(), 12.0}) {
        Parameters parameters = test::wind_sea(512, 1024.0, {.depth = depth});
        const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
        const ShoreBands bands = choose_bands(spectrum, parameters);
        const double whole = spectrum.variance(parameters.water);
        const double lowest = bands.edges.front();
        EXPECT_LE(spectrum.variance(parameters.water, kTwoPi / lowest), 2e-4 * whole);
        EXPECT_GT(spectrum.variance(parameters.water, kTwoPi / (lowest * kEdgeLattice)),
                  2e-4 * whole);
        const double nyquist = kPi * 512 / 1024.0;
        EXPECT_DOUBLE_EQ(bands.edges.back(), std::min(80.0 * lowest, nyquist));
        for (std::size_t b = 1; b < kShoreBands; ++b) {
            EXPECT_NEAR(bands.edges[b + 1] / bands.edges[b], bands.edges[1] / lowest, 1e-12);
        }
        const double within =
            spectrum.variance(parameters.water, kTwoPi / bands.edges.back(), kTwoPi / lowest);
        const auto missing = static_cast<double>(36 - bands.waves.size());
        EXPECT_LE(variance_of(bands), within * (1.0 + 1e-12));
        EXPECT_GE(variance_of(bands), within - missing * 0.005 * whole);
        EXPECT_GE(variance_of(bands), 0.9 * whole);
        for (const ShoreWaves& waves : bands.waves) EXPECT_GE(waves.variance, 0.005 * whole);
    }
}

// Waves that the grid or the limits of the surface leave out are in no band.
TEST(ShoreBands, BandsEndWhereTheWavesEnd) {
    Parameters parameters = test::wind_sea(64, 400.0);
    const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
    EXPECT_DOUBLE_EQ(choose_bands(spectrum, parameters).edges.back(), kPi * 64 / 400.0);
    parameters.grid.cascades = 2;
    EXPECT_DOUBLE_EQ(choose_bands(spectrum, parameters).edges.back(),
                     std::min(80.0 * choose_bands(spectrum, parameters).edges.front(),
                              kPi * 64 / 400.0 * cascade_divisors(parameters.grid).back()));
    parameters.surface.shortest_wavelength = 20.0;
    parameters.surface.longest_wavelength = 80.0;
    const ShoreBands limited = choose_bands(spectrum, parameters);
    EXPECT_GE(limited.edges.back(), kTwoPi / 20.0);
    EXPECT_LT(limited.edges.back(), kTwoPi / 20.0 * kEdgeLattice);
    EXPECT_GT(limited.edges.front(), kTwoPi / 80.0 / kEdgeLattice);
    // A patch too small for any of the waves:
    parameters.surface = {};
    parameters.grid.cascades = 1;
    parameters.grid.resolution = 32;
    parameters.grid.patch_size = 32 * kPi * 1e4;
    EXPECT_TRUE(choose_bands(spectrum, parameters).waves.empty());
}

// A sea that changes a little keeps the edges in every bit: those of the delays that are computed
// already.
TEST(ShoreBands, EdgesStayWhileTheSeaChangesALittle) {
    Parameters parameters = test::wind_sea(256, 1000.0, {.depth = 20.0});
    const auto edges_at = [&](double wind) {
        parameters.waves.front().wind_speed = wind;
        return choose_bands(make_directional_spectrum(parameters), parameters).edges;
    };
    int changes = 0;
    std::array<double, kShoreBands + 1> before = edges_at(10.0);
    for (double wind = 10.1; wind < 14.0; wind += 0.1) {
        const auto edges = edges_at(wind);
        changes += edges == before ? 0 : 1;
        before = edges;
    }
    EXPECT_LE(changes, 10);  // an octave of wavenumbers, of 40 winds
    parameters.waves.front().significant_wave_height = 1.0;
    const auto low = edges_at(12.0);
    parameters.waves.front().significant_wave_height = 3.7;
    EXPECT_EQ(edges_at(12.0), low) << "a height alone moves no edge";
}

TEST(ShoreBands, AFlatSeaHasNone) {
    Parameters parameters = test::wind_sea();
    EXPECT_TRUE(choose_bands(DirectionalSpectrum(), parameters).waves.empty());
    parameters.waves.front().significant_wave_height = 0.0;
    const ShoreBands bands = choose_bands(make_directional_spectrum(parameters), parameters);
    EXPECT_TRUE(bands.waves.empty());
    EXPECT_EQ(bands.band_of(0.1), -1);
}

// A swell that crosses the wind sea has pairs of its own, towards its own direction.
TEST(ShoreBands, ASwellAcrossTheWindHasItsOwnSectors) {
    Parameters parameters = test::wind_sea(256, 800.0, {.direction = 0.0});
    WaveSystem& swell = parameters.waves.emplace_back();
    swell.spectrum = SpectrumKind::jonswap;
    swell.spreading = SpreadingKind::hasselmann;
    swell.swell = 1.0;
    swell.significant_wave_height = 1.5;
    swell.peak_period = 9.0;
    swell.wind_direction = 160.0;
    const ShoreBands bands = choose_bands(make_directional_spectrum(parameters), parameters);
    const std::set<int> sectors = sectors_of(bands);
    EXPECT_TRUE(sectors.contains(0));
    EXPECT_TRUE(sectors.contains(4));
    EXPECT_FALSE(sectors.contains(6));
    EXPECT_GE(variance_of(bands),
              0.9 * make_directional_spectrum(parameters).variance(parameters.water));
}

/// Returns the integral of the density over a pair by the midpoints of 200 x 200 cells.
double integral_over(const DirectionalSpectrum& spectrum, const ShoreBands& bands,
                     const ShoreWaves& waves, const Dispersion& dispersion) {
    constexpr int kCells = 200;
    const auto b = static_cast<std::size_t>(waves.band);
    const double low = dispersion.angular_frequency(bands.edges[b]);
    const double width = dispersion.angular_frequency(bands.edges[b + 1]) - low;
    double sum = 0.0;
    for (const auto [j, i] : test::pairs(kCells, kCells)) {
        const double theta =
            sector_centre(waves.sector) + ((j + 0.5) / kCells - 0.5) * kSectorWidth;
        sum += spectrum.density(low + width * (i + 0.5) / kCells, theta);
    }
    return sum * width * kSectorWidth / (kCells * kCells);
}

// A measured sea of 40 bins that travels to the north: its variances are the integrals of its
// density, most of it within 60 .. 100 degrees.
TEST(ShoreBands, AMeasuredSeaIsDividedLikeAnyOther) {
    auto record = std::make_shared<SpectrumRecord>();
    for (int i = 0; i < 40; ++i) {
        const double f = 0.05 + 0.005 * i;
        record->frequency.push_back(f);
        record->density.push_back(5.0 * std::exp(-std::pow((f - 0.1) / 0.02, 2.0)));
        record->a1.push_back(0.0);
        record->b1.push_back(0.9);
        record->a2.push_back(-0.7);
        record->b2.push_back(0.0);
    }
    Parameters parameters;
    parameters.grid.resolution = 256;
    parameters.grid.patch_size = 1000.0;
    WaveSystem& system = parameters.waves.front();
    system.spectrum = SpectrumKind::measured;
    system.measured = record;
    const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
    const ShoreBands bands = choose_bands(spectrum, parameters);
    const Dispersion dispersion(parameters.water);
    double north = 0.0;
    for (const ShoreWaves& waves : bands.waves) {
        EXPECT_NEAR(waves.variance, integral_over(spectrum, bands, waves, dispersion),
                    2e-3 * waves.variance);
        if (waves.sector == 2) north += waves.variance;
    }
    EXPECT_GE(variance_of(bands), 0.9 * spectrum.variance(parameters.water));
    EXPECT_GE(north, 0.5 * variance_of(bands));
    // The end of the record is the end of the bands.
    EXPECT_LE(bands.edges.back(), dispersion.wavenumber(kTwoPi * 0.2451) * kEdgeLattice);
}

}  // namespace
}  // namespace ocean
