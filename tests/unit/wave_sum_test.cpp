// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sum over all modes at a point: against the reference transform, against differences in time,
// and against Airy's theory of one wave at every depth.
#include "ocean/internal/wave_sum.hpp"

#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/make_surface.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

constexpr double kLoop = 60.0;

/// rms of sum - map over rms of the map, at samples on a coarse grid.
double error_at_samples(const WaveSum& sum, const Surface& map, Channel channel,
                        const std::function<double(const LinearSample&)>& value) {
    const int n = map.resolution();
    double error = 0.0, scale = 0.0;
    for (int j = 1; j < n; j += 5) {
        for (int i = 0; i < n; i += 7) {
            const double expected =
                map.channel(channel)[static_cast<std::size_t>(j) * static_cast<std::size_t>(n) +
                                     static_cast<std::size_t>(i)];
            const double found = value(sum.at_label(map.period() * i / n, map.period() * j / n));
            error += (found - expected) * (found - expected);
            scale += expected * expected;
        }
    }
    return std::sqrt(error / scale);
}

/// Maps are floats: their own rounding is 3e-8 of a value.
void expect_the_map(const WaveSum& sum, const Surface& map, double choppiness) {
    using enum Channel;
    const auto check = [&](Channel channel, const std::function<double(const LinearSample&)>& f) {
        EXPECT_LT(error_at_samples(sum, map, channel, f), 1e-6) << static_cast<int>(channel);
    };
    const double c = choppiness;
    check(height, [](const LinearSample& s) { return s.height; });
    check(dx, [c](const LinearSample& s) { return -c * s.displacement_x; });
    check(dy, [c](const LinearSample& s) { return -c * s.displacement_y; });
    check(slope_x, [](const LinearSample& s) { return s.slope_x; });
    check(slope_y, [](const LinearSample& s) { return s.slope_y; });
    check(vx, [c](const LinearSample& s) { return -c * s.displacement_x_rate; });
    check(vy, [c](const LinearSample& s) { return -c * s.displacement_y_rate; });
    check(vz, [](const LinearSample& s) { return s.height_rate; });
    check(jacobian, [c](const LinearSample& s) {
        return (1.0 - c * s.gradient_xx) * (1.0 - c * s.gradient_yy) -
               c * c * s.gradient_xy * s.gradient_xy;
    });
}

TEST(WaveSum, IsTheMapAtItsSamples) {
    for (const double depth : {std::numeric_limits<double>::infinity(), 12.0}) {
        for (const double loop : {0.0, kLoop}) {
            Parameters parameters =
                test::wind_sea(64, 300.0, {.choppiness = 0.8, .depth = depth, .loop = loop});
            const Modes modes = test::modes_of(parameters);
            for (const double time : {12.0, 1e6}) {
                const Surface map = make_surface(modes, parameters.surface, time,
                                                 test::kAllChannels, Backend::dft, test::pool());
                WaveSum sum(modes, parameters.water);
                sum.set_time(time);
                expect_the_map(sum, map, 0.8);
            }
        }
    }
}

TEST(WaveSum, ResolutionLeavesOutWhatASmallerMapDoesNotHold) {
    const Parameters parameters = test::wind_sea(128, 300.0);
    const Modes modes = test::modes_of(parameters);
    const Surface map = make_surface(modes, parameters.surface, 5.0, test::kAllChannels,
                                     Backend::dft, test::pool(), 32);
    WaveSum sum(modes, parameters.water, 32);
    sum.set_time(5.0);
    expect_the_map(sum, map, 1.0);
}

TEST(WaveSum, CascadesAddUpEachOnItsOwnLattice) {
    // The modes of a 128 lattice, those above n = 8 moved to a second cascade of a quarter period.
    const Parameters parameters = test::wind_sea(128, 300.0);
    const Modes whole = test::modes_of(parameters);
    Modes parts = whole;
    CascadeModes& coarse = parts.cascades.front();
    CascadeModes fine = coarse;
    fine.divisor = 4;
    fine.lattice.period = 75.0;
    std::fill(fine.h0.begin(), fine.h0.end(), 0.0f);
    for (const auto [n, m] : test::pairs({-15, 16}, {-15, 16})) {
        if (std::abs(n) <= 2 && std::abs(m) <= 2) continue;
        std::swap(fine.h0[mode_index(n, m, 128)], coarse.h0[mode_index(4 * n, 4 * m, 128)]);
        fine.rate_high[mode_index(n, m, 128)] = coarse.rate_high[mode_index(4 * n, 4 * m, 128)];
        fine.rate_low[mode_index(n, m, 128)] = coarse.rate_low[mode_index(4 * n, 4 * m, 128)];
        fine.displacement[mode_index(n, m, 128)] =
            coarse.displacement[mode_index(4 * n, 4 * m, 128)];
    }
    parts.cascades.push_back(fine);
    for (const int resolution : {0, 64}) {
        const WaveSum expected(whole, parameters.water, resolution);
        const WaveSum found(parts, parameters.water, resolution);
        const LinearSample a = expected.at_label(-17.3, 1234.5);
        const LinearSample b = found.at_label(-17.3, 1234.5);
        EXPECT_NEAR(b.height, a.height, 1e-12);
        EXPECT_NEAR(b.gradient_xy, a.gradient_xy, 1e-12);
        EXPECT_NEAR(b.displacement_y_rate, a.displacement_y_rate, 1e-12);
        EXPECT_NEAR(found.water_motion(3.0, 4.0, -1.0).pressure,
                    expected.water_motion(3.0, 4.0, -1.0).pressure, 1e-8);
    }
}

TEST(WaveSum, StepsLeadToTheTimeThatCanBeSet) {
    for (const double loop : {0.0, kLoop}) {
        Parameters parameters = test::wind_sea(64, 300.0, {.loop = loop});
        WaveSum stepped(test::modes_of(parameters), parameters.water);
        WaveSum set = stepped;
        stepped.set_time(1e5);
        const WaveStep step = stepped.wave_step(0.25);
        for (int i = 0; i < 200; ++i) stepped.advance(step);
        set.set_time(1e5 + 50.0);
        const LinearSample a = set.at_label(5.0, 6.0);
        const LinearSample b = stepped.at_label(5.0, 6.0);
        // A turn at 1e5 s is known to 1e-11.
        EXPECT_NEAR(b.height, a.height, 1e-9);
        EXPECT_NEAR(b.gradient_xx, a.gradient_xx, 1e-9);
        EXPECT_NEAR(b.height_rate, a.height_rate, 1e-9);
        EXPECT_NEAR(b.displacement_y_rate, a.displacement_y_rate, 1e-9);
    }
}

TEST(WaveSum, DisplacementAloneIsThatOfTheWholeSample) {
    const Parameters parameters = test::wind_sea(64, 300.0);
    WaveSum sum(test::modes_of(parameters), parameters.water);
    sum.set_time(3.0);
    const LinearSample whole = sum.at_label(11.0, 22.0);
    const DisplacementSample part = sum.displacement_at(11.0, 22.0);
    EXPECT_EQ(part.displacement_x, whole.displacement_x);
    EXPECT_EQ(part.displacement_y, whole.displacement_y);
    EXPECT_EQ(part.gradient_xx, whole.gradient_xx);
    EXPECT_EQ(part.gradient_yy, whole.gradient_yy);
    EXPECT_EQ(part.gradient_xy, whole.gradient_xy);
}

TEST(WaveSum, DisplacementRmsIsThatOfAMapInTheMeanOverTimes) {
    Parameters parameters = test::wind_sea(32, 300.0, {.depth = 10.0});
    const Modes modes = test::modes_of(parameters);
    double sum = 0.0;
    constexpr int kTimes = 200;
    for (int i = 0; i < kTimes; ++i) {
        const Surface map = make_surface(modes, parameters.surface, 37.0 * i,
                                         {Channel::dx, Channel::dy}, Backend::cpu, test::pool());
        sum += test::variance(map.channel(Channel::dx)) + test::variance(map.channel(Channel::dy));
    }
    const double expected = std::sqrt(sum / kTimes);
    EXPECT_NEAR(WaveSum(modes, parameters.water).displacement_rms(), expected, 0.02 * expected);
}

TEST(WaveSum, ALoopClosesInBits) {
    Parameters parameters = test::wind_sea(32, 300.0, {.loop = kLoop});
    WaveSum sum(test::modes_of(parameters), parameters.water);
    sum.set_time(7.5);
    const LinearSample first = sum.at_label(1.0, 2.0);
    sum.set_time(7.5 + 3.0 * kLoop);
    const LinearSample again = sum.at_label(1.0, 2.0);
    EXPECT_EQ(first.height, again.height);
    EXPECT_EQ(first.displacement_y_rate, again.displacement_y_rate);
}

/// Airy's wave h = cos(kx x - omega t) under which all is written with plain cosh and sinh.
/// [Dean and Dalrymple 1991] eq. 3.30, 3.31 and 4.24.
void expect_airy(double depth, double patch_size, int n) {
    Parameters parameters = test::wind_sea(64, patch_size, {.depth = depth});
    const double k = kTwoPi * n / patch_size;
    const double omega = Dispersion(parameters.water).angular_frequency(k);
    WaveSum sum(test::single_wave(parameters, n, 0), parameters.water);
    const double time = 2.3;
    sum.set_time(time);
    for (const double z : {0.0, -0.1 * depth, -0.5 * depth, -depth}) {
        for (const double x : {0.0, 0.3 * patch_size / n, 10.0 * patch_size}) {
            const double phase = k * x - omega * time;
            const WaterMotion motion = sum.water_motion(x, 5.0, z);
            const double along = std::cosh(k * (z + depth)) / std::sinh(k * depth);
            const double up = std::sinh(k * (z + depth)) / std::sinh(k * depth);
            const double tension = parameters.water.surface_tension * k * k;
            const double pressure =
                (1000.0 * 9.81 + tension) * std::cosh(k * (z + depth)) / std::cosh(k * depth);
            // The frequency is stored in two floats, the displacement of the sum in one.
            EXPECT_NEAR(motion.velocity_x, omega * along * std::cos(phase), 1e-6 * omega * along);
            EXPECT_NEAR(motion.velocity_z, omega * up * std::sin(phase), 1e-6 * omega * along);
            EXPECT_NEAR(motion.velocity_y, 0.0, 1e-12);
            EXPECT_NEAR(motion.pressure, pressure * std::cos(phase), 1e-6 * pressure);
        }
    }
}

TEST(WaveSum, WaterMovesAsInAirysWave) {
    expect_airy(200.0, 400.0, 4);  // deep: kd = 12.6
    expect_airy(10.0, 400.0, 4);
    expect_airy(0.5, 400.0, 4);   // shallow: kd = 0.03
    expect_airy(0.05, 0.32, 16);  // capillary waves of 2 cm
}

TEST(WaveSum, WaterKeepsItsVolume) {
    for (const double depth : {std::numeric_limits<double>::infinity(), 30.0, 3.0}) {
        Parameters parameters = test::wind_sea(64, 200.0, {.depth = depth});
        WaveSum sum(test::modes_of(parameters), parameters.water);
        sum.set_time(7.0);
        // Differences over so little that their own error is (k h)^4/30 = 1e-9.
        const double h = 0.01 / (kPi * 64 / 200.0);
        double divergence = 0.0, gradient = 0.0;
        for (int i = 0; i < 200; ++i) {
            const double x = std::fmod(i * 61.8034, 200.0);
            const double y = std::fmod(i * 32.4718, 200.0);
            const double z = -h * 3.0 - (i % 10) * 0.1 * std::min(depth - 6.0 * h, 20.0);
            const auto slope = [&](std::size_t axis) {
                const auto at = [&](double steps) {
                    std::array<double, 3> p{x, y, z};
                    p[axis] += steps * h;
                    return sum.water_motion(p[0], p[1], p[2]);
                };
                const WaterMotion a = at(-2.0), b = at(-1.0), c = at(1.0), d = at(2.0);
                const auto of = [&](double WaterMotion::*v) {
                    return (8.0 * (c.*v - b.*v) - (d.*v - a.*v)) / (12.0 * h);
                };
                return std::array{of(&WaterMotion::velocity_x), of(&WaterMotion::velocity_y),
                                  of(&WaterMotion::velocity_z)};
            };
            double trace = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto along = slope(axis);
                trace += along[axis];
                for (const double part : along) gradient += part * part;
            }
            divergence += trace * trace;
        }
        EXPECT_GT(gradient, 0.01) << "the water moves";
        EXPECT_LT(std::sqrt(divergence / gradient), 1e-6) << depth << " m";
    }
}

TEST(WaveSum, NoDepthAndNoLevelOverflows) {
    for (const double depth : {0.01, 1.0, 1e4, std::numeric_limits<double>::infinity()}) {
        Parameters parameters = test::wind_sea(64, 100.0, {.depth = depth});
        const WaveSum sum(test::modes_of(parameters), parameters.water);
        const WaterMotion still = sum.water_motion(1.0, 2.0, 0.0);
        const WaterMotion above = sum.water_motion(1.0, 2.0, 1e300);
        EXPECT_EQ(above.velocity_x, still.velocity_x) << "above z = 0 as at z = 0";
        EXPECT_EQ(above.pressure, still.pressure);
        for (const double z : {0.0, -0.005, -0.5, -100.0, -1e5, -1e300}) {
            const WaterMotion motion = sum.water_motion(1.0, 2.0, z);
            for (const double value :
                 {motion.velocity_x, motion.velocity_y, motion.velocity_z, motion.pressure}) {
                EXPECT_TRUE(std::isfinite(value)) << depth << " " << z;
                EXPECT_TRUE(z >= -depth || value == 0.0) << depth << " " << z;
            }
        }
    }
}

}  // namespace
}  // namespace ocean
