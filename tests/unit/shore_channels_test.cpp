// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Regions of a sea over its bed compute what their channels need, and that does not change what
// they show.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "ocean/directional_spectrum.hpp"
#include "ocean/ocean.hpp"
#include "ocean/sea_bed.hpp"
#include "shore/shore_statics.hpp"

namespace ocean {
namespace {

/// A beach that rises 1:40 to the east from 20 m of depth, under waves of 12 m/s over 150 km.
Parameters beach_sea() {
    Parameters parameters;
    parameters.grid.resolution = 128;
    parameters.grid.patch_size = 1024.0;
    parameters.water.depth = 20.0;
    WaveSystem& waves = parameters.waves.front();
    waves.spectrum = SpectrumKind::jonswap;
    waves.wind_speed = 12.0;
    waves.fetch = 150000.0;
    GivenBed given;
    given.grid = {{0.0, 0.0}, {8.0 * 128, 8.0 * 64}, {129, 65}, false};
    for (int j = 0; j < 65; ++j) {
        for (int i = 0; i < 129; ++i) {
            given.heights.push_back(static_cast<float>(std::max(-20.0, (8.0 * i - 800.0) / 40.0)));
        }
    }
    parameters.water.bed = make_sea_bed(std::move(given), parameters.water);
    return parameters;
}

TEST(ShoreChannels, HeightsHaveTheSameBitsWithAndWithoutDerivatives) {
    // From 80 m beyond the border of the bed into the surf.
    const Domain domain{{500.0, -80.0}, {300.0, 300.0}, {41, 41}, false};
    constexpr ChannelSet kPosition = {Channel::dx, Channel::dy, Channel::height};
    Ocean ocean(beach_sea());
    const Surface plain = ocean.region(4.0, domain, kPosition);
    const Surface normals = ocean.region(
        4.0, domain, {Channel::dx, Channel::dy, Channel::height, Channel::nx, Channel::whitecap});
    const Surface rates =
        ocean.region(4.0, domain, {Channel::dx, Channel::dy, Channel::height, Channel::vz});
    for (const Channel channel : {Channel::dx, Channel::dy, Channel::height}) {
        EXPECT_TRUE(std::ranges::equal(plain.channel(channel), normals.channel(channel)));
        EXPECT_TRUE(std::ranges::equal(plain.channel(channel), rates.channel(channel)));
    }
}

TEST(ShoreChannels, PartsOfARegionHaveTheBitsOfTheWhole) {
    const Domain whole{{480.0, 100.0}, {160.0, 160.0}, {81, 81}, false};
    const Domain part{{540.0, 120.0}, {80.0, 60.0}, {41, 31}, false};
    Ocean ocean(beach_sea());
    const Surface large = ocean.region(4.0, whole, Channel::height);
    const Surface small = ocean.region(4.0, part, Channel::height);
    for (std::size_t j = 0; j < 31; ++j) {
        for (std::size_t i = 0; i < 41; ++i) {
            EXPECT_EQ(small.channel(Channel::height)[j * 41 + i],
                      large.channel(Channel::height)[(j + 10) * 81 + i + 30]);
        }
    }
}

TEST(ShoreChannels, LandThatNoWaveReachesHasNoFoamOfTheOpenSea) {
    Parameters parameters = beach_sea();
    parameters.waves.front().wind_speed = 18.0;
    parameters.waves.front().wind_direction = 180.0;  // from the land
    Ocean ocean(parameters);
    // The bed is 2.5 m high at x = 900 m and rises.
    const Domain land{{900.0, 100.0}, {56.0, 300.0}, {15, 76}, false};
    const Surface map = ocean.region(4.0, land, {Channel::foam, Channel::cover, Channel::whitecap});
    for (const Channel channel : {Channel::foam, Channel::cover, Channel::whitecap}) {
        EXPECT_EQ(std::ranges::max(map.channel(channel)), 0.0f);
    }
}

// A change of the sea computes delays of those waves only that no sea before had, and shows the
// bits of a sea that is made anew; so does a sea that comes back.
TEST(ShoreStatics, AChangedSeaComputesItsNewWavesAlone) {
    Parameters parameters = beach_sea();
    double delays = 0.0;  // the share of reports
    OceanOptions options;
    options.build_progress = [&](std::string_view work, double) {
        delays += work == "coast: delays" ? 1.0 : 0.0;
    };
    Ocean ocean(parameters, options);
    const Domain domain{{500.0, 100.0}, {300.0, 300.0}, {31, 31}, false};
    const auto reports_of = [&](double wind, double direction) {
        WaveSystem& waves = parameters.waves.front();
        waves.wind_speed = wind;
        waves.wind_direction = direction;
        delays = 0.0;
        ocean.change(Sea{parameters, {}});
        const Surface changed = ocean.region(4.0, domain, Channel::height);
        const double reports = delays;
        const Surface anew = Ocean(parameters).region(4.0, domain, Channel::height);
        EXPECT_TRUE(
            std::ranges::equal(changed.channel(Channel::height), anew.channel(Channel::height)))
            << wind << " m/s to " << direction;
        return reports;
    };
    const double all = reports_of(12.0, 0.0);
    ASSERT_GT(all, 20.0);
    const double a_sector = reports_of(12.0, 40.0);
    EXPECT_GT(a_sector, 0.0);
    EXPECT_LT(a_sector, 0.5 * all) << "two of three sectors are those of before";
    EXPECT_EQ(reports_of(12.0, 0.0), 0.0);
    EXPECT_GT(reports_of(9.0, 0.0), 0.5 * all) << "other bands";
    EXPECT_EQ(reports_of(12.0, 40.0), 0.0);
    // Delays do not depend on the swash.
    parameters.water.shore.swash = Swash::off;
    EXPECT_EQ(reports_of(12.0, 40.0), 0.0);
    // They depend on the depth of the open sea.
    parameters.water.depth = 21.0;
    EXPECT_GT(reports_of(12.0, 40.0), 0.5 * all);
}

TEST(ShoreStatics, AreAsLargeAsToldAndAtMost5500KilobytesForASquareKilometreAndSector) {
    Parameters parameters = beach_sea();
    GivenBed given;
    given.grid = {{0.0, 0.0}, {1000.0, 1000.0}, {251, 251}, false};
    for (int j = 0; j < 251; ++j) {
        for (int i = 0; i < 251; ++i) {
            given.heights.push_back(std::max(-20.0f, (4.0f * static_cast<float>(i) - 900) / 40.0f));
        }
    }
    parameters.water.bed = nullptr;
    parameters.water.bed = make_sea_bed(std::move(given), parameters.water);
    const SeaBed& ground = *parameters.water.bed;
    const BedGrid bed{ground.domain, {ground.heights.begin(), ground.heights.end()}};
    const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
    const ShoreBands bands = choose_bands(spectrum, parameters);
    ThreadPool pool(1);
    const auto delays = make_shore_delays(bed, bands, parameters.water, pool);
    const auto energy = make_shore_energy(bed, *delays, spectrum, parameters.water, pool);
    std::size_t bytes =
        delays->ground.bytes() + energy->breaking.bytes() + energy->remainder.bytes();
    for (const PairDelays& waves : delays->waves) bytes += waves.maps->bytes();
    for (const QuadGrid& amplitudes : energy->amplitudes) bytes += amplitudes.bytes();
    std::set<int> sectors;
    for (const ShoreWaves& waves : bands.waves) sectors.insert(waves.sector);
    ASSERT_GE(sectors.size(), 3u);
    EXPECT_LE(static_cast<double>(bytes) / static_cast<double>(sectors.size()), 5.5e6);
    EXPECT_LE(bytes, shore_statics_bytes(ground.domain, bands.waves.size()));
}

}  // namespace
}  // namespace ocean
