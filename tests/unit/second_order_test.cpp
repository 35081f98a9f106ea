// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A surface of second order: pairs of waves bind the waves that its kernels say, and the sea has
// the skewness of theory.
#include "ocean/internal/second_order.hpp"

#include "ocean/internal/gauge_series.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/parameter_table.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

Parameters second_order_sea(int resolution = 128, double patch_size = 500.0,
                            const test::SeaChanges& changes = {.wind = 12.0}) {
    Parameters parameters = test::wind_sea(resolution, patch_size, changes);
    parameters.surface.second_order = true;
    return parameters;
}

TEST(SecondOrder, KernelsHaveTheirLimits) {
    for (const auto pair_of : {bound_pair_of_theory, bound_pair_of_products}) {
        // A wave with itself is Stokes' k a^2 / 2; two of one direction bind min(k1, k2) in all.
        EXPECT_NEAR(pair_of(0.3, 0.3, 1.0).sum, 0.3, 1e-12);
        EXPECT_NEAR(pair_of(0.3, 0.3, 1.0).difference, 0.0, 1e-12);
        const BoundPair along = pair_of(0.1, 0.4, 1.0);
        EXPECT_NEAR(along.sum, 0.25, 1e-12);
        EXPECT_NEAR(along.difference, -0.15, 1e-12);
        EXPECT_NEAR(pair_of(0.4, 0.1, 1.0).sum, along.sum, 1e-12);
        // A short wave on a long one is moved by it.
        EXPECT_NEAR(pair_of(1e-4, 1.0, 0.6).sum, 0.3, 3e-3);
    }
    // Standing waves bind k / 2 a^2 cos 2 psi of place alone [Longuet-Higgins 1963b].
    EXPECT_NEAR(bound_pair_of_theory(0.3, 0.3, -1.0).difference, 0.3, 1e-12);
}

/// A sea of three waves on the lattice of 500 m.
struct ThreeWaves {
    struct Wave {
        int n, m;
        std::complex<float> h0;
    };
    static constexpr std::array<Wave, 3> kWaves = {
        {{6, 1, {0.4f, 0.1f}}, {9, -4, {-0.1f, 0.3f}}, {-2, 11, {0.2f, 0.2f}}}};
    static constexpr double kStep = kTwoPi / 500.0;

    Modes modes;
    ThreeWaves() {
        modes = test::modes_of(second_order_sea(128, 500.0));
        CascadeModes& cascade = modes.cascades.front();
        std::ranges::fill(cascade.h0, 0.0f);
        for (const Wave& wave : kWaves) {
            cascade.h0[mode_index(wave.n, wave.m, 128)] = wave.h0;
        }
    }

    /// Height, slopes and rate of the bound waves by the sum over pairs.
    std::array<double, 4> bound(double choppiness, double x, double y, double t) const {
        std::array<double, 4> sum{};
        for (const Wave& a : kWaves) {
            for (const Wave& b : kWaves) {
                const State u = state(a, x, y, t);
                const State v = state(b, x, y, t);
                const double cosine = (u.kx * v.kx + u.ky * v.ky) / (u.k * v.k);
                const BoundPair pair = bound_pair_of_products(u.k, v.k, cosine);
                const double moved = 0.5 * choppiness * (u.k + v.k) * cosine;
                for (const double sign : {-1.0, 1.0}) {
                    const double kernel = (sign > 0.0 ? pair.sum : pair.difference) - sign * moved;
                    const double factor = 0.5 * u.amplitude * v.amplitude * kernel;
                    const double phase = u.phase + sign * v.phase;
                    sum[0] += factor * std::cos(phase);
                    sum[1] -= factor * std::sin(phase) * (u.kx + sign * v.kx);
                    sum[2] -= factor * std::sin(phase) * (u.ky + sign * v.ky);
                    sum[3] += factor * std::sin(phase) * (u.omega + sign * v.omega);
                }
            }
        }
        return sum;
    }

  private:
    struct State {
        double kx, ky, k, omega, amplitude, phase;
    };
    State state(const Wave& wave, double x, double y, double t) const {
        const CascadeModes& cascade = modes.cascades.front();
        const std::size_t at = mode_index(wave.n, wave.m, 128);
        State s{kStep * wave.n, kStep * wave.m, 0, 0, 0, 0};
        s.k = std::hypot(s.kx, s.ky);
        s.omega = kTwoPi * (static_cast<double>(cascade.rate_high[at]) + cascade.rate_low[at]);
        s.amplitude = 2.0 * std::abs(wave.h0);
        s.phase = s.kx * x + s.ky * y - s.omega * t + std::arg(wave.h0);
        return s;
    }
};

TEST(SecondOrder, HasTheKernelsOfItsProducts) {
    const ThreeWaves sea;
    ThreeWaves linear = sea;
    linear.modes.binding_limit = 0.0;
    constexpr std::array kChannels = {Channel::height, Channel::slope_x, Channel::slope_y,
                                      Channel::vz};
    constexpr ChannelSet kAll = {Channel::height, Channel::slope_x, Channel::slope_y, Channel::vz};
    constexpr double kTime = 7.3;
    for (const double choppiness : {0.0, 1.0, 0.6}) {
        SurfaceSettings settings;
        settings.choppiness = choppiness;
        for (const int resolution : {128, 64}) {
            const Surface with = make_surface(sea.modes, settings, kTime, kAll, Backend::cpu,
                                              test::pool(), resolution);
            const Surface without = make_surface(linear.modes, settings, kTime, kAll, Backend::cpu,
                                                 test::pool(), resolution);
            for (int i = 0; i < resolution * resolution; i += 97) {
                const double x = 500.0 * (i % resolution) / resolution;
                const double y = 500.0 * (i / resolution) / resolution;
                const auto expected = sea.bound(choppiness, x, y, kTime);
                for (std::size_t c = 0; c < kChannels.size(); ++c) {
                    const auto at = static_cast<std::size_t>(i);
                    const double found = static_cast<double>(with.channel(kChannels[c])[at]) -
                                         static_cast<double>(without.channel(kChannels[c])[at]);
                    EXPECT_NEAR(found, expected[c], 2e-6)
                        << channel_info(kChannels[c]).name << " " << choppiness << " " << i;
                }
            }
        }
    }
}

TEST(SecondOrder, NormalsAreThoseOfTheRaisedSurface) {
    Ocean sea(second_order_sea(64, 200.0), {.threads = 1});
    const Surface map =
        sea.evaluate(3.0,
                     {Channel::nx, Channel::nz, Channel::slope_x, Channel::slope_y, Channel::dx_x,
                      Channel::dy_y, Channel::dx_y, Channel::jacobian},
                     64);
    for (std::size_t i = 0; i < 4096; i += 31) {
        const auto at = [&](Channel channel) {
            return static_cast<double>(map.channel(channel)[i]);
        };
        // -(tangent by y) x (tangent by x) of (x + dx, y + dy, h).
        const double xx = 1.0 + at(Channel::dx_x), yy = 1.0 + at(Channel::dy_y);
        const double xy = at(Channel::dx_y);
        const double nx = xy * at(Channel::slope_y) - yy * at(Channel::slope_x);
        const double ny = xy * at(Channel::slope_x) - xx * at(Channel::slope_y);
        const double nz = at(Channel::jacobian);
        const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
        EXPECT_NEAR(at(Channel::nx), nx / length, 1e-5);
        EXPECT_NEAR(at(Channel::nz), nz / length, 1e-5);
    }
}

/// A measured spectrum of JONSWAP systems {Hs, Tp, direction [rad], s of cos^2s}.
std::shared_ptr<const SpectrumRecord> record_of(const std::vector<std::array<double, 4>>& systems) {
    constexpr std::size_t kFrequencies = 240, kDirections = 72;
    SpectrumRecord record;
    for (std::size_t i = 0; i < kFrequencies; ++i) {
        record.frequency.push_back(0.04 * std::pow(20.0, static_cast<double>(i) / 239.0));
    }
    for (std::size_t j = 0; j < kDirections; ++j) {
        record.direction.push_back(5.0 * static_cast<double>(j));
    }
    record.density.assign(kFrequencies, 0.0);
    record.directional_density.assign(kFrequencies * kDirections, 0.0);
    for (const auto& [height, period, direction, s] : systems) {
        std::vector<double> shape, spreading;
        for (const double f : record.frequency) {
            const double q = f * period;
            const double width = (q - 1.0) / (q < 1.0 ? 0.07 : 0.09);
            shape.push_back(std::pow(q, -5.0) * std::exp(-1.25 * std::pow(q, -4.0)) *
                            std::pow(3.3, std::exp(-0.5 * width * width)));
        }
        double energy = 0.0, around = 0.0;
        for (std::size_t i = 1; i < shape.size(); ++i) {
            energy +=
                0.5 * (shape[i] + shape[i - 1]) * (record.frequency[i] - record.frequency[i - 1]);
        }
        for (const double from : record.direction) {
            const double half = 0.5 * (from * kTwoPi / 360.0 - direction);
            spreading.push_back(std::pow(std::abs(std::cos(half)), 2.0 * s));
            around += 5.0 * spreading.back();
        }
        for (std::size_t i = 0; i < kFrequencies; ++i) {
            const double density = shape[i] / energy * height * height / 16.0;
            record.density[i] += density;
            for (std::size_t j = 0; j < kDirections; ++j) {
                record.directional_density[i * kDirections + j] += density * spreading[j] / around;
            }
        }
    }
    return std::make_shared<const SpectrumRecord>(record);
}

Parameters measured_sea(const std::vector<std::array<double, 4>>& systems) {
    Parameters parameters;
    parameters.grid.resolution = 512;
    parameters.grid.patch_size = 1600.0;
    parameters.surface.second_order = true;
    parameters.waves.front().spectrum = SpectrumKind::measured;
    parameters.waves.front().measured = record_of(systems);
    return parameters;
}

// The skewness of theory is the mean of 3 m0^0.5 (K- + K+) over 2 000 000 pairs of waves drawn by
// energy from JONSWAP spectra with cos^2s spreading, with the kernels of [Sharma and Dean 1981].
TEST(SecondOrder, FiveSeasHaveTheSkewnessOfSharmaAndDean) {
    const std::pair<std::vector<std::array<double, 4>>, double> kSeas[] = {
        {{{5.0, 10.0, 0.1, 400.0}}, 0.1578},
        {{{5.0, 10.0, 0.1, 40.0}}, 0.1554},
        {{{5.0, 10.0, 0.1, 12.0}}, 0.1468},
        {{{5.0, 10.0, 0.1, 4.0}}, 0.1332},
        {{{3.5, 12.0, 0.0, 12.0}, {3.5, 8.0, 1.4, 12.0}}, 0.1316}};
    for (const auto& [systems, theory] : kSeas) {
        const Parameters parameters = measured_sea(systems);
        SeaState state;
        add_second_order(make_directional_spectrum(parameters), parameters, state);
        ASSERT_TRUE(state.second_order);
        EXPECT_NEAR(state.second_order->skewness_of_theory, theory, 0.003 * theory);
        EXPECT_NEAR(state.second_order->skewness, theory, 0.05 * theory);
        EXPECT_TRUE(state.warnings.empty());
    }
}

/// Third central moment over the 1.5th power of the second, over places in the world.
double skewness_of(const Surface& map) {
    double weight = 0.0, mean = 0.0, second = 0.0, third = 0.0;
    const auto h = map.channel(Channel::height), j = map.channel(Channel::jacobian);
    const auto each = [&](const auto& body) {
        for (std::size_t i = 0; i < h.size(); ++i) {
            body(static_cast<double>(h[i]), static_cast<double>(j[i]));
        }
    };
    each([&](double z, double area) { weight += area, mean += area * z; });
    mean /= weight;
    each([&](double z, double area) {
        second += area * (z - mean) * (z - mean);
        third += area * std::pow(z - mean, 3.0);
    });
    return third / weight / std::pow(second / weight, 1.5);
}

// Waves of a fifth of the height show second order alone. The linear surface of the same draw takes
// most of the chance out.
TEST(SecondOrder, TheSurfaceInSpaceHasThatSkewness) {
    for (const double choppiness : {0.0, 1.0}) {
        double sum = 0.0, expected = 0.0, mean = 0.0;
        constexpr int kSeeds = 6, kTimes = 4;
        for (int seed = 1; seed <= kSeeds; ++seed) {
            Parameters parameters = measured_sea({{1.0, 10.0, 0.1, 12.0}});
            parameters.grid.resolution = 256;
            parameters.grid.patch_size = 1000.0;
            parameters.seed = static_cast<std::uint32_t>(seed);
            parameters.surface.choppiness = choppiness;
            Parameters linear = parameters;
            linear.surface.choppiness = 0.0;
            linear.surface.second_order = false;
            Ocean with(parameters, {.threads = 2}), without(linear, {.threads = 2});
            if (seed == 1) expected = with.state().second_order->skewness;
            for (int i = 0; i < kTimes; ++i) {
                const ChannelSet channels = {Channel::height, Channel::jacobian};
                const Surface map = with.evaluate(100.0 * i, channels, 256);
                sum += skewness_of(map) - skewness_of(without.evaluate(100.0 * i, channels, 256));
                for (std::size_t at = 0; at < 65536; ++at) {
                    mean += static_cast<double>(map.channel(Channel::height)[at]) *
                            static_cast<double>(map.channel(Channel::jacobian)[at]);
                }
            }
        }
        EXPECT_NEAR(sum / (kSeeds * kTimes), expected, 0.05 * expected) << choppiness;
        // Still water is the mean level in space, which a linear choppy map lies 8 mm below.
        EXPECT_NEAR(mean / (kSeeds * kTimes * 65536.0), 0.0, 3e-4) << choppiness;
    }
}

TEST(SecondOrder, MapsOfAllResolutionsAndBackendsShowOneSurface) {
    Parameters parameters = second_order_sea(64, 300.0);
    // Bound waves that the coarsest map holds too.
    parameters.surface.shortest_wavelength = 30.0;
    Ocean sea(parameters, {.threads = 1}), pair(parameters, {.threads = 2});
    const ChannelSet channels = {Channel::height, Channel::nx, Channel::vz};
    const Surface map = sea.evaluate(5.0, channels, 64);
    const Surface fine = sea.evaluate(5.0, channels, 256);
    EXPECT_TRUE(test::same_bits(pair.evaluate(5.0, channels, 64), map));
    Ocean reference(parameters, {.threads = 2, .backend = Backend::dft});
    const Surface slow = reference.evaluate(5.0, channels, 64);
    for (const Channel channel : {Channel::height, Channel::nx, Channel::vz}) {
        for (std::size_t i = 0; i < 4096; ++i) {
            const float value = map.channel(channel)[i];
            EXPECT_NEAR(fine.channel(channel)[i / 64 * 4 * 256 + i % 64 * 4], value, 2e-6);
            EXPECT_NEAR(slow.channel(channel)[i], value, 5e-6);
        }
    }
}

TEST(SecondOrder, AloneHasTheBitsOfAfterOthers) {
    const Parameters parameters = second_order_sea(64, 300.0);
    const ChannelSet channels = {Channel::dx, Channel::height, Channel::ny, Channel::vz};
    Ocean alone(parameters, {.threads = 1}), after(parameters, {.threads = 1});
    after.evaluate(1.0, channels, 128);
    after.evaluate(5.0, {Channel::height}, 64);
    EXPECT_TRUE(
        test::same_bits(after.evaluate(5.0, channels, 64), alone.evaluate(5.0, channels, 64)));
    after.set("choppiness", "0.5");
    after.evaluate(5.0, channels, 64);
    after.set("choppiness", "1");
    EXPECT_TRUE(
        test::same_bits(after.evaluate(5.0, channels, 64), alone.evaluate(5.0, channels, 64)));
}

// Splines show the bound waves as well as the map does: their own error is that of the linear sea.
TEST(SecondOrder, QueriesReadTheSurfaceOfTheMaps) {
    const Parameters parameters = second_order_sea(128, 400.0);
    Parameters linear = parameters;
    linear.surface.second_order = false;
    Ocean sea(parameters, {.threads = 2}), calm(linear, {.threads = 2});
    const double height = sea.state().significant_wave_height.resolved;
    const ChannelSet channels = {Channel::dx, Channel::dy, Channel::height, Channel::nx,
                                 Channel::vz};
    const Surface map = sea.evaluate(9.0, channels, 128);
    const Surface before = calm.evaluate(9.0, channels, 128);
    std::vector<WorldPoint> places;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < 128 * 128; i += 211) {
        const auto at = [&](Channel channel) {
            return static_cast<double>(map.channel(channel)[i]);
        };
        const double step = 400.0 / 128.0;
        numbers.push_back(i);
        places.push_back({step * static_cast<double>(i % 128) + at(Channel::dx),
                          step * static_cast<double>(i / 128) + at(Channel::dy)});
    }
    const auto exact = test::query(sea, 9.0, places, {.exact = true, .foam = false});
    const auto quick = test::query(sea, 9.0, places, {.foam = false});
    const auto quick_before = test::query(calm, 9.0, places, {.foam = false});
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto of = [&](const Surface& from, Channel channel) {
            return static_cast<double>(from.channel(channel)[numbers[i]]);
        };
        const auto bound = [&](Channel channel) { return of(map, channel) - of(before, channel); };
        EXPECT_NEAR(exact[i].height, of(map, Channel::height), 1e-5 * height);
        EXPECT_NEAR(exact[i].normal[0], of(map, Channel::nx), 1e-5);
        EXPECT_NEAR(exact[i].velocity[2], of(map, Channel::vz), 1e-5 * height);
        EXPECT_NEAR(quick[i].height - quick_before[i].height, bound(Channel::height),
                    1e-5 * height);
        EXPECT_NEAR(quick[i].normal[0] - quick_before[i].normal[0], bound(Channel::nx), 2e-4);
        EXPECT_NEAR(quick[i].velocity[2] - quick_before[i].velocity[2], bound(Channel::vz),
                    1e-4 * height);
    }
}

// The first cascade binds the waves of all, and a gauge reads what a query does.
TEST(SecondOrder, CascadesAndGaugesShowTheSurface) {
    Parameters parameters = second_order_sea(64, 500.0, {.wind = 12.0, .cascades = 2});
    Parameters linear = parameters;
    linear.surface.second_order = false;
    Ocean sea(parameters, {.threads = 1}), calm(linear, {.threads = 1});
    const auto long_waves = [](Ocean& of) {
        std::vector<float> heights(256 * 256);
        const MapOutput output{heights.data(), 1, {{{Channel::height, 1.0f}}}};
        of.evaluate_cascade_into(0, 4.0, {&output, 1}, 256);
        return heights;
    };
    const auto heights = [](Ocean& of) {
        return test::values_of(of.evaluate(4.0, {Channel::height}, 256));
    };
    const auto all = heights(sea), all_linear = heights(calm);
    const auto first = long_waves(sea), first_linear = long_waves(calm);
    for (std::size_t i = 0; i < all.size(); i += 37) {
        EXPECT_NEAR(first[i] - first_linear[i], all[i] - all_linear[i], 1e-6);
    }
    Gauge gauge;
    gauge.track = {{0.0, {33.0, 44.0, -2.0}}};
    const GaugeSeries series =
        read_gauge_series(sea, {gauge}, {0.0, 1.0, 2.0}, test::pool(), [](std::size_t) {});
    const WorldPoint place{33.0, 44.0};
    for (std::size_t i = 0; i < series.times; ++i) {
        const auto at = test::query(sea, 0.5 * static_cast<double>(i), {&place, 1},
                                    {.exact = true, .foam = false});
        EXPECT_NEAR(series.elevation(0)[i], at[0].height, 1e-9);
    }
}

TEST(SecondOrder, IsRefusedWhereItIsNotKnown) {
    const auto says = [](const auto& change) {
        Parameters parameters = second_order_sea(64);
        change(parameters);
        return test::message_of([&] { validate(parameters); });
    };
    EXPECT_EQ(says([](Parameters&) {}), "");
    EXPECT_EQ(says([](Parameters& p) { p.water.depth = 30.0; }),
              "water.depth = 30 m: second order is known for deep water alone; allowed: inf with "
              "surface.second_order = true");
    EXPECT_EQ(says([](Parameters& p) { p.crests.resize(1); }),
              "surface.second_order = true: a crest on cue has the height of linear waves, and "
              "second order would raise it; allowed: false with [[crests]]");
}

}  // namespace
}  // namespace ocean
