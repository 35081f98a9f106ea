// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Foam as mathematics: how much whitecap a threshold gives, the clock, and the state that steps.
#include "ocean/internal/foam.hpp"

#include <bit>
#include <stdexcept>

#include "ocean/error.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/thread_pool.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

/// A wave of one direction; its gradient is `steepness` times a standard normal.
struct Wave {
    double degrees;
    double steepness;

    double a() const { return steepness * std::pow(std::cos(degrees * kPi / 180.0), 2); }
    double b() const { return steepness * std::pow(std::sin(degrees * kPi / 180.0), 2); }
    double c() const { return 0.5 * steepness * std::sin(degrees * kPi / 90.0); }
};

GradientCovariance covariance_of(const std::vector<Wave>& waves) {
    GradientCovariance v;
    for (const Wave& w : waves) {
        v.aa += w.a() * w.a();
        v.bb += w.b() * w.b();
        v.cc += w.c() * w.c();
        v.ab += w.a() * w.b();
        v.ac += w.a() * w.c();
        v.bc += w.b() * w.c();
    }
    return v;
}

/// Waves of many directions about a mean, cos^2 in energy.
std::vector<Wave> spread_sea(double mean, double half_width, double steepness) {
    std::vector<Wave> waves;
    for (int i = -8; i <= 8; ++i) {
        const double share = std::cos(i / 9.0 * 0.5 * kPi) / 3.0;
        waves.push_back({mean + half_width * i / 8.0, steepness * share});
    }
    return waves;
}

struct Gradients {
    double a = 0.0, b = 0.0, c = 0.0;
};

std::vector<Gradients> random_gradients(const std::vector<Wave>& waves) {
    std::mt19937_64 random(20240501);
    std::normal_distribution<double> normal;
    std::vector<Gradients> drawn(200000);
    for (Gradients& g : drawn) {
        for (const Wave& wave : waves) {
            const double z = normal(random);
            g.a += z * wave.a();
            g.b += z * wave.b();
            g.c += z * wave.c();
        }
    }
    return drawn;
}

test::SampleMean sampled_whitecap(const std::vector<Gradients>& drawn, double choppiness,
                                  double threshold, double width) {
    test::SampleMean whitecaps;
    for (const Gradients& g : drawn) {
        const double jacobian = (1.0 - choppiness * g.a) * (1.0 - choppiness * g.b) -
                                choppiness * choppiness * g.c * g.c;
        whitecaps.add(std::clamp((threshold - jacobian) / width, 0.0, 1.0));
    }
    return whitecaps;
}

TEST(Foam, MonahansCoverageIsThePowerOfTheWindAndAtMostAll) {
    EXPECT_NEAR(monahan_coverage(10.0), 0.00987, 5e-6);
    EXPECT_NEAR(monahan_coverage(12.0), 0.0184, 5e-5);
    EXPECT_EQ(monahan_coverage(0.0), 0.0);
    EXPECT_EQ(monahan_coverage(75.0), 1.0);
}

TEST(Foam, TheMeanWhitecapIsThatOfRandomGradients) {
    const std::vector<std::vector<Wave>> seas = {
        spread_sea(0.0, 90.0, 0.2),    // a broad wind sea
        spread_sea(37.0, 60.0, 0.25),  // turned: all covariances differ from 0
        spread_sea(100.0, 5.0, 0.3),   // a narrow swell
        {{0.0, 0.2}},                  // long-crested, along x: rank 1
        {{63.0, 0.2}},                 // and oblique
        {{20.0, 0.2}, {110.0, 0.15}},  // two long-crested seas at a right angle
        {{10.0, 0.2}, {65.0, 0.2}},    // and oblique: rank 2 without a free direction
        {{0.0, 0.2}, {60.0, 0.2}, {120.0, 0.2}},
    };
    for (const std::vector<Wave>& waves : seas) {
        const std::vector<Gradients> gradients = random_gradients(waves);
        for (const double choppiness : {0.5, 1.0, 2.5}) {
            for (const auto& [threshold, width] :
                 {std::pair(0.75, 0.2), std::pair(0.95, 0.05), std::pair(0.2, 1.0)}) {
                const test::SampleMean drawn =
                    sampled_whitecap(gradients, choppiness, threshold, width);
                const double mean =
                    mean_whitecap(covariance_of(waves), choppiness, threshold, width);
                EXPECT_NEAR(mean, drawn.mean(), 4.0 * drawn.error() + 1e-9)
                    << waves.size() << " waves from " << waves.front().degrees << " degrees, C "
                    << choppiness << ", threshold " << threshold;
            }
        }
    }
}

TEST(Foam, TheMeanWhitecapDoesNotDependOnTheAxes) {
    const double straight =
        mean_whitecap(covariance_of(spread_sea(0.0, 80.0, 0.25)), 1.0, 0.7, 0.2);
    for (const double turn : {17.0, 45.0, 90.0, 133.0}) {
        const auto turned = covariance_of(spread_sea(turn, 80.0, 0.25));
        EXPECT_NEAR(mean_whitecap(turned, 1.0, 0.7, 0.2), straight, 1e-9 * straight);
    }
}

TEST(Foam, WaterAtRestIsWhiteWhereItsJacobianIs) {
    EXPECT_EQ(mean_whitecap({}, 1.0, 1.0, 0.2), 0.0);
    EXPECT_NEAR(mean_whitecap({}, 1.0, 1.1, 0.2), 0.5, 1e-12);
    EXPECT_NEAR(mean_whitecap({}, 1.0, 1.5, 0.2), 1.0, 1e-12);
}

TEST(Foam, TheThresholdGivesTheCoverageOfTheWind) {
    const GradientCovariance sea = covariance_of(spread_sea(30.0, 80.0, 0.25));
    double last = -10.0;
    for (const double wind : {1.0, 4.0, 8.0, 12.0, 16.0, 20.0}) {
        const SurfaceSettings settings;
        const double threshold = whitecap_threshold(sea, settings, wind);
        const double wanted = monahan_coverage(wind);
        EXPECT_NEAR(mean_whitecap(sea, settings.choppiness, threshold, settings.foam_width), wanted,
                    1e-6 * wanted)
            << wind << " m/s";
        EXPECT_GT(threshold, last);
        last = threshold;
    }
}

TEST(Foam, AThresholdIsAtMostOneThatOfTheFileOrWithoutWhitecapsBelowEveryJacobian) {
    const GradientCovariance calm = covariance_of(spread_sea(0.0, 80.0, 0.01));
    EXPECT_EQ(whitecap_threshold(calm, {}, 30.0), 1.0) << "water that is not squeezed";
    const GradientCovariance sea = covariance_of(spread_sea(0.0, 80.0, 0.25));
    SurfaceSettings given;
    given.foam_coverage = FoamCoverage::threshold;
    given.foam_threshold = 0.6;
    EXPECT_EQ(whitecap_threshold(sea, given, 12.0), 0.6);
    SurfaceSettings flat;
    flat.choppiness = 0.0;
    for (const double none : {whitecap_threshold(sea, {}, 0.0), whitecap_threshold({}, {}, 12.0),
                              whitecap_threshold(sea, flat, 12.0)}) {
        EXPECT_TRUE(std::isfinite(static_cast<float>(none)));
        const float depth = static_cast<float>(none) + 1e30f;  // of the most folded crest
        EXPECT_EQ(std::clamp(depth / 0.001f, 0.0f, 1.0f), 0.0f);
    }
}

FoamClock clock_of(double step = 0.05, double loop = 0.0) {
    SurfaceSettings settings;
    settings.foam_step = step;
    return foam_clock(settings, loop);
}

TEST(FoamClock, TheTimeOfATickIsThatTick) {
    for (const double step : {0.01, 0.05, 0.1, 1.0 / 3.0, 1.0}) {
        for (const double loop : {0.0, 0.004, 1.0, 7.3, 120.0}) {
            const FoamClock clock = clock_of(step, loop);
            const std::int64_t last = loop > 0.0 ? clock.ticks_per_loop - 1 : 20000;
            for (std::int64_t tick = loop > 0.0 ? 0 : -20000; tick <= last; ++tick) {
                const FoamClock::Moment moment = clock.moment(clock.time_of(tick));
                ASSERT_EQ(moment.tick, tick) << step << " s, loop of " << loop << " s";
                ASSERT_EQ(moment.since, 0.0);
            }
        }
    }
}

TEST(FoamClock, ATimeBelongsToTheTickBefore) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> times(-1e6, 1e6);
    for (const double loop : {0.0, 12.5}) {
        const FoamClock clock = clock_of(0.05, loop);
        for (int i = 0; i < 20000; ++i) {
            const FoamClock::Moment moment = clock.moment(times(random));
            EXPECT_GE(moment.since, 0.0);
            EXPECT_LT(moment.since, clock.step * (1.0 + 1e-9));
        }
        EXPECT_EQ(clock.moment(0.0499999).tick, 0);
        EXPECT_NEAR(clock.moment(0.0499999).since, 0.0499999, 1e-12);
        EXPECT_EQ(clock.moment(-0.01).tick, loop > 0.0 ? 249 : -1);
        EXPECT_NEAR(clock.moment(-0.01).since, 0.04, 1e-9);
    }
}

TEST(FoamClock, ALoopIsAWholeNumberOfTicksAndEveryTimeComesAgain) {
    EXPECT_EQ(clock_of(0.05, 10.02).ticks_per_loop, 200);
    EXPECT_DOUBLE_EQ(clock_of(0.05, 10.02).step, 10.02 / 200);
    EXPECT_EQ(clock_of(1.0, 0.1).ticks_per_loop, 1);
    const FoamClock clock = clock_of(0.05, 10.0);
    for (int i = 0; i < 1000; ++i) {
        const double time = i / 64.0;
        for (const double later : {time + 10.0, time + 1e6, time - 70.0}) {
            EXPECT_EQ(clock.moment(later).tick, clock.moment(time).tick);
            EXPECT_EQ(clock.moment(later).since, clock.moment(time).since);
        }
    }
    EXPECT_EQ(clock.ticks_between(199, 0), 1);
    EXPECT_EQ(clock.ticks_between(0, 199), 199);
    EXPECT_EQ(clock.before(0, 1), 199);
    EXPECT_EQ(clock.before(199, -1), 0);
    for (const double bad : {1e300, std::nan("")}) EXPECT_THROW(clock_of().moment(bad), Error);
}

std::function<double(double)> always(double lifetime) {
    return [lifetime](double) { return lifetime; };
}

TEST(FoamPreroll, IsAsLongAsFoamTakesToFade) {
    const FoamClock clock = clock_of();
    EXPECT_EQ(preroll_ticks(clock, 0, always(4.0)), 500);  // ceil(ln(512) * 80)
    EXPECT_EQ(preroll_ticks(clock, 12345, always(4.0)), 500);
    EXPECT_EQ(preroll_ticks(clock, 0, always(0.0)), 0);
    EXPECT_EQ(preroll_ticks(clock_of(0.05, 10.0), 3, always(4.0)), 200);
    EXPECT_EQ(preroll_ticks(clock_of(0.05, 10.0), 3, always(0.5)), 63);
}

TEST(FoamPreroll, FollowsALifetimeThatChanges) {
    const FoamClock clock = clock_of();
    // Since 0 s foam fades fast, before it lived long: 100 ticks take 100/40 of the 6.2383.
    const auto lifetime = [](double time) { return time > 0.0 ? 2.0 : 8.0; };
    const std::int64_t before = static_cast<std::int64_t>(std::ceil((std::log(512.0) - 2.5) * 160));
    EXPECT_EQ(preroll_ticks(clock, 100, lifetime), 100 + before);
    EXPECT_EQ(preroll_ticks(clock, 100, [](double t) { return t > 4.0 ? 2.0 : 0.0; }), 20);
}

TEST(FoamPreroll, FullFoamHasFadedInFloatsToo) {
    for (const auto& [lifetime, step] : {std::pair(600.0, 0.01), std::pair(4.0, 0.05),
                                         std::pair(30.0, 1.0), std::pair(0.02, 0.01)}) {
        const FoamClock clock = clock_of(step, 0.0);
        const std::int64_t ticks = preroll_ticks(clock, 0, always(lifetime));
        const float decay = static_cast<float>(std::exp(-step / lifetime));
        float foam = 1.0f;
        for (std::int64_t i = 0; i < ticks; ++i) foam *= decay;
        EXPECT_LT(foam, 1.0f / 512.0f) << lifetime;
        EXPECT_LT(static_cast<double>(ticks), 1.01 * std::log(512.0) * lifetime / step + 1.0);
    }
}

float over(const FoamLayer& layer, float whitecap, std::size_t i) {
    const float left = layer.map != nullptr ? layer.fade * layer.map[i] : 0.0f;
    const float foam = std::max(whitecap, left);
    return foam < layer.cutoff ? 0.0f : foam;
}

/// Whitecaps that come and go at random, independent for each sample and time; counts its calls.
class RandomWhitecaps {
  public:
    static constexpr std::size_t kSamples = 257;

    explicit RandomWhitecaps(const FoamClock& clock, std::function<double(double)> lifetime)
        : clock_(clock) {
        source_.lifetime = std::move(lifetime);
        source_.tick = [this](double time, const FoamLayer& before, std::span<float> foam) {
            ++calls;
            if (calls == fail_at) throw std::runtime_error("no whitecap");
            fill(time, map_);
            for (std::size_t i = 0; i < kSamples; ++i) foam[i] = over(before, map_[i], i);
        };
    }

    std::vector<float> foam(FoamState& state, double time) {
        std::vector<float> out(kSamples);
        fill(time, out);
        const FoamLayer before = state.layer(time, source_);
        for (std::size_t i = 0; i < kSamples; ++i) out[i] = over(before, out[i], i);
        return out;
    }
    std::vector<float> alone(double time) {
        FoamState state(clock_, RandomWhitecaps::kSamples);
        return foam(state, time);
    }
    /// The calls that a step costs.
    int cost(FoamState& state, double time) {
        calls = 0;
        foam(state, time);
        return calls;
    }
    FoamSource& source() { return source_; }

    int calls = 0;
    int fail_at = -1;

  private:
    void fill(double time, std::vector<float>& map) const {
        const double tau =
            clock_.loop_period > 0.0 ? loop_fraction(time, clock_.loop_period) : time;
        for (std::size_t i = 0; i < map.size(); ++i) {
            std::uint64_t x = std::bit_cast<std::uint64_t>(tau) + 0x9E3779B97F4A7C15u * (i + 1);
            x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
            x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
            const float u = static_cast<float>((x ^ (x >> 31)) >> 40) * 0x1p-24f;
            map[i] = std::clamp(100.0f * u - 98.5f, 0.0f, 1.0f);  // 1.5 % of the instants
        }
    }

    FoamClock clock_;
    FoamSource source_;
    std::vector<float> map_ = std::vector<float>(kSamples);
};

double frame_time(int frame, double fps) {
    return (frame - 1) / fps;
}

struct FoamCase {
    const char* name;
    double loop;
    std::function<double(double)> lifetime;
};
class FoamBits : public testing::TestWithParam<FoamCase> {
  protected:
    FoamClock clock = clock_of(0.05, GetParam().loop);
    RandomWhitecaps sea{clock, GetParam().lifetime};
};

TEST_P(FoamBits, FrameTwoHundredIsTheSameHoweverItIsReached) {
    for (const double fps : {24.0, 48.0, 96.0}) {
        const std::vector<float> alone = sea.alone(frame_time(200, fps));
        for (const int first : {1, 150}) {
            FoamState state(clock, RandomWhitecaps::kSamples);
            std::vector<float> last;
            for (int frame = first; frame <= 200; ++frame) {
                last = sea.foam(state, frame_time(frame, fps));
            }
            EXPECT_EQ(last, alone) << "from " << first << " at " << fps;
        }
        FoamState back(clock, RandomWhitecaps::kSamples);
        for (const double frame : {201.0, 200.75, 200.5, 200.25}) {
            const double time = (frame - 1.0) / fps;
            EXPECT_EQ(sea.foam(back, time), sea.alone(time));
        }
        EXPECT_EQ(sea.foam(back, frame_time(200, fps)), alone);
    }
}

TEST_P(FoamBits, IsThatOfASumOverTheWholePast) {
    const std::int64_t tick = clock.before(170, 0);
    const std::int64_t past = 4 * preroll_ticks(clock, tick, GetParam().lifetime) + 40;
    std::vector<float> expected(RandomWhitecaps::kSamples);
    for (std::int64_t i = past; i >= 0; --i) {
        const double time = clock.time_of(clock.before(tick, i));
        const double lifetime = GetParam().lifetime(time);
        const float decay =
            lifetime > 0.0 ? static_cast<float>(std::exp(-clock.step / lifetime)) : 0.0f;
        std::vector<float> w(RandomWhitecaps::kSamples);
        sea.source().tick(time, {}, w);  // over no foam: the whitecaps themselves
        for (std::size_t s = 0; s < expected.size(); ++s) {
            expected[s] = std::max(w[s], decay * expected[s]);
            if (expected[s] < 1.0f / 512.0f) expected[s] = 0.0f;
        }
    }
    EXPECT_EQ(sea.alone(clock.time_of(tick)), expected);
}

TEST_P(FoamBits, AnEmptyStartShowsAllFoamOnceItHasSettled) {
    FoamState live(clock, RandomWhitecaps::kSamples, FoamStart::empty);
    FoamState settled(clock, RandomWhitecaps::kSamples);
    const double begin = 2.0;
    EXPECT_EQ(sea.cost(live, begin), 1);
    const std::int64_t wait = live.settling_ticks();
    EXPECT_EQ(wait, preroll_ticks(clock, clock.moment(begin).tick, GetParam().lifetime));
    const std::int64_t first = clock.moment(begin).tick;
    std::int64_t tick = 0;
    while (live.settling_ticks() > 0) {
        ++tick;
        ASSERT_LT(tick, 4000);
        const double time = clock.time_of(clock.before(first, -tick));
        const std::vector<float> shown = sea.foam(live, time);
        if (live.settling_ticks() == 0) {
            EXPECT_EQ(shown, sea.foam(settled, time));
        }
    }
}

TEST_P(FoamBits, AFailureLeavesAStateThatGoesOn) {
    FoamState state(clock, RandomWhitecaps::kSamples);
    const double time = 3.21;
    sea.fail_at = sea.calls + 1;
    EXPECT_THROW(sea.foam(state, time), std::runtime_error);
    EXPECT_EQ(sea.foam(state, time), sea.alone(time));
    sea.fail_at = sea.calls + 1;
    EXPECT_THROW(sea.foam(state, time + 0.15), std::runtime_error);
    sea.fail_at = -1;
    EXPECT_EQ(sea.foam(state, time + 0.2), sea.alone(time + 0.2));
}

INSTANTIATE_TEST_SUITE_P(
    Seas, FoamBits,
    testing::Values(
        FoamCase{"short", 0.0, always(1.0)}, FoamCase{"long", 0.0, always(20.0)},
        FoamCase{"none", 0.0, always(0.0)}, FoamCase{"loop", 6.4, always(1.0)},
        FoamCase{"long_in_a_loop", 6.4, always(20.0)},
        FoamCase{"changing", 0.0, [](double t) { return t < 3.0   ? 0.3
                                                        : t < 5.0 ? 6.0
                                                                  : 0.0; }},
        FoamCase{"gliding", 0.0, [](double t) { return 1.0 + std::exp(-std::max(t, 0.0)); }}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(FoamCost, IsTheTicksThatWereNotSeen) {
    const FoamClock clock = clock_of();
    RandomWhitecaps sea(clock, always(4.0));
    FoamState state(clock, RandomWhitecaps::kSamples);
    const double time = clock.time_of(400);
    EXPECT_EQ(sea.cost(state, time), 501);         // alone: the pre-roll, and its first tick
    EXPECT_EQ(sea.cost(state, time + 0.04), 0);    // within the tick
    EXPECT_EQ(sea.cost(state, time + 0.06), 1);    // the next
    EXPECT_EQ(sea.cost(state, time - 0.04), 0);    // two ticks back
    EXPECT_EQ(sea.cost(state, time + 0.06), 0);    // and forth
    EXPECT_EQ(sea.cost(state, time + 0.56), 10);   // a jump within the pre-roll
    EXPECT_EQ(sea.cost(state, time + 60.0), 501);  // and beyond it
    EXPECT_EQ(sea.cost(state, time), 501);         // before the kept ticks
}

TEST(FoamCost, ALoopClosesForTheCostOfOneTick) {
    const FoamClock clock = clock_of(0.05, 5.0);
    RandomWhitecaps sea(clock, always(4.0));
    FoamState state(clock, RandomWhitecaps::kSamples);
    EXPECT_EQ(sea.cost(state, 4.96), 101);
    EXPECT_EQ(sea.cost(state, 5.0), 1);
    EXPECT_EQ(sea.foam(state, 5.0), sea.alone(0.0));
    EXPECT_EQ(sea.cost(state, 15.0 - 0.01), 0);
    EXPECT_EQ(sea.cost(state, 0.06), 1);
}

TEST(FoamCost, AnEmptyStartNeverPaysForThePast) {
    const FoamClock clock = clock_of();
    RandomWhitecaps sea(clock, always(4.0));
    FoamState state(clock, RandomWhitecaps::kSamples, FoamStart::empty);
    EXPECT_EQ(sea.cost(state, 10.0), 1);
    EXPECT_EQ(state.settling_ticks(), 500);
    EXPECT_EQ(sea.cost(state, 10.5), 10);
    EXPECT_EQ(state.settling_ticks(), 490);
    EXPECT_EQ(sea.cost(state, 1.0), 1);
    EXPECT_EQ(state.settling_ticks(), 500);
}

TEST(FoamProgress, IsToldOfThePrerollAndMayStopItWithoutALoss) {
    const FoamClock clock = clock_of();
    RandomWhitecaps sea(clock, always(1.0));
    FoamState state(clock, RandomWhitecaps::kSamples);
    std::int64_t told = 0;
    sea.source().progress = [&](std::int64_t done, std::int64_t total) {
        EXPECT_EQ(done, told++);
        EXPECT_EQ(total, 126);
    };
    sea.foam(state, 1.0);
    EXPECT_EQ(told, 126);
    sea.source().progress = [](std::int64_t, std::int64_t) { throw std::runtime_error("stop"); };
    EXPECT_THROW(sea.foam(state, 50.0), std::runtime_error);
    EXPECT_EQ(sea.cost(state, 1.0), 0);
}

}  // namespace
}  // namespace ocean
