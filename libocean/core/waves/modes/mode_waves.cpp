// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The waves of a lattice's modes: their variances by the spectrum, by quadrants and rows, and their
// amplitudes. A live tool repeats this while a user changes the wind.
#include <algorithm>
#include <cmath>

#include "ocean/thread_pool.hpp"
#include "waves/modes/mode_lattice.hpp"
#include "waves/modes/mode_rows_task.hpp"
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
    for (std::vector<double>& quarter : v) {
        quarter.resize(static_cast<std::size_t>(half));
        std::fill(quarter.begin(), quarter.begin() + row.begin, 0.0);
        std::fill(quarter.begin() + row.end, quarter.end(), 0.0);
    }
    // The first cells have several points, the others one each.
    const std::size_t several = row.points.size();
    std::size_t points = 0;
    for (const std::uint32_t cell : row.points) points += cell;
    const auto write = [&](std::size_t cell, const std::uint32_t* points_of, std::size_t count,
                           std::size_t first, std::size_t end) {
        const std::size_t n = static_cast<std::size_t>(row.begin) + cell;
        double* const to[4] = {v[0].data() + n, v[1].data() + n, v[2].data() + n, v[3].data() + n};
        spectrum.write_variances({.count = count,
                                  .points_of = points_of,
                                  .points = end - first,
                                  .omega = row.omega.data() + first,
                                  .direction = row.direction.data() + first,
                                  .weight = row.weight.data() + first},
                                 to);
    };
    const std::size_t end = row.omega.size();
    write(0, row.points.data(), several, 0, points);
    write(several, nullptr, end - points, points, end);
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

/// The variances of one row of modes, (n, m) and (-n, m), and those of them that have waves.
struct RowVariances {
    std::span<const double> east;
    std::span<const double> west;
    ModeRange waves_east = with_waves(east);
    ModeRange waves_west = with_waves(west);
};

/// Writes h0 of a row in FFT order.
void write_row(const RowVariances& row, std::span<const std::complex<float>> noise,
               std::span<std::complex<float>> h0) {
    std::fill(h0.begin(), h0.end(), std::complex<float>(0.0f));
    const auto write = [&](const double* variance, std::ptrdiff_t step, std::size_t first,
                           int count) {
        mode_row_loops(simd_level())
            .waves(variance, step, reinterpret_cast<const float*>(&noise[first]),
                   static_cast<std::size_t>(count), reinterpret_cast<float*>(&h0[first]));
    };
    if (const auto [begin, end] = row.waves_east; begin < end) {
        const auto first = static_cast<std::size_t>(begin);
        write(&row.east[first], 1, first, end - begin);
    }
    if (const auto [begin, end] = row.waves_west; begin < end) {
        const auto last = static_cast<std::size_t>(end - 1);
        write(&row.west[last], -1, h0.size() - last, end - begin);
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
    std::vector<std::complex<float>> noise;
};

/// Sums over rows of modes while their amplitudes are made: the covariance of the gradients of each
/// shell max(|n|, |m|) = s, and the variance of the modes that satisfy measures_band.
class ModeLattice::ShellSums {
  public:
    /// Begins sums of N/2 shells at 0, for rows from `first` on, whose shells those are from there
    /// on. measures: the modes' variance is needed.
    void start(int shells, int first, bool measures) {
        first_ = static_cast<std::size_t>(first);
        for (std::vector<double>& sum : sums_) {
            sum.assign(static_cast<std::size_t>(shells - first), 0.0);
        }
        measures_ = measures;
        measured_ = 0.0;
    }

    /// Adds the modes (+-n, m) and (+-n, -m), n < end, with their displacements [m].
    void add(const Lattice& lattice, int m, int end, const QuadrantVariances& variances,
             std::span<const float> displacement) {
        const auto& v = variances.quarter;
        double* const sums[kShellSums] = {sums_[0].data(), sums_[1].data(), sums_[2].data(),
                                          sums_[3].data(), sums_[4].data()};
        mode_row_loops(simd_level())
            .shells({.variance = {v[0].data(), v[1].data(), v[2].data(), v[3].data()},
                     .displacement = displacement.data(),
                     .step = lattice.wavenumber_step(),
                     .row = m,
                     .end = static_cast<std::size_t>(end)},
                    first_, sums);
        const auto row = static_cast<std::size_t>(m);
        const auto last = static_cast<std::size_t>(end);
        // This is the condition of measures_band: inside the circle of the Nyquist line.
        const std::size_t half = variances.quarter[0].size();
        for (std::size_t n = 0; measures_ && n < last && n * n + row * row < half * half; ++n) {
            measured_ += variances.sum(n);
        }
    }

    /// Adds sums over later rows.
    void add(const ShellSums& later) {
        measured_ += later.measured_;
        for (std::size_t i = 0; i < kShellSums; ++i) {
            double* const mine = sums_[i].data() + (later.first_ - first_);
            for (std::size_t s = 0; s < later.sums_[i].size(); ++s) mine[s] += later.sums_[i][s];
        }
    }

    double measured() const { return measured_; }
    GradientCovariance covariance(std::size_t s) const {
        const double ab = sums_[2][s];
        // c^2 = kx^2 ky^2 (coth(kd) / k)^2 = a b
        return {sums_[0][s], sums_[1][s], ab, ab, sums_[3][s], sums_[4][s]};
    }

  private:
    std::size_t first_ = 0;  // shell
    std::vector<double> sums_[kShellSums];
    bool measures_ = false;
    double measured_ = 0.0;  // variance, m^2
};

double ModeLattice::set_cascade(const Cascade& cascade, const QuadrantSampler& sampler,
                                ThreadPool& pool, CascadeModes& modes) const {
    const int half = cascade.lattice.resolution / 2;
    const int shares = std::min(kShares, half);
    std::vector<ShellSums> sums(static_cast<std::size_t>(shares));
    pool.for_each_range(shares, [&](int first, int last) {
        Work work;
        work.noise.resize(static_cast<std::size_t>(2 * half));
        for (int i = first; i < last; ++i) {
            const int share = i * kShareStride % shares;
            ShellSums& sum = sums[static_cast<std::size_t>(share)];
            const int begin = half * share / shares;
            sum.start(half, begin, parameters_.grid.cascades > 1);
            for (int m = begin; m < half * (share + 1) / shares; ++m) {
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
        const RowVariances variances{east, west};
        std::span<const std::complex<float>> noise = work.noise;
        if (kept_) {
            noise = std::span(cascade.noise).subspan(at, width);
        } else {
            draw_row(cascade, ky, variances.waves_east, variances.waves_west, work.noise);
        }
        write_row(variances, noise, std::span(modes.h0).subspan(at, width));
    };
    write(m, v[0], v[1]);
    if (m > 0) write(-m, v[3], v[2]);
    const auto at = static_cast<std::size_t>(m) * static_cast<std::size_t>(size);
    sums.add(cascade.lattice, m, row.end, work.variances,
             std::span(modes.displacement).subspan(at));
}

}  // namespace ocean
