// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The swash: run-up as measured on beaches, a sheet without gaps or cliffs, sand that stays wet for
// a while.

#include <stdexcept>

#include "coast/statics/shore_bands.hpp"
#include "coast/surface/shore_surface.hpp"
#include "coast/surface/swash.hpp"
#include "field/jet.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/thread_pool.hpp"
#include "test_beds.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

constexpr double kOffshore = 14.0;  // depth before the beaches [m]

Parameters wind_sea(double speed, double fetch, double patch) {
    Parameters parameters = test::coast_sea(64, patch, kOffshore);
    parameters.waves.front().wind_speed = speed;
    parameters.waves.front().fetch = fetch;
    return parameters;
}

/// Returns a plane beach with its line of still water at x = `shore`.
auto plane_beach(double slope, double shore) {
    return [=](double x, double) { return std::max(-kOffshore, (x - shore) * slope); };
}

/// A plane beach that rises to the east, and the sea that runs up it.
struct PlaneBeach {
    double slope;
    double shore;  // x of the line of still water [m]
    BedGrid bed;
    Parameters parameters;
    ShoreStatics statics;

    PlaneBeach(double slope_of_bed, const Parameters& sea, ThreadPool& pool)
        : slope(slope_of_bed), shore(kOffshore / slope + 40.0), parameters(sea) {
        const double cell = std::max(8.0, parameters.grid.patch_size / 74.0);
        const int rows = static_cast<int>(parameters.grid.patch_size / cell) + 17;
        const int columns = static_cast<int>((shore + 4.5 / slope) / cell) + 2;
        bed = test::grid_of(columns, rows, cell, plane_beach(slope, shore));
        const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
        const ShoreBands bands = choose_bands(spectrum, parameters);
        statics.delays = make_shore_delays(bed, bands, parameters.water, pool);
        statics.energy = make_shore_energy(bed, *statics.delays, spectrum, parameters.water, pool);
    }
    /// Returns the period of the open sea's peak [s].
    double period() const { return kTwoPi / statics.energy->peak_omega; }
    /// Returns sqrt(H0 L0) of the open sea [m].
    double scale() const {
        const double length = parameters.water.gravity * period() * period() / kTwoPi;
        return std::sqrt(statics.energy->open_height * length);
    }
};

/// The heights of the water line at places along a beach through time.
struct WaterLine {
    std::vector<std::vector<double>> height;  // [place][step]
    double step;                              // [s]

    /// `waves`: the time in periods of the peak.
    WaterLine(const PlaneBeach& beach, double waves, ThreadPool& pool)
        : step(0.125 * beach.period()) {
        constexpr std::size_t places = 6;
        const DirectionalSpectrum spectrum = make_directional_spectrum(beach.parameters);
        const Modes modes = make_modes(spectrum, beach.parameters, pool);
        ShoreSurface surface(modes, beach.parameters, beach.statics, 64,
                             ShoreSurface::Rates::without, pool);
        constexpr std::size_t kLabels = 16;
        const double lowest = -0.6;
        const double rise =
            (2.2 * run_up_2_percent(beach.scale(), beach.slope) - lowest) / (kLabels - 1);
        std::vector<WorldPoint> labels;
        for (std::size_t n = 0; n < places; ++n) {
            const double y = 64.0 + beach.parameters.grid.patch_size * static_cast<double>(n) /
                                        static_cast<double>(places);
            for (std::size_t k = 0; k < kLabels; ++k) {
                const double z = lowest + rise * static_cast<double>(k);
                labels.push_back({beach.shore + z / beach.slope, y});
            }
        }
        const std::vector<SurfLabels> surf = find_surf(surface, labels, pool);
        std::vector<float> depths(labels.size());
        height.resize(places);
        for (double time = 0.0; time < waves * beach.period(); time += step) {
            surface.move_to(time, ShoreSurface::Rates::without, pool);
            // Land that no wave reaches is dry.
            std::ranges::fill(depths, -1.0f);
            for (const SurfLabels& piece : surf) {
                std::vector<float> foam(piece.size()), found(piece.size());
                surface.read_surf(piece, foam, found);
                for (std::size_t i = 0; i < piece.size(); ++i) depths[piece.index[i]] = found[i];
            }
            for (std::size_t n = 0; n < places; ++n) {
                const float* const depth = depths.data() + n * kLabels;
                const std::size_t dry = static_cast<std::size_t>(
                    std::find_if(depth, depth + kLabels, [](float d) { return d <= 0.0f; }) -
                    depth);
                if (dry == kLabels) throw std::runtime_error("the sea floods the beach");
                double z = lowest;
                if (dry > 0) {
                    const double wet = static_cast<double>(depth[dry - 1]);
                    const double over = wet / (wet - static_cast<double>(depth[dry]));
                    z += rise * (static_cast<double>(dry - 1) + over);
                }
                height[n].push_back(z);
            }
        }
    }
    /// Returns the height that 2 % of the run-ups exceed: the maxima between upward crossings of
    /// the mean line.
    double exceeded_by_2_percent() const {
        double mean = 0.0;
        for (const auto& line : height) {
            for (const double z : line) mean += z;
        }
        mean /= static_cast<double>(height.size() * height.front().size());
        std::vector<double> highest;
        for (const auto& line : height) {
            bool begun = false;
            double top = 0.0;
            for (std::size_t i = 1; i < line.size(); ++i) {
                if (line[i - 1] < mean && line[i] >= mean) {
                    if (begun) highest.push_back(top);
                    begun = true;
                    top = line[i];
                }
                top = std::max(top, line[i]);
            }
        }
        std::sort(highest.begin(), highest.end());
        return highest[static_cast<std::size_t>(0.98 * static_cast<double>(highest.size() - 1))];
    }
    /// Returns the greatest speed of the line along a beach of that slope [m/s], of its way up if
    /// `sign` is 1, and down if it is -1.
    double fastest(double slope, double sign) const {
        double most = 0.0;
        for (const auto& line : height) {
            for (std::size_t i = 1; i < line.size(); ++i) {
                most = std::max(most, sign * (line[i] - line[i - 1]) / slope / step);
            }
        }
        return most;
    }
};

struct Wind {
    double speed, fetch;
    double patch;  // six lengths of the peak's waves [m]
};

class RunUp : public testing::TestWithParam<Wind> {};

TEST_P(RunUp, HasTheMeasuredTwoPercentHeightAndNoRacingTip) {
    const Parameters sea = wind_sea(GetParam().speed, GetParam().fetch, GetParam().patch);
    for (const double per_rise : {10.0, 15.0, 30.0, 60.0}) {
        const PlaneBeach beach(1.0 / per_rise, sea, test::pool());
        // On flat beaches a run-up takes the time of several waves.
        const WaterLine line(beach, 20.0 + 0.8 * per_rise, test::pool());
        const double measured = run_up_2_percent(beach.scale(), beach.slope);
        const double ratio = line.exceeded_by_2_percent() / measured;
        EXPECT_NEAR(ratio, 1.0, 0.2) << "1:" << per_rise;
        EXPECT_LE(line.fastest(beach.slope, 1.0), 15.0) << "1:" << per_rise;
    }
}

// Significant heights of 1.6, 3.0 and 6.6 m.
INSTANTIATE_TEST_SUITE_P(Seas, RunUp,
                         testing::Values(Wind{9.0, 8e4, 270.0}, Wind{12.0, 1.5e5, 512.0},
                                         Wind{16.0, 4e5, 1180.0}));

// ---- the sheet

TEST(Sheet, JoinsBedAndWaterInOneSmoothLine) {
    EXPECT_EQ(sheet_depth(0.0), 0.0);
    double before = sheet_depth(-1.001);
    for (double e = -1.0; e <= 1.0; e += 0.001) {
        const double depth = sheet_depth(e);
        EXPECT_GT(depth, before) << "rises with the run-up";
        EXPECT_LE(depth - before, 0.00201) << "at most twice as steeply";
        EXPECT_NEAR(depth, e, 0.4 * kSheet) << "and stays near it";
        EXPECT_GE(std::abs(depth), std::abs(e)) << "on its own side of the bed";
        before = depth;
    }
}

TEST(Sheet, HasTheDerivativesOfItsJets) {
    const RunUpSea sea{2.0, 80.0, true};
    const auto surface = [&](auto bed, auto re) {
        using Real = decltype(bed);
        const SwashPlace<Real> place{bed, Real(0.06), Real(0.9), Real(0.4), Real(0.4)};
        return swash_surface(sea, place, {re, Real(0.1), Real(0.06)}, Real(0.8) * re);
    };
    for (const double bed : {-1.2, -0.6, -0.1, 0.05, 0.3, 0.9}) {
        for (const double re : {-0.3, 0.01, 0.2, 0.5}) {
            constexpr double kStep = 1e-5;
            const auto jets = surface(Jet(static_cast<float>(bed), 1.0f, 0.0f),
                                      Jet(static_cast<float>(re), 0.0f, 1.0f));
            const auto here = surface(bed, re);
            EXPECT_NEAR(static_cast<double>(jets.height.value()), here.height, 1e-6);
            const double by_bed =
                (surface(bed + kStep, re).height - surface(bed - kStep, re).height) / (2.0 * kStep);
            const double by_re =
                (surface(bed, re + kStep).height - surface(bed, re - kStep).height) / (2.0 * kStep);
            EXPECT_NEAR(static_cast<double>(jets.height.by_x()), by_bed, 1e-4);
            EXPECT_NEAR(static_cast<double>(jets.height.by_y()), by_re, 1e-4);
            const auto single = surface(static_cast<float>(bed), static_cast<float>(re));
            EXPECT_NEAR(static_cast<double>(single.displaced), here.displaced, 1e-6);
        }
    }
}

// ---- regions

constexpr double kSlope = 1.0 / 15.0;
constexpr double kShore = kOffshore / kSlope + 40.0;  // x of the line of still water [m]

Parameters swash_sea(double loop = 0.0, Swash swash = Swash::on) {
    Parameters parameters = wind_sea(9.0, 8e4, 270.0);
    parameters.time.loop_period = loop;
    parameters.water.shore.swash = swash;
    return test::over(parameters, test::bed_of(50, 41, 8.0, plane_beach(kSlope, kShore)));
}

/// The swash along 40 m of the beach.
Domain swash_domain(double cell) {
    const int columns = static_cast<int>(60.0 / cell) + 1, rows = static_cast<int>(40.0 / cell) + 1;
    return {
        {kShore - 30.0, 140.0}, {(columns - 1) * cell, (rows - 1) * cell}, {columns, rows}, false};
}

constexpr Channel kDepth = channel_of(LandMask::depth);
constexpr Channel kWetness = channel_of(LandMask::wetness);

TEST(Swash, SurfaceHasNoCliffAndADryPartUnderTheSand) {
    Ocean ocean(swash_sea());
    constexpr double kCell = 0.5;
    const Domain domain = swash_domain(kCell);
    bool wet_land = false, dry_land = false;
    for (const double time : {4.0, 9.0}) {
        const Surface map = ocean.region(time, domain, {kDepth, Channel::dx});
        const std::span<const float> depth = map.channel(kDepth);
        const auto columns = static_cast<std::size_t>(domain.samples[0]);
        for (std::size_t n = 0; n < domain.count(); ++n) {
            const double x = domain.place(static_cast<int>(n % columns), 0)[0];
            const double bed = (x - kShore) * kSlope;
            if (n % columns > 0 && bed > -0.3) {
                // The film is at most twice as steep as bed and run-up together, waves of the
                // swash half as steep as the beach.
                EXPECT_LE(std::abs(depth[n] - depth[n - 1]), 3.0 * kSlope * kCell);
            }
            if (bed < 0.0) continue;
            EXPECT_EQ(map.channel(Channel::dx)[n], 0.0f) << "sand is where its label is";
            wet_land = wet_land || depth[n] > 0.05f;
            dry_land = dry_land || depth[n] < -0.05f;
        }
    }
    EXPECT_TRUE(wet_land);
    EXPECT_TRUE(dry_land);
}

TEST(Swash, WithoutItTheSurfaceEndsAtTheLineOfStillWater) {
    Ocean ocean(swash_sea(0.0, Swash::off));
    const Domain domain = swash_domain(1.0);
    for (const double time : {4.0, 9.0}) {
        const Surface map = ocean.region(time, domain, {kDepth, kWetness});
        for (std::size_t n = 0; n < domain.count(); ++n) {
            const auto i = static_cast<int>(n % static_cast<std::size_t>(domain.samples[0]));
            const double bed = (domain.place(i, 0)[0] - kShore) * kSlope;
            if (std::abs(bed) < 1e-3) continue;
            const auto depth = static_cast<double>(map.channel(kDepth)[n]);
            if (bed > 0.0) {
                EXPECT_NEAR(depth, -bed, 1e-4);
                EXPECT_EQ(map.channel(kWetness)[n], 0.0f);
            } else if (bed > -0.2) {
                EXPECT_GT(depth, 0.0);
            }
        }
    }
}

TEST(Wetness, FadesFromTheLastRunUpAndNeverExceedsOne) {
    Ocean ocean(swash_sea(24.0));
    const Domain domain = swash_domain(2.0);
    std::vector<float> before;
    int fading = 0, covered = 0;
    for (int tick = 0; tick < 16; ++tick) {
        const Surface map = ocean.region(tick, domain, {kWetness, kDepth});
        const std::span<const float> wet = map.channel(kWetness);
        for (std::size_t n = 0; n < wet.size(); ++n) {
            EXPECT_GE(wet[n], 0.0f);
            EXPECT_LE(wet[n], 1.0f);
            if (map.channel(kDepth)[n] > 0.05f) {
                EXPECT_EQ(wet[n], 1.0f);
                ++covered;
            } else if (!before.empty() && map.channel(kDepth)[n] < -0.01f) {
                const double past = static_cast<double>(before[n]);
                EXPECT_LE(wet[n], before[n]) << "dry sand dries";
                EXPECT_GE(static_cast<double>(wet[n]), past * std::exp(-1.0 / 25.0) - 1e-4);
                if (wet[n] < before[n]) ++fading;
            }
        }
        before.assign(wet.begin(), wet.end());
    }
    EXPECT_GT(fading, 100);
    EXPECT_GT(covered, 100);
}

TEST(Wetness, ClosesItsLoopAndHasTheSameBitsForAnyNumberOfThreads) {
    const Domain domain = swash_domain(2.0);
    const ChannelSet channels = {kWetness, kDepth, Channel::foam};
    Ocean one(swash_sea(8.0), {.threads = 1});
    Ocean three(swash_sea(8.0), {.threads = 3});
    const Surface map = one.region(5.5, domain, channels);
    EXPECT_TRUE(test::same_bits(three.region(13.5, domain, channels), map));
    EXPECT_TRUE(test::same_bits(three.region(5.5, domain, channels), map));
}

TEST(Wetness, SandIsDampUpToTheTwoPercentRunUp) {
    EXPECT_EQ(damp_of(0.0f, 1.2f), 0.5f);
    EXPECT_GT(damp_of(1.0f, 1.2f), 0.0f);
    EXPECT_EQ(damp_of(1.2f, 1.2f), 0.0f);
    EXPECT_EQ(damp_of(0.0f, 0.0f), 0.0f) << "no waves, no damp sand";
    Ocean ocean(swash_sea(8.0));
    const Domain domain = swash_domain(2.0);
    const Surface map = ocean.region(3.0, domain, kWetness);
    // Hs 1.62 m, Tp 5.4 s: sqrt(H0 L0) = 8.6 m, of which directions off the shore lose a little.
    const double highest = run_up_2_percent(8.6, kSlope);
    for (std::size_t n = 0; n < domain.count(); ++n) {
        const auto i = static_cast<int>(n % static_cast<std::size_t>(domain.samples[0]));
        const double bed = (domain.place(i, 0)[0] - kShore) * kSlope;
        if (bed > 0.0 && bed < 0.4 * highest) {
            EXPECT_GE(map.channel(kWetness)[n], 0.45f);
        }
        // No run-up is half as high again.
        if (bed > 1.5 * highest) {
            EXPECT_EQ(map.channel(kWetness)[n], 0.0f);
        }
    }
}

TEST(Wetness, FoamMarksTheWaterLine) {
    // Behind the tip, from a quarter of a metre of depth on, there is none of the tip's foam.
    EXPECT_EQ(tip_foam(-0.01f, 0.1f, 1.0f), 0.0f);
    EXPECT_GT(tip_foam(0.06f, 0.1f, 1.0f), 0.7f);
    EXPECT_EQ(tip_foam(0.25f, 0.1f, 1.0f), 0.0f);
    Ocean ocean(swash_sea());
    const Domain domain = swash_domain(1.0);
    const Surface map = ocean.region(9.0, domain, {kDepth, channel_of(LandMask::breaking)});
    int marked = 0;
    for (std::size_t n = 1; n < domain.count(); ++n) {
        const bool tip = map.channel(kDepth)[n - 1] > 0.02f && map.channel(kDepth)[n] <= 0.0f;
        if (tip) marked += map.channel(channel_of(LandMask::breaking))[n - 1] > 0.3f ? 1 : 0;
    }
    EXPECT_GT(marked, 20);
}

}  // namespace
}  // namespace ocean
