// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The wake of a hull is Kelvin's: its lengths, its angles and its energy; it ends within its
// square, and depends on nothing but the time.
#include "hulls/wake.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

#include "field/ease.hpp"
#include "ocean/error.hpp"
#include "ocean/thread_pool.hpp"

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

/// Waves of a wake, each times a factor(k, k along x, k along y), on maps of their own.
class FilteredWake {
  public:
    using Factor = std::function<double(double k, double kx, double ky)>;

    FilteredWake(const Wake& wake, const Factor& factor, ThreadPool& pool)
        : modes_(wake.modes()), centre_(wake.past().place.centre) {
        CascadeModes& waves = modes_.cascades.front();
        const int n = waves.lattice.resolution;
        const double step = waves.lattice.wavenumber_step();
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const double kx = step * signed_wavenumber(i, n);
                const double ky = step * signed_wavenumber(j, n);
                waves.h0[static_cast<std::size_t>(j * n + i)] *=
                    static_cast<float>(factor(std::hypot(kx, ky), kx, ky));
            }
        }
        map_.emplace(modes_, n, 1e30, pool);
        map_->move_to(modes_, 0.0, false, pool);
        const double half = 0.5 * waves.lattice.period;
        map_->prepare(-half, half, pool);
    }

    double height(double x, double y) const {
        return static_cast<double>(map_->read<Plain>(x - centre_.x, y - centre_.y).height.value());
    }

  private:
    Modes modes_;
    PathVector centre_;
    std::optional<OpenSurface> map_;
};

/// Waves of a short hull, which sends the same to each wave, times a factor.
FilteredWake short_wake(double speed, double size, const FilteredWake::Factor& factor,
                        ThreadPool& pool) {
    Hull hull = straight_hull(0.5, 0.1, 0.05, speed);
    hull.wake_size = size;
    hull.wake_resolution = 512;
    hull.wake_age = std::min(3600.0, 1.2 * size / speed);
    hull.factor = 10.0;
    Wake wake(hull, deep_water(), 0.0, pool);
    wake.move_to(0.0, false, pool);
    return {wake, factor, pool};
}

/// Waves of a hull with the sections e^(-|x|/l), l = 7.5 m: all of them come from one place, so
/// that bow and stern do not interfere.
FilteredWake cusp_wake(double speed, double size, ThreadPool& pool) {
    const double transverse = kTwoPi * speed * speed / kGravity;
    const double blur = 0.05 * transverse;
    const auto factor = [blur](double k, double kx, double ky) {
        return 1e4 * std::exp(-0.5 * blur * blur * ky * ky) / (1.0 + kx * kx * 7.5 * 7.5) /
               (1.0 + k * 1.5);
    };
    return short_wake(speed, size, factor, pool);
}

/// Returns the slope of the line through points by least squares.
double slope_of(const std::vector<double>& x, const std::vector<double>& y) {
    double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        sxy += x[i] * y[i];
    }
    const auto n = static_cast<double>(x.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// Returns the wavelength on the line behind a hull at the origin: that of the cosine with an
/// amplitude that changes linearly which fits best.
double transverse_length(const FilteredWake& wake, double expected, double near, double far) {
    double best = 0.0, least = 1e300;
    for (int trial = 0; trial <= 200; ++trial) {
        const double k = kTwoPi / expected * (0.95 + 0.0005 * trial);
        // Normal equations of four functions.
        double a[4][5] = {};
        double total = 0.0;
        for (double x = near; x < far; x += expected / 16.0) {
            const double h = wake.height(-x, 0.0);
            const double f[4] = {std::cos(k * x), std::sin(k * x), x / far * std::cos(k * x),
                                 x / far * std::sin(k * x)};
            for (int r = 0; r < 4; ++r) {
                for (int c = 0; c < 4; ++c) a[r][c] += f[r] * f[c];
                a[r][4] += f[r] * h;
            }
            total += h * h;
        }
        double explained = 0.0;
        double b[4][5];
        std::memcpy(b, a, sizeof(a));
        for (int p = 0; p < 4; ++p) {
            for (int r = p + 1; r < 4; ++r) {
                const double q = b[r][p] / b[p][p];
                for (int c = p; c < 5; ++c) b[r][c] -= q * b[p][c];
            }
        }
        double s[4];
        for (int p = 3; p >= 0; --p) {
            s[p] = b[p][4];
            for (int c = p + 1; c < 4; ++c) s[p] -= b[p][c] * s[c];
            s[p] /= b[p][p];
            explained += s[p] * a[p][4];
        }
        if (total - explained < least) {
            least = total - explained;
            best = kTwoPi / k;
        }
    }
    return best;
}

constexpr double kEdge = 0.663;  // Ai(0) / max Ai

/// Returns the half-angle of the wedge: the slope of the places where the envelope of the crests
/// has fallen to a share of its highest, outside of that [degrees].
double wedge_angle(const FilteredWake& wake, double length, double near, double far, double step,
                   double share = kEdge) {
    std::vector<double> xs, ys;
    for (double x = near; x < far; x += 0.25 * length) {
        std::vector<double> envelope;
        for (double y = step; y < 0.75 * far; y += step) {
            double top = 0.0;
            for (double along = x - 0.5 * length; along <= x + 0.5 * length; along += step) {
                top = std::max(top, std::abs(wake.height(-along, y)));
            }
            envelope.push_back(top);
        }
        const auto peak = std::ranges::max_element(envelope);
        const auto edge =
            std::find_if(peak, envelope.end(), [&](double e) { return e < share * *peak; });
        const double before = *(edge - 1);
        const double part = (before - share * *peak) / (before - *edge);
        xs.push_back(x);
        ys.push_back(step * (static_cast<double>(edge - envelope.begin()) + part));
    }
    return std::atan(slope_of(xs, ys)) / kDegree;
}

TEST(Wake, TransverseWavesAndTheWedgeAreKelvins) {
    ThreadPool pool;
    for (const double froude : {0.25, 0.32, 0.4, 0.5}) {
        const double speed = froude * std::sqrt(kGravity * 30.0);
        const double length = kTwoPi * speed * speed / kGravity;
        const double size = std::exp2(std::ceil(std::log2(52.0 * length)));
        const FilteredWake wake = cusp_wake(speed, size, pool);
        const double measured = transverse_length(wake, length, 15.0 + 2.0 * length, 0.4 * size);
        EXPECT_NEAR(measured / length, 1.0, 0.02) << froude;
        if (froude > 0.4) continue;
        EXPECT_NEAR(wedge_angle(wake, length, 6.0 * length, 0.5 * size, size / 512), 19.47, 0.5)
            << froude;
    }
}

// The waves of a disturbance with Gaussian sections of 10 m. [Rabaud 2013] saw the angle of the
// highest waves of ships fall as 1/Fr, and gave it the curve below.
TEST(Wake, TheHighestWavesOfFastHullsStandAtNarrowerAngles) {
    ThreadPool pool;
    constexpr double kSpread = 10.0 / kTwoPi, kSize = 320.0;
    const auto gaussian = [](double k, double, double) {
        return 1e4 * std::exp(-0.5 * k * k * kSpread * kSpread);
    };
    double before = 19.47;
    for (const double froude : {1.0, 1.5, 2.0, 2.5}) {
        const double speed = froude * std::sqrt(kGravity * 10.0);
        const FilteredWake wake = short_wake(speed, kSize, gaussian, pool);
        const double highest = wedge_angle(wake, 14.0, 60.0, 0.4 * kSize, kSize / 512, 1.0);
        const double square = kTwoPi * froude * froude;
        const double seen = std::atan(std::sqrt(square - 1.0) / (2.0 * square - 1.0)) / kDegree;
        EXPECT_LT(highest, before) << froude;
        EXPECT_NEAR(highest, seen, 0.25 * seen) << froude;
        before = highest;
    }
}

/// Returns Michell's resistance over rho [m^4/s^2] by the waves that a lattice holds.
double michell(const Hull& hull, double speed, double nyquist) {
    const double nu = kGravity / (speed * speed);
    constexpr int kSteps = 4000;
    constexpr double kEnd = 3.2;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double m = std::cosh((i + 0.5) / kSteps * kEnd);
        const double k = nu * m * m, along = nu * m;
        const double u = 0.5 * along * hull.length;
        const double water_line = 3.0 * (std::sin(u) - u * std::cos(u)) / (u * u * u);
        const double seen = 0.5 * hull_volume(hull) * water_line * down_hull(hull, k, 1e300) *
                            (1.0 - ease(0.8, 1.0, k / nyquist));
        sum += along * seen * along * seen * m * m;
    }
    return 4.0 * kGravity * kGravity / (kPi * speed * speed) * sum * kEnd / kSteps;
}

TEST(Wake, EnergyGainedPerMetreIsMichells) {
    ThreadPool pool;
    constexpr double kSize = 256.0;
    for (const HullShape shape : {HullShape::wall_sided, HullShape::wigley}) {
        for (const double froude : {0.32, 0.5, 1.0}) {
            const double speed = froude * std::sqrt(kGravity * 10.0);
            Hull hull = straight_hull(10.0, 1.0, 0.625, speed);
            auto track = std::make_shared<HullTrack>();
            track->rows = {{0.0, 0.0, 0.0}, {1000.0, 1000.0 * speed, 0.0}};
            hull.track = track;
            hull.shape = shape;
            hull.wake_size = kSize;
            hull.wake_resolution = 512;
            hull.wake_age = 3600.0;
            Wake wake(hull, deep_water(), 0.0, pool);
            std::vector<double> ways, energies;
            // All waves of such runs are where the window is 1.
            for (const double run : {0.24, 0.34, 0.44, 0.54}) {
                // Ticks of half a second would leave a part of a tick.
                wake.move_to(run * kSize / speed, false, pool);
                double energy = 0.0;
                const Modes modes = wake.modes();
                for (const auto& a : modes.cascades.front().h0) {
                    energy += static_cast<double>(std::norm(a));
                }
                ways.push_back(run * kSize);
                energies.push_back(2.0 * kGravity * kSize * kSize * energy);
            }
            const double nyquist = kPi * 512 / kSize;
            EXPECT_NEAR(slope_of(ways, energies) / michell(hull, speed, nyquist), 1.0, 0.01)
                << froude << ' ' << static_cast<int>(shape);
        }
    }
}

TEST(Wake, SupercriticalWavesStandAtTheAngleOfTheLongestOnes) {
    ThreadPool pool;
    constexpr double kDepth = 4.0, kSize = 768.0;
    Water water = deep_water();
    water.depth = kDepth;
    for (const double speed : {9.0, 12.0}) {
        Hull hull = straight_hull(24.0, 4.0, 1.0, speed);
        hull.wake_size = kSize;
        hull.wake_resolution = 512;
        hull.wake_age = 1.5 * kSize / speed;
        Wake wake(hull, water, 0.0, pool);
        wake.move_to(0.0, false, pool);
        const FilteredWake smooth(
            wake, [](double, double, double ky) { return std::exp(-0.5 * 2.25 * ky * ky); }, pool);
        std::vector<double> xs, ys;
        constexpr double kStep = kSize / 512;
        for (double x = 60.0; x < 300.0; x += 4.0) {
            std::vector<double> column;
            for (double y = 0.0; y < 0.49 * kSize; y += kStep)
                column.push_back(smooth.height(-x, y));
            const double highest = *std::ranges::max_element(column);
            std::size_t outermost = 0;
            for (std::size_t i = 1; i + 1 < column.size(); ++i) {
                if (column[i] > column[i - 1] && column[i] >= column[i + 1] &&
                    column[i] > 0.06 * highest) {
                    outermost = i;
                }
            }
            if (static_cast<double>(outermost) * kStep > 0.28 * kSize) continue;
            xs.push_back(x);
            ys.push_back(static_cast<double>(outermost) * kStep);
        }
        const double expected = std::asin(std::sqrt(kGravity * kDepth) / speed) / kDegree;
        EXPECT_NEAR(std::atan(slope_of(xs, ys)) / kDegree, expected, 0.5) << speed;
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
