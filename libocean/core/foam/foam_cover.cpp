// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How much of the water foam covers: the power of it whose mean is that of the whitecaps. Foam is
// the maximum of a past, and no formula has the mean of a power of that; it is found by following
// the gradients of the displacement at single labels, as the foam's clock would.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "foam/jacobian_nodes.hpp"
#include "modes/noise_row.hpp"
#include "modes/noise_streams.hpp"
#include "ocean/cascades.hpp"
#include "ocean/dispersion.hpp"
#include "ocean/fft.hpp"
#include "ocean/foam.hpp"
#include "ocean/grid.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

constexpr double kMostPower = 1e4;

/// A stretch of a label's life that closes on itself: the loop, or many times as long as foam
/// counts.
struct Stretch {
    int ticks;       // a power of two
    double seconds;  // of them all
    int reach;       // ticks after which what a power leaves of foam is nothing

    double step() const { return seconds / ticks; }
};

Stretch stretch_of(const FoamClock& clock, double lifetime) {
    constexpr double kReach = 2.5;  // lifetimes
    constexpr double kLeast = 200;  // s: waves that differ by less are not told apart
    constexpr int kMost = 1 << 17;
    const auto ticks_for = [](double wanted) {
        int ticks = 64;
        while (ticks < wanted && ticks < kMost) ticks *= 2;
        return ticks;
    };
    const double reach = kReach * lifetime;
    const bool loops = clock.loop_period > 0.0 && clock.loop_period < kLeast;
    const int ticks =
        ticks_for((loops ? clock.loop_period : std::max(4.0 * reach, kLeast)) / clock.step);
    const double seconds = loops ? clock.loop_period : ticks * clock.step;
    const double reached = std::ceil(reach / (seconds / ticks));
    return {ticks, seconds, static_cast<int>(std::clamp(reached, 1.0, ticks - 1.0))};
}

/// Variance of a + b, which is that of any axes.
double divergence(const GradientCovariance& v) {
    return v.aa + v.bb + 2.0 * v.ab;
}

/// The gradients at a label over a stretch of time, in the principal axes: a stationary Gaussian
/// process, each wave of which moves a, b and c in step.
class GradientProcess {
  public:
    /// `covariance`: of the map's modes, which may differ a little from the integral.
    GradientProcess(const ShownSea& sea, const GradientCovariance& covariance,
                    const Stretch& stretch)
        : fft_(stretch.ticks) {
        std::vector<GradientCovariance> bins = spectrum(sea, principal_angle(covariance), stretch);
        GradientCovariance sum;
        for (const GradientCovariance& bin : bins) sum += bin;
        const double whole = divergence(sum);
        const double scale = whole > 0.0 ? divergence(covariance) / whole : 0.0;
        for (GradientCovariance& bin : bins) bin *= scale;
        sum *= scale;
        covariance_ = sum;
        still_ = GradientFactors(sum);
        for (const GradientCovariance& bin : bins) factors_.emplace_back(bin);
        const auto lag_of = [&](double GradientCovariance::*part) {
            std::vector<std::complex<double>> of_bins;
            for (const GradientCovariance& bin : bins) of_bins.emplace_back(bin.*part);
            return transformed(std::move(of_bins));
        };
        lags_.resize(static_cast<std::size_t>(stretch.ticks));
        for (const auto part :
             {&GradientCovariance::aa, &GradientCovariance::bb, &GradientCovariance::cc,
              &GradientCovariance::ab, &GradientCovariance::ac, &GradientCovariance::bc}) {
            const auto lags = lag_of(part);
            for (std::size_t t = 0; t < lags.size(); ++t) lags_[t].*part = lags[t].real();
        }
    }

    struct Gradients {
        double a, b, c;
    };

    const GradientCovariance& covariance() const { return covariance_; }

    /// Two stretches that are as good as independent, of the number's own noise.
    std::array<std::vector<Gradients>, 2> draw(std::uint32_t number) const {
        std::array<std::vector<std::complex<float>>, 3> noise;
        for (int i = 0; i < 3; ++i) {
            noise[static_cast<std::size_t>(i)].resize(factors_.size());
            noise_row(number, noise_stream(NoiseStream::foam_cover), 0, i,
                      noise[static_cast<std::size_t>(i)]);
        }
        std::array<std::vector<std::complex<double>>, 3> series;
        for (auto& one : series) one.resize(factors_.size());
        for (std::size_t i = 0; i < factors_.size(); ++i) {
            const GradientFactors& f = factors_[i];
            const std::complex<double> x(noise[0][i]), y(noise[1][i]), z(noise[2][i]);
            series[0][i] = f.a1 * x + f.a2 * y + f.a3 * z;
            series[1][i] = f.b1 * x;
            series[2][i] = f.c1 * x + f.c2 * y;
        }
        for (auto& one : series) one = transformed(std::move(one));
        std::array<std::vector<Gradients>, 2> drawn;
        for (std::size_t t = 0; t < series[0].size(); ++t) {
            drawn[0].push_back({series[0][t].real(), series[1][t].real(), series[2][t].real()});
            drawn[1].push_back({series[0][t].imag(), series[1][t].imag(), series[2][t].imag()});
        }
        return drawn;
    }

    /// The stretch from `reach` ticks before a tick to `reach` behind it as it is where it is `at`
    /// there: x(t) + R(t - s) R(0)^-1 (at - x(s)).
    void passing(const Gradients& at, std::size_t tick, int reach,
                 std::span<const Gradients> stretch, std::vector<Gradients>& window) const {
        const std::size_t ticks = stretch.size();
        const Gradients& there = stretch[tick];
        // R(0) = F F^T: two triangles.
        const auto over = [](double x, double divisor) {
            return divisor > 0.0 ? x / divisor : 0.0;
        };
        const GradientFactors& f = still_;
        const double x = over(at.b - there.b, f.b1);
        const double y = over(at.c - there.c - f.c1 * x, f.c2);
        const double z = over(at.a - there.a - f.a1 * x - f.a2 * y, f.a3);
        const double a = over(z, f.a3);
        const double c = over(y - f.a2 * a, f.c2);
        const double b = over(x - f.a1 * a - f.c1 * c, f.b1);
        window.clear();
        for (int i = -reach; i <= reach; ++i) {
            const auto behind = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(ticks) + i);
            const GradientCovariance& lag = lags_[behind % ticks];
            Gradients now = stretch[(tick + behind) % ticks];
            now.a += lag.aa * a + lag.ab * b + lag.ac * c;
            now.b += lag.ab * a + lag.bb * b + lag.bc * c;
            now.c += lag.ac * a + lag.bc * b + lag.cc * c;
            window.push_back(now);
        }
    }

  private:
    /// The variance of each whole number of turns in a stretch, 0 .. ticks/2, of the waves that the
    /// map holds; what is faster than the clock tells apart is where the clock sees it.
    static std::vector<GradientCovariance> spectrum(const ShownSea& sea, double angle,
                                                    const Stretch& stretch) {
        constexpr int kDirections = 72;
        constexpr int kFrequencies = 2048;
        const Dispersion dispersion(sea.parameters.water);
        const SurfaceSettings& limits = sea.parameters.surface;
        const double nyquist = kTwoPi / shortest_wave(sea.parameters.grid, sea.resolution) *
                               (1.0 - 1.0 / sea.resolution);
        const double turn = kTwoPi / stretch.seconds;
        const double fastest = dispersion.angular_frequency(std::sqrt(2.0) * nyquist);
        const int parts = std::clamp(static_cast<int>(kFrequencies * turn / fastest), 1, 64);
        const double width = turn / parts;
        std::vector<GradientCovariance> bins(static_cast<std::size_t>(stretch.ticks / 2 + 1));
        for (int i = 0; width * i < fastest; ++i) {
            const double omega = width * (i + 0.5);
            const double k = dispersion.wavenumber(omega);
            const double length = kTwoPi / k;
            if (length < limits.shortest_wavelength) break;
            if (limits.longest_wavelength > 0.0 && length > limits.longest_wavelength) continue;
            const double size = k * dispersion.horizontal_displacement(k);
            const auto turns = static_cast<std::int64_t>(std::round(omega / turn));
            const std::int64_t seen = turns % stretch.ticks;
            const std::int64_t folded = std::min<std::int64_t>(seen, stretch.ticks - seen);
            GradientCovariance& bin =
                bins[static_cast<std::size_t>(std::max<std::int64_t>(folded, 1))];
            for (int j = 0; j < kDirections; ++j) {
                const double theta = kTwoPi * j / kDirections;
                if (k * std::max(std::abs(std::cos(theta)), std::abs(std::sin(theta))) >= nyquist) {
                    continue;
                }
                const double variance =
                    sea.spectrum.density(omega, theta) * width * kTwoPi / kDirections;
                const double x = std::cos(theta - angle), y = std::sin(theta - angle);
                const double a = size * x * x, b = size * y * y, c = size * x * y;
                bin += {variance * a * a, variance * b * b, variance * c * c,
                        variance * a * b, variance * a * c, variance * b * c};
            }
        }
        return bins;
    }

    /// The sum over the bins at each tick.
    std::vector<std::complex<double>> transformed(std::vector<std::complex<double>> bins) const {
        bins.resize(static_cast<std::size_t>(fft_.size()));
        fft_.transform(bins.data(), 1, FftDirection::inverse);
        return bins;
    }

    Radix2Fft<double> fft_;
    GradientCovariance covariance_;
    GradientFactors still_{{}};             // of it
    std::vector<GradientFactors> factors_;  // of each bin
    std::vector<GradientCovariance> lags_;  // [tick]: of the gradients now and then
};

/// P(Z > z).
double upper_tail(double z) {
    return 0.5 * std::erfc(z / std::sqrt(2.0));
}

/// z with P(Z > z) = share P(Z > from).
double beyond(double from, double share) {
    const double wanted = share * upper_tail(from);
    double low = from, high = from + 10.0;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (upper_tail(middle) > wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Gradients where there is a whitecap, as they are found at a label that has one.
class WhitecapGradients {
  public:
    WhitecapGradients(const GradientCovariance& covariance, double choppiness, double threshold)
        : factors_(covariance),
          threshold_(threshold),
          nodes_(jacobian_nodes(covariance, choppiness)) {
        double sum = 0.0;
        for (const JacobianNode& node : nodes_) {
            const double depth = threshold - node.mean;
            const double share = node.slope != 0.0 ? upper_tail(-depth / std::abs(node.slope))
                                                   : (depth > 0.0 ? 1.0 : 0.0);
            up_to_.push_back(sum += node.weight * share);
        }
    }

    bool any() const { return up_to_.back() > 0.0; }

    /// Of two shares in (0, 1).
    GradientProcess::Gradients at(double of_nodes, double of_depth) const {
        const auto found = std::ranges::upper_bound(up_to_, of_nodes * up_to_.back());
        const auto i =
            std::min(static_cast<std::size_t>(found - up_to_.begin()), nodes_.size() - 1);
        const JacobianNode& node = nodes_[i];
        double z = 0.0;
        if (node.slope != 0.0) {
            const double size = std::abs(node.slope);
            z = -std::copysign(1.0, node.slope) * beyond((node.mean - threshold_) / size, of_depth);
        }
        const GradientFactors& f = factors_;
        return {f.a1 * node.x + f.a2 * node.y + f.a3 * z, f.b1 * node.x,
                f.c1 * node.x + f.c2 * node.y};
    }

  private:
    GradientFactors factors_;
    double threshold_;
    std::vector<JacobianNode> nodes_;
    std::vector<double> up_to_;  // the share of whitecaps at this node and those before
};

/// How often foam is how much: by its age, -ln F.
class FoamAges {
  public:
    void add(double age, double weight) {
        const auto bin = static_cast<std::size_t>(kPerRoot * std::sqrt(age));
        weights_[std::min(bin, weights_.size() - 1)] += weight;
    }
    void add(const FoamAges& other) {
        for (std::size_t i = 0; i < weights_.size(); ++i) weights_[i] += other.weights_[i];
    }
    /// The sum of F^power.
    double sum(double power) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < weights_.size(); ++i) {
            const double root = (static_cast<double>(i) + 0.5) / kPerRoot;
            // Whole whitecaps are a step of the distribution.
            sum += weights_[i] * (i == 0 ? 1.0 : std::exp(-power * root * root));
        }
        return sum;
    }

  private:
    static constexpr double kPerRoot = 500.0;
    std::array<double, 1252> weights_{};  // to ln 512, beyond which there is no foam
};

/// What labels say that have a whitecap.
struct Followed {
    FoamAges foam;
    double whitecap = 0.0;

    void add(const Followed& other) {
        foam.add(other.foam);
        whitecap += other.whitecap;
    }
};

/// Follows labels through a whitecap in the middle of a window.
class Follower {
  public:
    /// `aging`: of foam in a tick.
    Follower(const SurfaceSettings& shown, int reach, double aging)
        : shown_(shown), reach_(static_cast<std::size_t>(reach)), aging_(aging) {}

    /// E[F^n] is the sum, over the ticks s of its last `reach`, of E[F^n / N; W(s) > 0], N how many
    /// of them have W > 0: each whitecap counts for its share in all that follows it.
    void follow(std::span<const GradientProcess::Gradients> window, Followed& followed) {
        const double c = shown_.choppiness;
        fresh_.clear();
        whitecaps_.clear();
        for (const auto& g : window) {
            const double jacobian = (1.0 - c * g.a) * (1.0 - c * g.b) - c * c * g.c * g.c;
            const double depth = (shown_.foam_threshold - jacobian) / shown_.foam_width;
            whitecaps_.push_back(std::clamp(depth, 0.0, 1.0));
            fresh_.push_back(depth <= 0.0 ? kNone : depth >= 1.0 ? 0.0 : -std::log(depth));
        }
        if (fresh_[reach_] == kNone) return;  // by rounding alone
        // The waves' statistics are the same backwards in time.
        add(followed);
        std::ranges::reverse(fresh_);
        std::ranges::reverse(whitecaps_);
        add(followed);
    }

  private:
    static constexpr double kNone = 1e9;

    void add(Followed& followed) const {
        double age = kNone;
        int whitecaps = 0;
        for (std::size_t t = 0; t < fresh_.size(); ++t) {
            age = std::min(fresh_[t], age + aging_);
            whitecaps += fresh_[t] != kNone ? 1 : 0;
            if (t < reach_) continue;
            followed.foam.add(age, 1.0 / whitecaps);
            followed.whitecap += whitecaps_[t] / whitecaps;
            whitecaps -= fresh_[t - reach_] != kNone ? 1 : 0;
        }
    }

    const SurfaceSettings& shown_;
    std::size_t reach_;
    double aging_;
    std::vector<double> whitecaps_;
    std::vector<double> fresh_;  // the age of whitecaps as foam
};

}  // namespace

double cover_power(const ShownSea& sea, const GradientCovariance& covariance, ThreadPool& pool) {
    const SurfaceSettings& shown = sea.parameters.surface;
    const bool squeezed = shown.choppiness > 0.0 && covariance.aa + covariance.bb > 0.0;
    if (!squeezed || shown.foam_lifetime <= 0.0) return 1.0;
    const Stretch stretch =
        stretch_of(foam_clock(shown, sea.parameters.time.loop_period), shown.foam_lifetime);
    const GradientProcess process(sea, covariance, stretch);
    const WhitecapGradients whitecaps(process.covariance(), shown.choppiness, shown.foam_threshold);
    if (!whitecaps.any()) return 1.0;
    // Two stretches a draw, and whitecaps in them that know little of each other.
    constexpr int kDraws = 256;
    constexpr int kWindows = 64;
    constexpr int kTicks = 1 << 23;
    const int draws = std::clamp(kTicks / (2 * stretch.reach * kWindows), 4, kDraws);
    const double aging = stretch.step() / shown.foam_lifetime;
    std::vector<Followed> parts(static_cast<std::size_t>(draws));
    pool.for_each_item(draws, [&](int draw, int) {
        const auto stretches = process.draw(static_cast<std::uint32_t>(draw));
        Follower follower(shown, stretch.reach, aging);
        std::vector<GradientProcess::Gradients> window;
        for (int i = 0; i < kWindows; ++i) {
            const auto tick =
                static_cast<std::size_t>(static_cast<std::int64_t>(i) * stretch.ticks / kWindows);
            // Places of the two-dimensional golden ratio: as even as a lattice, for any number.
            const double number = draw * kWindows + i + 0.5;
            const double of_nodes = number * 0.7548776662466927;
            const double of_depth = number * 0.5698402909980532;
            process.passing(
                whitecaps.at(of_nodes - std::floor(of_nodes), of_depth - std::floor(of_depth)),
                tick, stretch.reach, stretches[static_cast<std::size_t>(i % 2)], window);
            follower.follow(window, parts[static_cast<std::size_t>(draw)]);
        }
    });
    Followed all;
    for (const Followed& part : parts) all.add(part);
    double low = 0.0, high = std::log(kMostPower);
    if (all.foam.sum(1.0) <= all.whitecap) return 1.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (all.foam.sum(std::exp(middle)) > all.whitecap ? low : high) = middle;
    }
    return std::exp(0.5 * (low + high));
}

}  // namespace ocean
