// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "waves/foam/gradient_process.hpp"

#include <algorithm>
#include <cmath>

#include "base/noise_row.hpp"
#include "base/noise_streams.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean {
namespace {

/// Returns the variance of a + b, which does not depend on the axes.
double divergence(const GradientCovariance& v) {
    return v.aa + v.bb + 2.0 * v.ab;
}

/// Returns the wavenumber along x and y below which a map of that resolution holds waves [rad/m].
double held_below(const FoamSea& sea, int resolution) {
    return kTwoPi / shortest_wave(sea.parameters.grid, resolution) * (1.0 - 1.0 / resolution);
}

/// Returns the variance of the band's waves at each whole number of turns in a stretch, 0 ..
/// ticks/2. Waves too fast for the clock appear at the frequency at which the clock samples them.
std::vector<GradientCovariance> spectrum(const FoamSea& sea, const WaveBand& band, double angle,
                                         const Stretch& stretch) {
    constexpr int kDirections = 72;
    constexpr int kFrequencies = 2048;
    const Dispersion dispersion(sea.parameters.water);
    const SurfaceSettings& limits = sea.parameters.surface;
    const double nyquist = held_below(sea, band.held_by);
    const double left_out = band.not_by > 0 ? held_below(sea, band.not_by) : 0.0;
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
        GradientCovariance& bin = bins[static_cast<std::size_t>(std::max<std::int64_t>(folded, 1))];
        for (int j = 0; j < kDirections; ++j) {
            const double theta = kTwoPi * j / kDirections;
            const double along = k * std::max(std::abs(std::cos(theta)), std::abs(std::sin(theta)));
            if (along >= nyquist || along < left_out) continue;
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

}  // namespace

Stretch stretch_of(const FoamClock& clock, double lifetime) {
    constexpr double kReach = 2.5;       // lifetimes
    constexpr double kMinSeconds = 200;  // [s]; shorter stretches would not separate waves
    constexpr int kMax = 1 << 17;
    const auto ticks_for = [](double wanted) {
        int ticks = 64;
        while (ticks < wanted && ticks < kMax) ticks *= 2;
        return ticks;
    };
    const double reach = kReach * lifetime;
    const bool loops = clock.loop_period > 0.0 && clock.loop_period < kMinSeconds;
    const int ticks =
        ticks_for((loops ? clock.loop_period : std::max(4.0 * reach, kMinSeconds)) / clock.step);
    const double seconds = loops ? clock.loop_period : ticks * clock.step;
    const double reached = std::ceil(reach / (seconds / ticks));
    return {ticks, seconds, static_cast<int>(std::clamp(reached, 1.0, ticks - 1.0))};
}

GradientProcess::GradientProcess(const FoamSea& sea, const WaveBand& band,
                                 const GradientCovariance& covariance, double angle,
                                 const Stretch& stretch)
    : fft_(stretch.ticks) {
    std::vector<GradientCovariance> bins = spectrum(sea, band, angle, stretch);
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

std::array<std::vector<Gradients>, 2> GradientProcess::draw(std::uint32_t number, int part) const {
    std::array<std::vector<std::complex<float>>, 3> noise;
    for (int i = 0; i < 3; ++i) {
        noise[static_cast<std::size_t>(i)].resize(factors_.size());
        noise_row(number, noise_stream(NoiseStream::foam_cover), 0, 3 * part + i,
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

void GradientProcess::passing(const Gradients& at, std::size_t tick, int reach,
                              std::span<const Gradients> stretch,
                              std::vector<Gradients>& window) const {
    const std::size_t ticks = stretch.size();
    const Gradients& drawn = stretch[tick];
    // R(0) = F F^T: two triangles.
    const auto over = [](double x, double divisor) { return divisor > 0.0 ? x / divisor : 0.0; };
    const GradientFactors& f = still_;
    const double x = over(at.b - drawn.b, f.b1);
    const double y = over(at.c - drawn.c - f.c1 * x, f.c2);
    const double z = over(at.a - drawn.a - f.a1 * x - f.a2 * y, f.a3);
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

std::vector<std::complex<double>> GradientProcess::transformed(
    std::vector<std::complex<double>> bins) const {
    bins.resize(static_cast<std::size_t>(fft_.size()));
    fft_.transform(bins.data(), 1, FftDirection::inverse);
    return bins;
}

}  // namespace ocean
