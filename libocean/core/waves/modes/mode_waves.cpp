// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The waves of a lattice's modes: their variances by the spectrum, by quadrants and rows, and their
// amplitudes. A live tool repeats this while a user changes the wind.
#include <algorithm>
#include <cmath>

#include "ocean/thread_pool.hpp"
#include "waves/modes/mode_lattice.hpp"
#include "waves/modes/quadrant_sampler.hpp"

namespace ocean {

namespace {

// The number of parts does not depend on the number of threads, so that sums over the parts have
// the same bits. Rows near the origin, which take longest, are distributed by a stride.
constexpr int kShares = 64;
constexpr int kShareStride = 37;

void scale(CascadeModes& cascade, double gain, ThreadPool& pool) {
    if (gain == 1.0) return;
    const auto amplitude = static_cast<float>(std::sqrt(gain));
    pool.for_each_range(cascade.lattice.resolution, [&](int first, int last) {
        const auto width = static_cast<std::size_t>(cascade.lattice.resolution);
        const auto rows = std::span(cascade.h0)
                              .subspan(static_cast<std::size_t>(first) * width,
                                       static_cast<std::size_t>(last - first) * width);
        for (std::complex<float>& h0 : rows) h0 *= amplitude;
    });
    for (GradientCovariance& shell : cascade.shell_covariance) shell *= gain;
}

/// Adds the halves of modes on an axis, which are their own mirror images.
void join_axes(int m, QuadrantVariances& variances) {
    auto& v = variances.quarter;
    v[0][0] = v[0][0] + v[1][0];
    v[3][0] = v[2][0] + v[3][0];
    v[1][0] = 0.0;
    v[2][0] = 0.0;
    if (m > 0) return;
    for (std::size_t n = 0; n < v[0].size(); ++n) {
        v[0][n] = v[0][n] + v[3][n];
        v[1][n] = v[1][n] + v[2][n];
        v[2][n] = 0.0;
        v[3][n] = 0.0;
    }
}

/// Writes modal_variance of the modes of a row.
void row_variances(const QuadrantSampler& spectrum, const QuadrantRow& row, int m, int half,
                   QuadrantVariances& variances) {
    auto& v = variances.quarter;
    for (std::vector<double>& quarter : v) quarter.assign(static_cast<std::size_t>(half), 0.0);
    auto n = static_cast<std::size_t>(row.begin);
    std::size_t point = 0;
    for (const std::uint32_t points : row.points) {
        for (const std::size_t end = point + points; point < end; ++point) {
            const auto density = spectrum.density(row.omega[point], row.direction[point]);
            for (std::size_t q = 0; q < 4; ++q) v[q][n] += row.weight[point] * density[q];
        }
        ++n;
    }
    for (; n < static_cast<std::size_t>(row.end); ++n, ++point) {
        const auto density = spectrum.density(row.omega[point], row.direction[point]);
        for (std::size_t q = 0; q < 4; ++q) v[q][n] = row.weight[point] * density[q];
    }
    join_axes(m, variances);
}

/// Returns the range from the first to the last mode with waves: usually few waves run against the
/// wind.
ModeRange with_waves(std::span<const double> variances) {
    const auto any = [](double variance) { return variance > 0.0; };
    const auto first = std::find_if(variances.begin(), variances.end(), any);
    const auto last = std::find_if(variances.rbegin(), variances.rend(), any);
    return {static_cast<int>(first - variances.begin()), static_cast<int>(variances.rend() - last)};
}

/// Returns the amplitude of the real and of the imaginary part of h0, which share E |h0|^2 =
/// variance / 2 evenly.
double amplitude_of(double variance) {
    return 0.5 * std::sqrt(variance);
}

/// Writes h0 of the modes (n, m) and (-n, m), one row of the lattice in FFT order.
void write_row(std::span<const double> east, std::span<const double> west,
               std::span<const std::complex<float>> noise, std::span<double> amplitude,
               std::span<std::complex<float>> h0) {
    const std::size_t size = h0.size();
    const std::size_t half = size / 2;
    for (std::size_t n = 0; n < half; ++n) amplitude[n] = amplitude_of(east[n]);
    amplitude[half] = 0.0;
    for (std::size_t n = 1; n < half; ++n) amplitude[size - n] = amplitude_of(west[n]);
    for (std::size_t i = 0; i < size; ++i) {
        // Adding 0 turns minus zero into zero, for modes without waves.
        h0[i] = {static_cast<float>(amplitude[i] * static_cast<double>(noise[i].real())) + 0.0f,
                 static_cast<float>(amplitude[i] * static_cast<double>(noise[i].imag())) + 0.0f};
    }
}

}  // namespace

void ModeLattice::variances(const QuadrantSampler& spectrum, std::size_t cascade, int m,
                            QuadrantVariances& variances) const {
    QuadrantRow made;
    const QuadrantRow& row = row_of(cascades_[cascade], m, made);
    row_variances(spectrum, row, m, parameters_.grid.resolution / 2, variances);
}

std::vector<double> ModeLattice::set_waves(const DirectionalSpectrum& spectrum, double wind_speed,
                                           ThreadPool& pool, Modes& modes) const {
    modes.wind_speed = wind_speed;
    const QuadrantSampler sampler(spectrum);
    std::vector<double> gains;
    for (std::size_t c = 0; c < cascades_.size(); ++c) {
        const Cascade& cascade = cascades_[c];
        CascadeModes& waves = modes.cascades[c];
        const double measured = set_cascade(cascade, sampler, pool, waves);
        gains.push_back(band_gain(spectrum, parameters_, cascade.band, measured));
        scale(waves, gains.back(), pool);
    }
    return gains;
}

/// Work space of one thread.
struct ModeLattice::Work {
    QuadrantRow made;
    QuadrantVariances variances;
    std::vector<double> amplitude;
    std::vector<std::complex<float>> noise;
};

/// Sums over rows of modes while their amplitudes are made: the covariance of the gradients of each
/// shell max(|n|, |m|) = s, and the variance of the modes that satisfy measures_band.
class ModeLattice::ShellSums {
  public:
    /// Begins sums of N/2 shells at 0.
    void start(int shells) {
        shells_.assign(static_cast<std::size_t>(shells), {});
        measured_ = 0.0;
    }

    /// Adds the modes (+-n, m) and (+-n, -m), n < end, with their displacements [m].
    void add(const Lattice& lattice, int m, int end, const QuadrantVariances& variances,
             std::span<const float> displacement) {
        const auto& v = variances.quarter;
        const double step = lattice.wavenumber_step();
        const double ky = step * m;
        const auto add_modes = [&](std::size_t n, GradientCovariance& sum) {
            const double kx = step * static_cast<double>(n);
            const double square = static_cast<double>(displacement[n]) * displacement[n];
            const double all = square * (v[0][n] + v[1][n] + v[2][n] + v[3][n]);
            const double skew = square * (v[0][n] - v[1][n] + v[2][n] - v[3][n]) * kx * ky;
            sum.aa += all * (kx * kx) * (kx * kx);
            sum.bb += all * (ky * ky) * (ky * ky);
            sum.ab += all * (kx * kx) * (ky * ky);
            sum.ac += skew * (kx * kx);
            sum.bc += skew * (ky * ky);
        };
        const auto row = static_cast<std::size_t>(m);
        const auto last = static_cast<std::size_t>(end);
        GradientCovariance own;
        for (std::size_t n = 0; n <= row && n < last; ++n) add_modes(n, own);
        shells_[row] += own;
        for (std::size_t n = row + 1; n < last; ++n) add_modes(n, shells_[n]);
        // This is the condition of measures_band: inside the circle of the Nyquist line.
        const std::size_t half = v[0].size();
        for (std::size_t n = 0; n < last && n * n + row * row < half * half; ++n) {
            measured_ += variances.sum(n);
        }
    }

    void add(const ShellSums& other) {
        measured_ += other.measured_;
        for (std::size_t s = 0; s < shells_.size(); ++s) shells_[s] += other.shells_[s];
    }

    double measured() const { return measured_; }
    GradientCovariance covariance(std::size_t s) const {
        GradientCovariance covariance = shells_[s];
        covariance.cc = covariance.ab;  // c^2 = kx^2 ky^2 (coth(kd) / k)^2 = a b
        return covariance;
    }

  private:
    double measured_ = 0.0;  // variance, m^2
    std::vector<GradientCovariance> shells_;
};

double ModeLattice::set_cascade(const Cascade& cascade, const QuadrantSampler& sampler,
                                ThreadPool& pool, CascadeModes& modes) const {
    const int half = cascade.lattice.resolution / 2;
    const int shares = std::min(kShares, half);
    std::vector<ShellSums> sums(static_cast<std::size_t>(shares));
    pool.for_each_range(shares, [&](int first, int last) {
        Work work;
        work.amplitude.resize(static_cast<std::size_t>(2 * half));
        work.noise.resize(static_cast<std::size_t>(2 * half));
        for (int i = first; i < last; ++i) {
            const int share = i * kShareStride % shares;
            ShellSums& sum = sums[static_cast<std::size_t>(share)];
            sum.start(half);
            for (int m = half * share / shares; m < half * (share + 1) / shares; ++m) {
                set_row(cascade, sampler, m, work, sum, modes);
            }
        }
    });
    for (std::size_t i = 1; i < sums.size(); ++i) sums.front().add(sums[i]);
    for (std::size_t s = 0; s < modes.shell_covariance.size(); ++s) {
        modes.shell_covariance[s] = sums.front().covariance(s);
    }
    return sums.front().measured();
}

void ModeLattice::set_row(const Cascade& cascade, const QuadrantSampler& sampler, int m, Work& work,
                          ShellSums& sums, CascadeModes& modes) const {
    const int size = cascade.lattice.resolution;
    const QuadrantRow& row = row_of(cascade, m, work.made);
    row_variances(sampler, row, m, size / 2, work.variances);
    const auto& v = work.variances.quarter;
    const auto write = [&](int ky, std::span<const double> east, std::span<const double> west) {
        const auto width = static_cast<std::size_t>(size);
        const std::size_t at = static_cast<std::size_t>(fft_index(ky, size)) * width;
        std::span<const std::complex<float>> noise = work.noise;
        if (kept_) {
            noise = std::span(cascade.noise).subspan(at, width);
        } else {
            draw_row(cascade, ky, with_waves(east), with_waves(west), work.noise);
        }
        write_row(east, west, noise, work.amplitude, std::span(modes.h0).subspan(at, width));
    };
    write(m, v[0], v[1]);
    if (m > 0) write(-m, v[3], v[2]);
    const auto at = static_cast<std::size_t>(m) * static_cast<std::size_t>(size);
    sums.add(cascade.lattice, m, row.end, work.variances,
             std::span(modes.displacement).subspan(at));
}

}  // namespace ocean
