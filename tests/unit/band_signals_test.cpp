// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The signals of the pairs: reads of them are the sums of their modes, at any place and time.
#include "coast/loops/band_signals.hpp"

#include <tuple>

#include "coast/loops/signal_task.hpp"
#include "divided_sea.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/dispersion.hpp"

namespace ocean {
namespace {

using test::DividedSea;
using test::height_of_pairs;
using test::Places;
using test::rms;

struct Jets {
    std::vector<float> re, im, re_x, im_x, re_y, im_y, re_t, im_t;

    Jets(const BandSignals& signals, std::size_t pair, const Places& at, bool rates = false) {
        for (std::vector<float>* values : {&re, &im, &re_x, &im_x, &re_y, &im_y, &re_t, &im_t}) {
            values->resize(at.size());
        }
        signals.read(pair, at.size(), at.x.data(), at.y.data(),
                     {re.data(), im.data(), re_x.data(), im_x.data(), re_y.data(), im_y.data(),
                      rates ? re_t.data() : nullptr, rates ? im_t.data() : nullptr});
    }
};

Parameters coast_sea(double direction = 20.0) {
    return test::wind_sea(512, 1024.0, {.wind = 12.0, .direction = direction, .fetch = 150000.0});
}

// Reads are the sums of their modes: the value within the tolerance; the gradient within 40 times
// that, as the wavenumbers of the maps, which the errors have, are to those of the waves; the rate
// within 3 times that, since short waves have more of it.
TEST(BandSignals, ReadsAreTheSumsOfTheirModes) {
    const DividedSea sea(test::wind_sea(128, 400.0));
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 2e-6}) {
        BandSignals signals(sea.modes, sea.bands, tolerance, true);
        signals.move_to(1e6, test::pool());
        const Places at(150, -1000.0, 1000.0);
        double value_error = 0.0, value = 0.0, slope_error = 0.0, slope = 0.0;
        double rate_error = 0.0, rate = 0.0;
        for (std::size_t pair = 0; pair < signals.count(); ++pair) {
            const Jets jets(signals, pair, at, true);
            for (std::size_t i = 0; i < at.size(); ++i) {
                const ExactSignal exact = signals.exact(pair, 1e6, at.x[i], at.y[i]);
                const auto error = [](std::complex<double> of, float re, float im) {
                    return std::norm(of - std::complex<double>(re, im));
                };
                value_error += error(exact.value, jets.re[i], jets.im[i]);
                slope_error += error(exact.by_x, jets.re_x[i], jets.im_x[i]) +
                               error(exact.by_y, jets.re_y[i], jets.im_y[i]);
                rate_error += error(exact.rate, jets.re_t[i], jets.im_t[i]);
                value += std::norm(exact.value);
                slope += std::norm(exact.by_x) + std::norm(exact.by_y);
                rate += std::norm(exact.rate);
            }
        }
        EXPECT_LT(std::sqrt(value_error / value), 1.1 * tolerance);
        EXPECT_LT(std::sqrt(slope_error / slope), 40.0 * tolerance);
        EXPECT_LT(std::sqrt(rate_error / rate), 3.0 * tolerance);
    }
}

// One wave of amplitude 1 is e^(i (k.x - omega t)): it travels along +k, into the sector of its k.
TEST(BandSignals, AWaveTravelsIntoItsSector) {
    const Parameters parameters = test::wind_sea(64, 300.0);
    for (const auto& [n, m, sector] : {std::tuple{9, 0, 0}, {0, 9, 2}, {-7, -5, 5}}) {
        const Modes modes = test::single_wave(parameters, n, m);
        ShoreBands bands;
        bands.edges = {0.01, 0.05, 0.1, 0.5, 1.0};
        const double kx = kTwoPi * n / 300.0, ky = kTwoPi * m / 300.0, k = std::hypot(kx, ky);
        for (int s = 0; s < kShoreSectors; ++s) bands.waves.push_back({bands.band_of(k), s, 0.5});
        BandSignals signals(modes, bands);
        signals.move_to(7.0, test::pool());
        const double omega = Dispersion(parameters.water).angular_frequency(k);
        const Places at(70, -900.0, 900.0);
        for (int s = 0; s < kShoreSectors; ++s) {
            const Jets jets(signals, static_cast<std::size_t>(s), at);
            for (std::size_t i = 0; i < at.size(); ++i) {
                const double phase = kx * at.x[i] + ky * at.y[i] - omega * 7.0;
                const double size = s == sector ? 1.0 : 0.0;
                EXPECT_NEAR(jets.re[i], size * std::cos(phase), 2e-6);
                EXPECT_NEAR(jets.im[i], size * std::sin(phase), 2e-6);
                EXPECT_NEAR(jets.re_x[i], -size * kx * std::sin(phase), 1e-6);
                EXPECT_NEAR(jets.im_y[i], size * ky * std::cos(phase), 1e-6);
            }
        }
    }
}

// The period wraps, and a place far away is as good as a near one.
TEST(BandSignals, ThePeriodWraps) {
    const DividedSea sea(test::wind_sea(64, 256.0));
    BandSignals signals(sea.modes, sea.bands);
    signals.move_to(3.0, test::pool());
    const Places near(100, 0.0, 256.0);
    for (const double periods : {-1.0, 1.0, 4000.0}) {
        Places far = near;
        for (double& x : far.x) x += periods * 256.0;
        for (double& y : far.y) y -= periods * 256.0;
        for (std::size_t pair = 0; pair < signals.count(); ++pair) {
            const Jets here(signals, pair, near);
            const Jets there(signals, pair, far);
            for (std::size_t i = 0; i < near.size(); ++i) {
                EXPECT_NEAR(here.re[i], there.re[i], 1e-6 * sea.height);
                EXPECT_NEAR(here.im_x[i], there.im_x[i], 1e-5);
            }
        }
    }
}

// A loop closes: the same bits 400 periods later, other ones 3 s later.
TEST(BandSignals, ALoopCloses) {
    Parameters parameters = test::wind_sea(64, 300.0, {.loop = 12.5});
    const DividedSea sea(parameters);
    BandSignals now(sea.modes, sea.bands, 1e-4, true);
    BandSignals later = now;
    now.move_to(4.2, test::pool());
    const Places at(100, 0.0, 300.0);
    later.move_to(4.2 + 3.0, test::pool());
    EXPECT_NE(Jets(now, 0, at).re, Jets(later, 0, at).re);
    later.move_to(4.2 + 400 * 12.5, test::pool());
    for (std::size_t pair = 0; pair < now.count(); ++pair) {
        EXPECT_EQ(Jets(now, pair, at, true).re, Jets(later, pair, at, true).re);
        EXPECT_EQ(Jets(now, pair, at, true).im_t, Jets(later, pair, at, true).im_t);
    }
}

// A place has one value, whichever outputs are requested and whichever places are read beside it.
TEST(BandSignals, OutputsThatNobodyRequestsAreSkipped) {
    const DividedSea sea(test::wind_sea(64, 300.0));
    BandSignals signals(sea.modes, sea.bands, 1e-4);
    signals.move_to(9.0, test::pool());
    const Places at(131, 0.0, 300.0);
    const Jets whole(signals, 0, at);
    std::vector<float> im(at.size());
    signals.read(0, at.size(), at.x.data(), at.y.data(), {.im = im.data()});
    EXPECT_EQ(im, whole.im);
    for (const std::size_t i : {std::size_t{0}, std::size_t{64}, std::size_t{130}}) {
        float re_y = 0.0f;
        signals.read(0, 1, &at.x[i], &at.y[i], {.re_y = &re_y});
        EXPECT_EQ(re_y, whole.re_y[i]);
    }
    signals.read(0, 1, at.x.data(), at.y.data(), {});
    EXPECT_THROW(signals.read(0, 1, at.x.data(), at.y.data(), {.re_t = im.data()}), Error);
}

// A move without rates leaves the values their bits, and no rate of an earlier time is read.
TEST(BandSignals, AMoveMakesRatesOnlyOnRequest) {
    const DividedSea sea(test::wind_sea(64, 300.0));
    BandSignals both(sea.modes, sea.bands, 1e-4, true);
    BandSignals values = both;
    const Places at(10, 0.0, 300.0);
    both.move_to(9.0, test::pool());
    values.move_to(2.0, test::pool());
    values.move_to(9.0, test::pool(), false);
    EXPECT_TRUE(both.has_rates());
    EXPECT_FALSE(values.has_rates());
    EXPECT_EQ(Jets(values, 0, at).im_x, Jets(both, 0, at).im_x);
    EXPECT_THROW(Jets(values, 0, at, true), Error);
    values.move_to(9.0, test::pool());
    EXPECT_EQ(Jets(values, 0, at, true).im_t, Jets(both, 0, at, true).im_t);
}

// A move for the reads of some places has their bits, across the border of the period too, and
// leaves the rest alone.
TEST(BandSignals, AMoveForSomeReadsHasTheirBits) {
    const DividedSea sea(test::wind_sea(64, 300.0));
    BandSignals whole(sea.modes, sea.bands);
    BandSignals part = whole;
    whole.move_to(9.0, test::pool());
    part.move_to(2.0, test::pool());
    const Places read(40, -15.0, 15.0), beside(40, 140.0, 160.0);
    SignalCells cells = part.no_cells();
    for (std::size_t pair = 0; pair < part.count(); ++pair) {
        part.add_cells(pair, read.size(), read.x.data(), read.y.data(), cells);
    }
    part.move_to(9.0, test::pool(), false, &cells);
    EXPECT_FALSE(part.is_whole());
    for (std::size_t pair = 0; pair < part.count(); ++pair) {
        EXPECT_EQ(Jets(part, pair, read).re_x, Jets(whole, pair, read).re_x) << pair;
        EXPECT_NE(Jets(part, pair, beside).re, Jets(whole, pair, beside).re) << pair;
    }
    part.move_to(9.0, test::pool(), false);
    EXPECT_TRUE(part.is_whole());
    EXPECT_EQ(Jets(part, 0, beside).re, Jets(whole, 0, beside).re);
}

// A flat sea has no signals, and its modes remain.
TEST(BandSignals, AFlatSeaHasNone) {
    Parameters parameters = test::wind_sea(32, 100.0, {.height = 0.0});
    const DividedSea sea(parameters);
    BandSignals signals(sea.modes, sea.bands);
    signals.move_to(1.0, test::pool());
    EXPECT_EQ(signals.count(), 0u);
    EXPECT_EQ(signals.samples(), 0u);
}

// The sea of a coast, 12 m/s over 150 km on 1024 m, costs at most three maps of 1024^2 a frame and
// is read to 2e-6, whatever its direction.
TEST(BandSignals, AFrameCostsAtMostThreeOpenMaps) {
    for (const double direction : {0.0, 20.0, 45.0}) {
        const DividedSea sea(coast_sea(direction));
        BandSignals signals(sea.modes, sea.bands);
        EXPECT_LE(signals.samples(), 3u * 1024u * 1024u);
        EXPECT_LE(signals.bytes(), 16u * signals.samples());
        signals.move_to(50.0, test::pool());
        const Places at(40, 0.0, 1024.0);
        std::vector<double> exact(at.size());
        std::vector<double> error = height_of_pairs(signals, at);
        for (std::size_t i = 0; i < at.size(); ++i) {
            for (std::size_t pair = 0; pair < signals.count(); ++pair) {
                exact[i] += signals.exact(pair, 50.0, at.x[i], at.y[i]).value.real();
            }
            error[i] -= exact[i];
        }
        // The rms of 40 errors is within a third of the rms of all.
        EXPECT_LT(rms(error), 1.33 * 2e-6 * rms(exact));
    }
}

// Products and sums are not fused, so that the sea of a machine is that of every other.
TEST(BandSignals, EveryInstructionSetReadsTheSameBits) {
    constexpr std::uint32_t kColumns = 32, kRows = 16;
    constexpr std::size_t kPitch = kColumns + 4, kCount = 150;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<float> values(2 * kPitch * kRows), rates(values.size());
    for (float& value : values) value = static_cast<float>(uniform(random));
    for (float& rate : rates) rate = static_cast<float>(uniform(random));
    std::vector<double> x(kCount), y(kCount);
    for (std::size_t i = 0; i < kCount; ++i) {
        x[i] = 3000.0 * uniform(random);
        y[i] = 3000.0 * uniform(random);
    }
    const auto read = [&](SimdLevel level) {
        std::vector<float> out(8 * kCount);
        const auto part = [&](std::size_t number) { return out.data() + number * kCount; };
        signal_loop(level)(
            {.count = kCount,
             .x = x.data(),
             .y = y.data(),
             .cells_per_metre = {0.31, 0.17},
             .mask = {kColumns - 1, kRows - 1},
             .half_turns = {0.041, -0.013},
             .value = {values.data(), kPitch},
             .rate = {rates.data(), kPitch},
             .out = {part(0), part(1), part(2), part(3), part(4), part(5), part(6), part(7)}});
        return out;
    };
    const std::vector<float> expected = read(SimdLevel::portable);
    EXPECT_GT(*std::ranges::max_element(expected), 0.1f);
    for (const SimdLevel level : {SimdLevel::sse4, SimdLevel::avx2, SimdLevel::avx512}) {
        if (!simd_available(level)) continue;
        EXPECT_EQ(read(level), expected) << simd_name(level);
    }
}

}  // namespace
}  // namespace ocean
