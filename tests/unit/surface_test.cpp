// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface: direction and speed of its waves, its geometry, and the agreement of the backends.
#include "ocean/surface.hpp"
#include "ocean/internal/hull_rules.hpp"

#include <thread>

#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/make_surface.hpp"
#include "refusal.hpp"
#include "test_seas.hpp"
#include "waves/synthesis/mode_grid.hpp"

namespace ocean {
namespace {

using test::kAllChannels;

const Backend kBackends[] = {Backend::cpu, Backend::radix2, Backend::dft};

/// Value of a periodic map at sample (i, j), any integers.
float sample(const Surface& surface, Channel channel, int i, int j) {
    const int n = surface.resolution();
    return surface.channel(
        channel)[static_cast<std::size_t>((j + n) % n) * static_cast<std::size_t>(n) +
                 static_cast<std::size_t>((i + n) % n)];
}

class OneWave : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(OneWave, IsACosineThatTravelsAlongItsWavenumberInEveryBackend) {
    const auto [n, m] = GetParam();
    Parameters parameters = test::wind_sea(32, 64.0, {.depth = 4.0});
    const Modes modes = test::single_wave(parameters, n, m);
    const double kx = kTwoPi / 64.0 * n, ky = kTwoPi / 64.0 * m, k = std::hypot(kx, ky);
    const Dispersion dispersion(parameters.water);
    const double omega = dispersion.angular_frequency(k);
    const double displacement = dispersion.horizontal_displacement(k);
    const double time = 1.3;
    for (const Backend& backend : kBackends) {
        const Surface s =
            make_surface(modes, parameters.surface, time, kAllChannels, backend, test::pool());
        for (const auto& at : test::pairs(11, 11)) {
            const auto expect = [&](Channel channel, double value, double error) {
                EXPECT_NEAR(sample(s, channel, 3 * at.i, 3 * at.j), value, error)
                    << channel_info(channel).name;
            };
            const double phase = 6.0 * (kx * at.i + ky * at.j) - omega * time;
            const double c = std::cos(phase), sine = std::sin(phase);
            expect(Channel::height, c, 2e-6);
            expect(Channel::slope_x, -kx * sine, 2e-6);
            expect(Channel::slope_y, -ky * sine, 2e-6);
            expect(Channel::dx, -kx / k * displacement * sine, 4e-6);
            expect(Channel::dy, -ky / k * displacement * sine, 4e-6);
            expect(Channel::vz, omega * sine, 6e-6);
            expect(Channel::vx, omega * kx / k * displacement * c, 1e-5);
            expect(Channel::vy, omega * ky / k * displacement * c, 1e-5);
            expect(Channel::jacobian, 1.0 - k * displacement * c, 6e-6);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(AllQuadrants, OneWave,
                         testing::Values(std::pair(3, 0), std::pair(-3, 0), std::pair(0, 2),
                                         std::pair(0, -2), std::pair(4, 5), std::pair(-4, 5),
                                         std::pair(-4, -5), std::pair(4, -5), std::pair(15, 15),
                                         std::pair(-15, 1)));

TEST(Surface, BackendsAgreeWithTheDirectSumNowAndAfterElevenDays) {
    Parameters parameters = test::wind_sea(128, 400.0, {.depth = 25.0});
    Ocean judge(parameters, {.threads = 2, .backend = Backend::dft});
    for (const double time : {12.0, 1e6}) {
        const Surface exact = judge.evaluate(time, kAllChannels);
        for (const Backend& backend : {Backend::cpu, Backend::radix2}) {
            Ocean sea(parameters, {.threads = 2, .backend = backend});
            const Surface surface = sea.evaluate(time, kAllChannels);
            for (const Product& field : product_table()) {
                if (!kAllChannels.contains(field.channels[0])) continue;
                const auto channels =
                    std::span(field.channels).first(static_cast<std::size_t>(field.count));
                EXPECT_LT(test::vector_error(surface, exact, channels), 2e-6)
                    << field.name << " at " << time << " s";
            }
        }
    }
}

TEST(Surface, PhasesAreKeptForThirtyOneYears) {
    struct Bound {
        double time, height, slope;
    };
    // A time just below kLatestTime is worst: a float leaves up to 32 s of it to the low part.
    const double latest = kLatestTime - 32.3;
    const Parameters parameters = test::wind_sea(256, 100.0);  // waves down to half a metre
    Ocean judge(parameters, {.threads = 2, .backend = Backend::dft});
    Ocean sea(parameters, {.threads = 2});
    for (const Bound& bound :
         {Bound{1e8, 2e-6, 2e-6}, Bound{latest, 3e-6, 1.2e-5}, Bound{-latest, 3e-6, 1.2e-5}}) {
        const ChannelSet channels = {Channel::height, Channel::slope_x, Channel::slope_y};
        const Surface exact = judge.evaluate(bound.time, channels);
        const Surface surface = sea.evaluate(bound.time, channels);
        const auto error = [&](Channel channel) {
            return test::relative_error(surface.channel(channel), exact.channel(channel));
        };
        EXPECT_LT(error(Channel::height), bound.height) << bound.time;
        EXPECT_LT(error(Channel::slope_x), bound.slope) << bound.time;
        EXPECT_LT(error(Channel::slope_y), bound.slope) << bound.time;
    }
}

/// Returns the largest |imaginary part| of the height field over its rms, by a full complex
/// transform: 0 to rounding if the modes are Hermitian.
double imaginary_residue(const Modes& modes, double time) {
    const MapModes all = map_modes(modes, time, modes.lattice.resolution);
    auto grid = coefficient_grid<double>(all, Linear::height);
    Radix2Fft<double>(all.resolution).transform_2d(grid, FftDirection::inverse);
    double largest = 0.0, sum = 0.0;
    for (const std::complex<double>& value : grid) {
        largest = std::max(largest, std::abs(value.imag()));
        sum += value.real() * value.real();
    }
    return sum > 0.0 ? largest / std::sqrt(sum / static_cast<double>(grid.size())) : 0.0;
}

TEST(Surface, ImaginaryPartsVanish) {
    const Modes modes = test::modes_of(test::wind_sea(64));
    for (const double time : {0.0, 5.0, 1e5}) EXPECT_LT(imaginary_residue(modes, time), 1e-12);
}

TEST(Surface, AMapOfAnyResolutionIsTheSameSea) {
    Ocean sea(test::wind_sea(64), {.threads = 1});
    const Surface own = sea.evaluate(3.0, kAllChannels);
    const Surface fine = sea.evaluate(3.0, kAllChannels, 256);
    for (const auto [i, j] : test::pairs(64, 64)) {
        EXPECT_NEAR(sample(own, Channel::height, i, j), sample(fine, Channel::height, 4 * i, 4 * j),
                    3e-6);
        EXPECT_NEAR(sample(own, Channel::nx, i, j), sample(fine, Channel::nx, 4 * i, 4 * j), 1e-6);
    }
    // A coarser map holds only the modes below its Nyquist line.
    const auto coarse =
        test::coefficients(sea.evaluate(3.0, {Channel::height}, 32), Channel::height);
    const auto all = test::coefficients(own, Channel::height);
    for (const auto [n, m] : test::pairs({-15, 16}, {-15, 16})) {
        const std::complex<double> same = all[mode_index(n, m, 64)];
        EXPECT_NEAR(std::abs(coarse[mode_index(n, m, 32)] - same), 0.0, 1e-7);
    }
    for (int n = -16; n < 16; ++n) {
        EXPECT_NEAR(std::abs(coarse[mode_index(-16, n, 32)]), 0.0, 1e-7);
        EXPECT_NEAR(std::abs(coarse[mode_index(n, -16, 32)]), 0.0, 1e-7);
    }
}

TEST(Surface, NormalsAreThoseOfTheDisplacedSurface) {
    Parameters parameters = test::wind_sea(64, 400.0, {.choppiness = 1.2});
    Ocean sea(parameters, {.threads = 1});
    const Surface s = sea.evaluate(7.0, kAllChannels, 1024);
    const double step = 400.0 / 1024.0;
    double worst = 0.0, worst_area = 0.0;
    for (int j = 0; j < 1024; j += 7) {
        for (int i = 0; i < 1024; i += 7) {
            double t[2][3];
            for (int axis = 0; axis < 2; ++axis) {
                const int di = axis == 0 ? 1 : 0, dj = 1 - di;
                const Channel channels[] = {Channel::dx, Channel::dy, Channel::height};
                for (int c = 0; c < 3; ++c) {
                    t[axis][c] = (sample(s, channels[c], i + di, j + dj) -
                                  sample(s, channels[c], i - di, j - dj)) /
                                 (2.0 * step);
                }
                t[axis][axis] += 1.0;
            }
            const double n[3] = {t[0][1] * t[1][2] - t[0][2] * t[1][1],
                                 t[0][2] * t[1][0] - t[0][0] * t[1][2],
                                 t[0][0] * t[1][1] - t[0][1] * t[1][0]};
            const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            const double cosine =
                (n[0] * sample(s, Channel::nx, i, j) + n[1] * sample(s, Channel::ny, i, j) +
                 n[2] * sample(s, Channel::nz, i, j)) /
                length;
            worst = std::max(worst, std::acos(std::min(cosine, 1.0)) * 180.0 / kPi);
            worst_area = std::max(worst_area, std::abs(n[2] - sample(s, Channel::jacobian, i, j)));
        }
    }
    EXPECT_LT(worst, 0.1) << "degrees";
    EXPECT_LT(worst_area, 2e-3);
}

TEST(Surface, VelocityIsTheTimeDerivativeOfTheDisplacedPoint) {
    Parameters parameters = test::wind_sea(64, 400.0, {.choppiness = 0.8});
    Ocean sea(parameters, {.threads = 1, .backend = Backend::dft});
    const double step = 0.01;
    const ChannelSet point = {Channel::dx, Channel::dy, Channel::height};
    const Surface before = sea.evaluate(5.0 - step, point);
    const Surface after = sea.evaluate(5.0 + step, point);
    const Surface now = sea.evaluate(5.0, {Channel::vx, Channel::vy, Channel::vz});
    const std::pair<Channel, Channel> pairs[] = {
        {Channel::dx, Channel::vx}, {Channel::dy, Channel::vy}, {Channel::height, Channel::vz}};
    for (const auto& [position, velocity] : pairs) {
        for (std::size_t i = 0; i < before.channel(position).size(); i += 13) {
            const double slope =
                (static_cast<double>(after.channel(position)[i]) - before.channel(position)[i]) /
                (2.0 * step);
            EXPECT_NEAR(now.channel(velocity)[i], slope, 2e-3);
        }
    }
}

TEST(Surface, ThreadsAndOtherChannelsDoNotChangeABit) {
    Ocean one(test::wind_sea(64), {.threads = 1});
    Ocean five(test::wind_sea(64), {.threads = 5});
    const Surface all = one.evaluate(8.0, kAllChannels);
    EXPECT_TRUE(test::same_bits(five.evaluate(8.0, kAllChannels), all));
    for (const Channel channel : {Channel::height, Channel::ny, Channel::jacobian, Channel::vx}) {
        const Surface alone = one.evaluate(8.0, {channel});
        EXPECT_TRUE(test::same_bits(all, alone));
        EXPECT_FALSE(alone.has(Channel::dx));
    }
}

TEST(Surface, OddSizesAreRefusedInWords) {
    Ocean sea(test::wind_sea(64), {.threads = 1});
    for (const int resolution : {48, 16384}) {
        const auto evaluate = [&] { sea.evaluate(0.0, {Channel::height}, resolution); };
        EXPECT_EQ(test::refusal_of(evaluate).kind, ErrorKind::invalid_value) << resolution;
    }
    EXPECT_THROW(sea.evaluate(std::nan(""), {Channel::height}), Error);
}

TEST(Ocean, RedoesOnlyWhatAParameterDirties) {
    Ocean sea(test::wind_sea(64), {.threads = 1});
    const float* modes = reinterpret_cast<const float*>(sea.modes().cascades[0].h0.data());
    const double* table = sea.spectrum().table().data();
    sea.set("choppiness", "0.3");
    EXPECT_EQ(reinterpret_cast<const float*>(sea.modes().cascades[0].h0.data()), modes);
    const std::complex<float> mode = sea.modes().cascades[0].h0[70];
    sea.set("seed", "99");
    EXPECT_EQ(sea.spectrum().table().data(), table);
    EXPECT_NE(sea.modes().cascades[0].h0[70], mode);
    const double before = sea.spectrum().moments(Water{}).m0;
    sea.set("wind_speed", "12");
    EXPECT_GT(sea.spectrum().moments(Water{}).m0, before);
}

TEST(Ocean, EachParameterRunsItsOwnStagesAgainAndNoOthers) {
    const ChannelSet channels = {Channel::height, Channel::foam};
    for (const ParameterInfo& info : parameter_table()) {
        Parameters parameters =
            test::wind_sea(32, 100.0, {.spectrum = SpectrumKind::tma, .depth = 30.0});
        parameters.surface.foam_lifetime = 0.2;
        parameters.hulls.resize(1);
        parameters.hulls.front().track = std::make_shared<const HullTrack>(
            HullTrack{{{0.0, 0.0, 0.0}, {5.0, 25.0, 0.0}, {10.0, 0.0, 0.0}}, {}});
        const std::string name = info.path(0);
        if (info.key == "amplitude") parameters.waves.front().amplitude = 2.0;
        if (info.section == "crests") parameters.crests.resize(1);
        if (info.holds<&SurfaceSettings::second_order>()) {  // in deep water, without wakes
            parameters.water = {};
            parameters.hulls.clear();
        }
        if (info.type() == "text") continue;  // names of files: their contents are tested elsewhere
        const double number =
            0.25 * (3.0 * std::max(info.soft_min, info.min) + std::min(info.soft_max, info.max));
        const std::string value = info.type() == "enum"          ? std::string(info.choices()[1])
                                  : info.type() == "bool"        ? "true"
                                  : info.type() == "list"        ? "1"
                                  : info.type() == "numbers"     ? "[1, 2]"
                                  : info.type() == "wave_height" ? "0.5 Hs"
                                  : info.key == "direction" ? "20"  // the waves go to 30 degrees
                                  : info.rule == NumberRule::power_of_two ? "64"
                                  : info.key == "cascades"                ? "2"
                                  : info.key == "alignment"               ? "4"
                                  : info.type() == "int"                  ? "7"
                                                                          : to_text(number);
        Ocean sea(parameters, {.threads = 1});
        sea.evaluate(1.0, channels);
        const StageRuns before = sea.stage_runs();
        ASSERT_NE(get_parameter(parameters, name), value) << name;
        sea.set(name, value);
        sea.evaluate(1.0, channels);
        const StageRuns after = sea.stage_runs();
        const auto ran = [](int a, int b) { return b > a; };
        EXPECT_EQ(ran(before.spectrum, after.spectrum), info.dirties == Stage::spectrum) << name;
        EXPECT_EQ(ran(before.modes, after.modes), info.dirties <= Stage::modes) << name;
        EXPECT_EQ(ran(before.packing, after.packing), info.dirties <= Stage::modes) << name;
        EXPECT_EQ(ran(before.threshold, after.threshold), info.dirties <= Stage::foam) << name;
        EXPECT_EQ(ran(before.foam_ticks, after.foam_ticks), info.dirties <= Stage::foam) << name;
        EXPECT_EQ(after.surface, before.surface + 1) << name;
        EXPECT_LE(after.spectrum - before.spectrum, 1) << name;
        EXPECT_LE(after.modes - before.modes, 1) << name;
        // One of the map, and one of a foam lattice that is coarser.
        EXPECT_LE(after.threshold - before.threshold, info.key == "cascades" ? 2 : 1) << name;
    }
}

TEST(Ocean, AValueThatIsThereAlreadyRedoesNothing) {
    Ocean sea(test::wind_sea(32, 100.0), {.threads = 1});
    const ChannelSet channels = {Channel::height, Channel::foam};
    sea.evaluate(1.0, channels);
    StageRuns expected = sea.stage_runs();
    ++expected.surface;
    sea.set("wind_speed", get_parameter(sea.parameters(), "wind_speed"));
    sea.set("seed", "7");
    sea.set("seed", "1");
    sea.change(sea.sea());
    sea.evaluate(1.0, channels);
    // Only the foam had another sea for a while.
    expected.foam_ticks = sea.stage_runs().foam_ticks;
    EXPECT_EQ(sea.stage_runs(), expected);
}

TEST(Ocean, MadeFromOneRunInParallelAndChangeForThemselves) {
    using enum Channel;
    const ChannelSet channels = {height, dx, nz, whitecap};
    Ocean built(test::wind_sea(64), {.threads = 1});
    const Surface before = built.evaluate(1.0, channels);
    constexpr int kWorkers = 3;
    const auto wind = [](int worker) { return std::to_string(8 + worker); };
    std::vector<Surface> same(kWorkers), changed(kWorkers);
    std::vector<std::thread> workers;
    for (int w = 0; w < kWorkers; ++w) {
        workers.emplace_back([&, w] {
            Ocean copy(built, OceanOptions{.threads = 1});
            same[static_cast<std::size_t>(w)] = copy.evaluate(1.0, channels);
            copy.set("wind_speed", wind(w));
            changed[static_cast<std::size_t>(w)] = copy.evaluate(1.0, channels);
        });
    }
    for (std::thread& worker : workers) worker.join();
    EXPECT_TRUE(test::same_bits(built.evaluate(1.0, channels), before));
    for (int w = 0; w < kWorkers; ++w) {
        EXPECT_TRUE(test::same_bits(same[static_cast<std::size_t>(w)], before));
        Ocean alone(test::wind_sea(64), {.threads = 1});
        alone.set("wind_speed", wind(w));
        EXPECT_TRUE(
            test::same_bits(changed[static_cast<std::size_t>(w)], alone.evaluate(1.0, channels)));
    }
}

TEST(Ocean, MapsOfSeveralResolutionsArePackedOnceEach) {
    Ocean sea(test::wind_sea(128, 200.0), {.threads = 1});
    const ChannelSet channels = {Channel::height};
    const Surface fine = sea.evaluate(1.0, channels);
    const Surface coarse = sea.evaluate(1.0, channels, 32);
    const Surface again = sea.evaluate(1.0, channels);
    EXPECT_TRUE(test::same_bits(again, fine));
    sea.evaluate(2.0, channels, 32);
    EXPECT_EQ(sea.stage_runs().packing, 2);

    Ocean copy(sea, OceanOptions{.threads = 1});
    sea.set("waves.0.wind_speed", "4");
    sea.evaluate(1.0, channels, 32);
    EXPECT_EQ(sea.stage_runs().packing, 3);
    EXPECT_TRUE(test::same_bits(copy.evaluate(1.0, channels, 32), coarse));
    EXPECT_EQ(copy.stage_runs().packing, 0);
}

TEST(Ocean, RulesBetweenParametersAreCheckedBeforeTheNextAnswer) {
    Ocean sea(test::wind_sea(64), {.threads = 1});
    sea.set("shortest_wavelength", "50");
    sea.set("longest_wavelength", "20");
    EXPECT_THROW(sea.modes(), Error);
    EXPECT_THROW(sea.state(), Error);
    EXPECT_THROW(sea.evaluate(0.0, {Channel::height}), Error);
    sea.set("shortest_wavelength", "10");
    EXPECT_NO_THROW(sea.evaluate(0.0, {Channel::height}));
    // A refused value changes nothing.
    EXPECT_THROW(sea.set("grid.resolution", "100"), Error);
    EXPECT_THROW(sea.set("grid.cascades", "6"), Error);
    EXPECT_EQ(sea.parameters().grid.resolution, 64);
    EXPECT_EQ(sea.parameters().grid.cascades, 1);
}

}  // namespace
}  // namespace ocean
