// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The wake of a hull ends within its square, narrows with the speed, and depends on nothing but the
// time.
#include "hulls/wake.hpp"

#include "ocean/error.hpp"
#include "ocean/thread_pool.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

constexpr double kGravity = 9.81;

Water deep_water() {
    Water water;
    water.gravity = kGravity;
    water.surface_tension = 0.0;
    return water;
}

/// A hull that goes east through (0, 0) at time 0, from far away to far away.
Hull straight_hull(double length, double beam, double draught, double speed) {
    Hull hull;
    hull.length = length;
    hull.beam = beam;
    hull.draught = draught;
    auto track = std::make_shared<HullTrack>();
    track->rows = {{-20000.0, -20000.0 * speed, 0.0}, {20000.0, 20000.0 * speed, 0.0}};
    hull.track = track;
    return hull;
}

/// A track of rows every half second from a function of time.
std::shared_ptr<const HullTrack> sampled(double from, double to,
                                         const std::function<PathVector(double)>& place) {
    auto track = std::make_shared<HullTrack>();
    for (double t = from; t <= to; t += 0.5) {
        const auto [x, y] = place(t);
        track->rows.push_back({t, x, y});
    }
    return track;
}

/// Straight on at 8 m/s, half a circle of 120 m from 0 s on, and straight back.
PathVector turning(double t) {
    constexpr double kSpeed = 8.0, kRadius = 120.0;
    if (t < 0.0) return {kSpeed * t, 0.0};
    const double q = std::min(kSpeed * t / kRadius, kPi);
    const double on = kSpeed * t - kRadius * q;
    return {kRadius * std::sin(q) + on * std::cos(q),
            kRadius * (1.0 - std::cos(q)) + on * std::sin(q)};
}
/// Stops from 8 m/s within 10 s.
PathVector stopping(double t) {
    constexpr double kSpeed = 8.0, kSlows = 0.8;
    const double q = std::clamp(t, 0.0, kSpeed / kSlows);
    return {kSpeed * std::min(t, 0.0) + kSpeed * q - 0.5 * kSlows * q * q, 0.0};
}
/// Starts and reaches 8 m/s after 20 s.
PathVector starting(double t) {
    constexpr double kSpeed = 8.0, kGains = 0.4;
    const double q = std::clamp(t, 0.0, kSpeed / kGains);
    return {0.5 * kGains * q * q + kSpeed * std::max(t - kSpeed / kGains, 0.0), 0.0};
}

Hull ferry(std::shared_ptr<const HullTrack> track) {
    Hull hull;
    hull.length = 30.0;
    hull.beam = 6.0;
    hull.draught = 1.8;
    hull.wake_size = 512.0;
    hull.wake_age = 200.0;
    hull.track = std::move(track);
    return hull;
}

/// Heights of a wake with Gaussian sections, behind a hull at the origin.
class GaussianWake {
  public:
    GaussianWake(const Hull& hull, double spread, ThreadPool& pool)
        : wake_(hull, deep_water(), 0.0, pool) {
        wake_.move_to(0.0, false, pool);
        Modes modes = wake_.modes();
        CascadeModes& waves = modes.cascades.front();
        const int n = waves.lattice.resolution;
        const double step = waves.lattice.wavenumber_step();
        for (const auto [i, j, at] : test::cells(n, n)) {
            const double k = step * std::hypot(signed_wavenumber(i, n), signed_wavenumber(j, n));
            waves.h0[at] *= static_cast<float>(1e4 * std::exp(-0.5 * k * k * spread * spread));
        }
        map_.emplace(modes, n, 1e30, pool);
        map_->move_to(modes, 0.0, false, pool);
        map_->prepare(-0.5 * waves.lattice.period, 0.5 * waves.lattice.period, pool);
    }
    double height(double x, double y) const {
        const auto [centre_x, centre_y] = wake_.past().place.centre;
        return static_cast<double>(map_->read<Plain>(x - centre_x, y - centre_y).height.value());
    }

  private:
    Wake wake_;
    std::optional<OpenSurface> map_;
};

// The waves of a disturbance with Gaussian sections of 10 m. [Rabaud 2013] saw the angle of the
// highest waves of ships fall as 1/Fr, and gave it the curve below. Lengths, angles and energies of
// other wakes are judged by the group hulls of `ocean verify`.
TEST(Wake, TheHighestWavesOfFastHullsStandAtNarrowerAngles) {
    ThreadPool pool;
    constexpr double kLength = 14.0, kSize = 320.0, kStep = kSize / 512;
    double before = 19.47;
    for (const double froude : {1.0, 1.5, 2.0, 2.5}) {
        const double speed = froude * std::sqrt(kGravity * 10.0);
        Hull hull = straight_hull(0.5, 0.1, 0.05, speed);
        hull.wake_size = kSize;
        hull.wake_resolution = 512;
        hull.wake_age = 1.2 * kSize / speed;
        hull.factor = 10.0;
        const GaussianWake wake(hull, 10.0 / kTwoPi, pool);
        test::LineFit places;  // of the highest crests
        for (double x = 60.0; x < 0.4 * kSize; x += 0.25 * kLength) {
            double highest = 0.0, place = 0.0;
            for (double y = kStep; y < 0.3 * kSize; y += kStep) {
                for (double along = x - 0.5 * kLength; along <= x + 0.5 * kLength; along += kStep) {
                    const double crest = std::abs(wake.height(-along, y));
                    if (crest > highest) highest = crest, place = y;
                }
            }
            places.add(x, place);
        }
        const double found = std::atan(places.slope()) / kDegree;
        const double square = kTwoPi * froude * froude;
        const double seen = std::atan(std::sqrt(square - 1.0) / (2.0 * square - 1.0)) / kDegree;
        EXPECT_LT(found, before) << froude;
        EXPECT_NEAR(found, seen, 0.25 * seen) << froude;
        before = found;
    }
}

TEST(Wake, EndsWithinItsSquare) {
    ThreadPool pool;
    const struct {
        const char* name;
        PathVector (*place)(double);
        double time;
    } tracks[] = {{"straight",
                   [](double t) {
                       return PathVector{8.0 * t, 0.0};
                   },
                   60.3},
                  {"turn", turning, 75.3},
                  {"stop", stopping, 60.3},
                  {"start", starting, 45.3}};
    for (const auto& [name, place, time] : tracks) {
        Wake wake(ferry(sampled(-300.0, 100.0, place)), deep_water(), 0.0, pool);
        wake.move_to(time, false, pool);
        wake.prepare(-1e6, 1e6, pool);
        const PathVector centre = wake.past().place.centre;
        double all = 0.0, outer = 0.0;
        for (int j = -128; j < 128; ++j) {
            for (int i = -128; i < 128; ++i) {
                const double x = centre.x + 2.0 * i, y = centre.y + 2.0 * j;
                const bool is_rim = i == -128 || j == -128 || i == 127 || j == 127;
                const double h = static_cast<double>(wake.read(x, y).height.value());
                if (is_rim) {
                    EXPECT_EQ(h, 0.0) << name;
                }
                all += h * h;
                if (std::abs(i + 0.5) > 120.0 || std::abs(j + 0.5) > 120.0) outer += h * h;
            }
        }
        EXPECT_GT(all, 1.0) << name;
        EXPECT_LE(outer, 0.01 * all) << name;
    }
}

/// Returns true if two wakes of one time have the same bits.
bool are_same(const Wake& a, const Wake& b) {
    const Modes first = a.modes(), second = b.modes();
    const auto &h = first.cascades.front().h0, &g = second.cascades.front().h0;
    if (std::memcmp(h.data(), g.data(), h.size() * sizeof(h[0])) != 0) return false;
    const auto [x, y] = a.past().place.centre;
    for (const double off : {-60.0, 3.0, 70.0}) {
        const LinearWaves<Jet> s = a.read(x + off, y + 10.0);
        const LinearWaves<Jet> t = b.read(x + off, y + 10.0);
        for (int part = 0; part < 4; ++part) {
            if (s.height.parts[part] != t.height.parts[part]) return false;
        }
    }
    return true;
}

TEST(Wake, IsAFunctionOfTheTimeAlone) {
    ThreadPool one(1), pool;
    std::vector<Hull> hulls = {ferry(sampled(-300.0, 100.0, turning)),
                               straight_hull(30.0, 6.0, 1.8, 8.0),
                               ferry(sampled(-300.0, 100.0, stopping))};
    for (Hull& hull : hulls) {
        hull.wake_resolution = 64;
        Wake sequence(hull, deep_water(), 0.0, pool);
        const auto is_that_alone = [&](double time) {
            Wake alone(hull, deep_water(), 0.0, one);
            alone.move_to(time, true, one);
            return are_same(sequence, alone);
        };
        // Five seconds at 24 frames a second and back: over ticks, blocks and the windows' spans.
        for (const int step : {1, -1}) {
            for (int frame = 0; frame <= 120; ++frame) {
                const double time = 8.0 + (step > 0 ? frame : 120 - frame) / 24.0;
                sequence.move_to(time, true, pool);
                if (frame % 12 == 0 || frame % 24 == 7) {
                    EXPECT_TRUE(is_that_alone(time)) << time;
                }
            }
        }
        for (const double time : {39.0, -20.0, 40.25}) sequence.move_to(time, true, pool);
        EXPECT_TRUE(is_that_alone(40.25));
        // Without derivatives the values are the same.
        const auto [x, y] = sequence.past().place.centre;
        const float height = sequence.read(x + 3.0, y + 10.0).height.value();
        sequence.move_to(40.25, false, pool);
        EXPECT_EQ(sequence.read(x + 3.0, y + 10.0).height.value(), height);
    }
}

TEST(Wake, AFrameThatWasInterruptedIsMadeAgain) {
    ThreadPool pool(1), other(1);
    Hull hull = ferry(sampled(-300.0, 100.0, turning));
    hull.wake_resolution = 64;
    constexpr double kTime = 11.9;
    Wake alone(hull, deep_water(), 0.0, other);
    alone.move_to(kTime, true, other);
    int stopped = 0;
    for (int last = 0; last < 3; ++last) {
        Wake wake(hull, deep_water(), 0.0, pool);
        wake.move_to(10.2, true, pool);
        int calls = 0;
        pool.set_interrupt([&] {
            if (calls++ == last) throw Error(ErrorKind::interrupted, "stopped");
        });
        try {
            wake.move_to(kTime, true, pool);
        } catch (const Error&) {
            ++stopped;
        }
        pool.set_interrupt({});
        wake.move_to(kTime, true, pool);
        EXPECT_TRUE(are_same(wake, alone)) << last;
    }
    EXPECT_GT(stopped, 0);
}

TEST(Wake, HasNoJumpWhereTicksPassAndBlocksMerge) {
    ThreadPool pool;
    Wake wake(ferry(sampled(-300.0, 100.0, turning)), deep_water(), 0.0, pool);
    const auto heights = [&](double time) {
        wake.move_to(time, false, pool);
        std::vector<double> values;
        for (double x = -100.0; x < 120.0; x += 10.0) {
            values.push_back(static_cast<double>(wake.read(x, 60.0).height.value()));
        }
        return values;
    };
    const auto before = heights(40.0 - 1e-6);
    const auto after = heights(40.0 + 1e-6);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 2e-5);
}

TEST(Wake, VelocityIsTheRateOfHeightAndDisplacement) {
    ThreadPool pool;
    Wake wake(ferry(sampled(-300.0, 100.0, turning)), deep_water(), 0.0, pool);
    constexpr double kTime = 40.3, kStep = 0.01;
    // Below the hull, in its wake and beside it.
    const auto [bow_x, bow_y] = turning(kTime);
    const PathVector places[] = {{bow_x, bow_y}, {bow_x + 10.0, bow_y - 60.0}, {60.0, 150.0}};
    for (const auto& [x, y] : places) {
        wake.move_to(kTime - kStep, false, pool);
        const LinearWaves<Jet> before = wake.read(x, y);
        wake.move_to(kTime + kStep, false, pool);
        const LinearWaves<Jet> after = wake.read(x, y);
        wake.move_to(kTime, true, pool);
        const LinearWaves<Jet> now = wake.read(x, y);
        const auto rate = [&](const Jet& a, const Jet& b) {
            return (static_cast<double>(b.value()) - static_cast<double>(a.value())) /
                   (2.0 * kStep);
        };
        EXPECT_NEAR(static_cast<double>(now.height.by_t()), rate(before.height, after.height),
                    0.02);
        EXPECT_NEAR(static_cast<double>(now.displacement_x.by_t()),
                    rate(before.displacement_x, after.displacement_x), 0.02);
    }
}

TEST(Wake, ExactSumsAreTheSplines) {
    ThreadPool pool;
    Wake wake(ferry(sampled(-300.0, 100.0, turning)), deep_water(), 0.0, pool);
    wake.move_to(40.3, true, pool);
    wake.prepare_sums(deep_water());
    for (const double x : {20.0, 61.7, 98.1}) {
        const LinearWaves<Jet> spline = wake.read(x, 97.3);
        const LinearWaves<Jet> exact = wake.read_exactly(x, 97.3);
        EXPECT_NEAR(spline.height.value(), exact.height.value(), 2e-3);
        EXPECT_NEAR(spline.displacement_y.value(), exact.displacement_y.value(), 2e-3);
        EXPECT_NEAR(spline.height.by_t(), exact.height.by_t(), 4e-3);
    }
}

TEST(Wake, AHullAtRestLeavesNothing) {
    ThreadPool pool;
    auto track = std::make_shared<HullTrack>();
    track->rows = {{0.0, 5.0, 7.0}, {500.0, 5.0, 7.0}};
    Wake wake(ferry(track), deep_water(), 0.0, pool);
    wake.move_to(400.0, true, pool);
    const Modes modes = wake.modes();
    for (const auto& a : modes.cascades.front().h0) {
        ASSERT_EQ(a, std::complex<float>(0.0f, 0.0f));
    }
    EXPECT_EQ(wake.read(5.0, 7.0).height.by_t(), 0.0f);
}

TEST(Wake, RepeatsWithALoop) {
    ThreadPool pool;
    constexpr double kPeriod = 60.0;
    const Hull hull = ferry(sampled(0.0, kPeriod, [](double t) {
        const double q = kTwoPi * t / kPeriod;
        return PathVector{70.0 * std::cos(q), 70.0 * std::sin(q)};
    }));
    Wake wake(hull, deep_water(), kPeriod, pool);
    wake.move_to(17.3, false, pool);
    const double first = static_cast<double>(wake.read(40.0, 30.0).height.value());
    wake.move_to(17.3 + 2.0 * kPeriod, false, pool);
    EXPECT_NEAR(static_cast<double>(wake.read(40.0, 30.0).height.value()), first, 1e-5);
    EXPECT_GT(std::abs(first), 1e-3);
}

}  // namespace
}  // namespace ocean
