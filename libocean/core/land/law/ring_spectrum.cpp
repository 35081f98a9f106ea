// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The spectrum of a grid in rings: see ring_spectrum.hpp.
//
// The density of a window of n_x x n_y heights h with weights w, samples dx and dy apart, is
//   S(kx, ky) = |sum w h exp(-i (kx x + ky y))|^2 dx dy / (4 pi^2 sum w^2)   [m^4].
// The window is padded with zeros to powers of two, which samples the same density at more
// wavenumbers and changes no mean, so that a model of any size is transformed as a whole.
#include "ocean/internal/ring_spectrum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/fft.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/page_vector.hpp"
#include "ring_sums.hpp"

namespace ocean {
namespace {

constexpr int kMinSquareSide = 16;
constexpr double kShareOfNyquist = 0.8;  // limit for a grid that exists once
constexpr double kMinCycles = 2.0;       // along the shorter side of such a grid

double sum_of_squares(const std::vector<double>& weights) {
    double sum = 0.0;
    for (const double w : weights) sum += w * w;
    return sum;
}

/// Returns the first samples of windows of `samples` that cover `count` and overlap by half or
/// more.
std::vector<int> window_starts(int count, int samples) {
    if (samples >= count) return {0};
    const int steps = (2 * (count - samples) + samples - 1) / samples;
    std::vector<int> starts;
    for (int i = 0; i <= steps; ++i) {
        starts.push_back(static_cast<int>(std::int64_t{count - samples} * i / steps));
    }
    return starts;
}

/// The least-squares plane mean + x slope_x + y slope_y; x and y in samples from the middle.
struct Plane {
    double mean = 0.0;
    double slope_x = 0.0;
    double slope_y = 0.0;
};

/// Transforms one window after another in the same memory.
class WindowTransform {
  public:
    WindowTransform(const Domain& domain, std::span<const float> heights,
                    const std::array<int, 2>& samples, bool hann, bool removes_plane,
                    const RingEdges& edges)
        : domain_(domain),
          heights_(heights),
          samples_(samples),
          removes_plane_(removes_plane),
          edges_(edges),
          row_fft_(padded(samples[0])),
          column_fft_(padded(samples[1])),
          weights_x_(taper_weights(samples[0], hann)),
          weights_y_(taper_weights(samples[1], hann)) {
        half_ = static_cast<std::size_t>(row_fft_.size() / 2 + 1);
        const std::size_t rows = static_cast<std::size_t>(samples[1]);
        require_memory(rows * half_ * sizeof(std::complex<double>),
                       "the transform of an elevation model");
        spectrum_.resize(rows * half_);
        columns_.resize(half_ * static_cast<std::size_t>(edges.count()));
    }

    /// Adds a window's density to the sums of the rings.
    void add(const std::array<int, 2>& first, ThreadPool& pool, std::vector<RingSums>& rings) {
        first_ = first;
        plane_ = plane_of_window();
        pool.for_each_range((samples_[1] + 1) / 2, [&](int begin, int end) {
            std::vector<std::complex<double>> pair(static_cast<std::size_t>(row_fft_.size()));
            for (int i = begin; i < end; ++i) transform_rows(2 * i, pair);
        });
        pool.for_each_range(static_cast<int>(half_), [&](int begin, int end) {
            std::vector<std::complex<double>> column(static_cast<std::size_t>(column_fft_.size()));
            for (int i = begin; i < end; ++i) add_column(i, column);
        });
        for (std::size_t i = 0; i < columns_.size(); ++i) rings[i % rings.size()].add(columns_[i]);
    }

    /// Returns the share of the waves of the padded transform that are independent.
    double independent_share() const {
        return static_cast<double>(samples_[0]) / row_fft_.size() * samples_[1] /
               column_fft_.size();
    }

  private:
    static int padded(int samples) {
        return static_cast<int>(std::bit_ceil(static_cast<unsigned>(samples)));
    }

    const float* row(int j) const {
        return heights_.data() +
               static_cast<std::size_t>(first_[1] + j) *
                   static_cast<std::size_t>(domain_.samples[0]) +
               static_cast<std::size_t>(first_[0]);
    }

    Plane plane_of_window() const {
        Plane plane;
        const double middle_x = 0.5 * (samples_[0] - 1), middle_y = 0.5 * (samples_[1] - 1);
        double squares_x = 0.0, squares_y = 0.0;
        for (int j = 0; j < samples_[1]; ++j) {
            const double y = j - middle_y;
            for (int i = 0; i < samples_[0]; ++i) {
                const double x = i - middle_x, h = double{row(j)[i]};
                plane.mean += h;
                plane.slope_x += x * h;
                plane.slope_y += y * h;
                squares_x += x * x;
                squares_y += y * y;
            }
        }
        plane.mean /= static_cast<double>(samples_[0]) * samples_[1];
        plane.slope_x = removes_plane_ ? plane.slope_x / squares_x : 0.0;
        plane.slope_y = removes_plane_ ? plane.slope_y / squares_y : 0.0;
        return plane;
    }

    double weighted_height(int i, int j) const {
        const double x = i - 0.5 * (samples_[0] - 1), y = j - 0.5 * (samples_[1] - 1);
        const double height =
            double{row(j)[i]} - plane_.mean - x * plane_.slope_x - y * plane_.slope_y;
        return height * weights_x_[static_cast<std::size_t>(i)] *
               weights_y_[static_cast<std::size_t>(j)];
    }

    /// Transforms the real rows j and j + 1 as the parts of one complex row.
    void transform_rows(int j, std::vector<std::complex<double>>& pair) {
        const bool has_second = j + 1 < samples_[1];
        std::ranges::fill(pair, 0.0);
        for (int i = 0; i < samples_[0]; ++i) {
            pair[static_cast<std::size_t>(i)] = {weighted_height(i, j),
                                                 has_second ? weighted_height(i, j + 1) : 0.0};
        }
        row_fft_.transform(pair.data(), 1, FftDirection::forward);
        for (std::size_t k = 0; k < half_; ++k) {
            const std::complex<double> here = pair[k];
            const std::complex<double> mirrored = std::conj(pair[k == 0 ? 0 : pair.size() - k]);
            std::complex<double>* const to = &spectrum_[static_cast<std::size_t>(j) * half_ + k];
            to[0] = 0.5 * (here + mirrored);
            if (has_second) to[half_] = std::complex<double>(0.0, -0.5) * (here - mirrored);
        }
    }

    /// Transforms a column and sums its densities. Columns between the first and the last one also
    /// count for their mirror images.
    void add_column(int i, std::vector<std::complex<double>>& column) {
        const std::size_t ring_count = static_cast<std::size_t>(edges_.count());
        const std::span<RingSums> rings(&columns_[static_cast<std::size_t>(i) * ring_count],
                                        ring_count);
        std::ranges::fill(rings, RingSums());
        std::ranges::fill(column, 0.0);
        for (std::size_t j = 0; j < static_cast<std::size_t>(samples_[1]); ++j) {
            column[j] = spectrum_[j * half_ + static_cast<std::size_t>(i)];
        }
        column_fft_.transform(column.data(), 1, FftDirection::forward);
        const int rows = column_fft_.size();
        const double weight = i == 0 || i == row_fft_.size() / 2 ? 1.0 : 2.0;
        const double density =
            domain_.step(0) * domain_.step(1) /
            (kTwoPi * kTwoPi * sum_of_squares(weights_x_) * sum_of_squares(weights_y_));
        const double kx = kTwoPi * i / (row_fft_.size() * domain_.step(0));
        for (int j = 0; j < rows; ++j) {
            const int n = j < rows / 2 ? j : j - rows;
            const double ky = kTwoPi * n / (rows * domain_.step(1));
            const double k = std::hypot(kx, ky);
            const int ring = edges_.ring_of(k);
            if (ring < 0) continue;
            rings[static_cast<std::size_t>(ring)].add(
                density * std::norm(column[static_cast<std::size_t>(j)]), std::log(k), weight);
        }
    }

    const Domain& domain_;
    std::span<const float> heights_;
    std::array<int, 2> samples_;
    bool removes_plane_;
    RingEdges edges_;
    Radix2Fft<double> row_fft_, column_fft_;
    std::vector<double> weights_x_, weights_y_;
    std::size_t half_ = 0;
    std::array<int, 2> first_{};
    Plane plane_;
    PageVector<std::complex<double>> spectrum_;  // of rows; kx from 0 to the Nyquist wavenumber
    std::vector<RingSums> columns_;              // the rings of each column
};

/// Returns the sides of the windows of a grid [samples].
std::array<int, 2> window_samples(const Domain& domain, const RingOptions& options) {
    std::array<int, 2> samples = domain.samples;
    if (domain.wraps) return samples;
    for (int& side : samples) side = std::min(side, options.max_side);
    return samples;
}

void check(const Domain& domain, std::span<const float> heights, const RingOptions& options) {
    const auto fail = [](const std::string& message) {
        return Error(ErrorKind::invalid_value, message);
    };
    for (const int side : domain.samples) {
        if (side < kMinSquareSide) {
            throw fail("a spectrum needs at least 16 samples along each side, not " +
                       std::to_string(side));
        }
        if (domain.wraps && !std::has_single_bit(static_cast<unsigned>(side))) {
            throw fail("the sides of a tile are powers of two, not " + std::to_string(side));
        }
    }
    if (heights.size() != domain.count()) {
        throw fail("there are " + std::to_string(heights.size()) + " heights for " +
                   std::to_string(domain.count()) + " samples");
    }
    if (options.max_side < kMinSquareSide ||
        !std::has_single_bit(static_cast<unsigned>(options.max_side)) ||
        options.rings_per_octave < 1 || options.rings_per_octave > 64) {
        throw fail("max_side must be a power of two of at least 16, rings_per_octave 1 .. 64");
    }
    if (!std::ranges::all_of(heights, [](float h) { return std::isfinite(h); })) {
        throw fail("a height is missing or not finite: holes must be filled before");
    }
}

}  // namespace

std::array<double, 2> ring_limits(const Domain& domain, const RingOptions& options) {
    const std::array<int, 2> samples = window_samples(domain, options);
    const double nyquist = kPi / std::max(domain.step(0), domain.step(1));
    const double side = std::min(samples[0] * domain.step(0), samples[1] * domain.step(1));
    if (!domain.wraps) return {kMinCycles * kTwoPi / side, kShareOfNyquist * nyquist};
    // The longest waves lie in the middle of the first ring.
    return {kTwoPi / side * std::exp2(-0.5 / options.rings_per_octave), nyquist};
}

std::vector<Ring> measure_rings(const Domain& domain, std::span<const float> heights,
                                ThreadPool& pool, const RingOptions& options) {
    check(domain, heights, options);
    const std::array<int, 2> samples = window_samples(domain, options);
    const bool hann =
        options.taper == Taper::automatic ? !domain.wraps : options.taper == Taper::hann;
    const auto [lowest, end] = options.limits.value_or(ring_limits(domain, options));
    const RingEdges edges{lowest, end, options.rings_per_octave};
    std::vector<RingSums> sums(static_cast<std::size_t>(std::max(edges.count(), 1)));
    WindowTransform transform(domain, heights, samples, hann, hann, edges);
    std::size_t windows = 0;
    for (const int y : window_starts(domain.samples[1], samples[1])) {
        for (const int x : window_starts(domain.samples[0], samples[0])) {
            transform.add({x, y}, pool, sums);
            ++windows;
        }
    }
    // The waves of the whole grid are half of the plane, since the other half repeats it.
    const double share = 0.5 * transform.independent_share() / static_cast<double>(windows) *
                         static_cast<double>(domain.count()) /
                         (static_cast<double>(samples[0]) * samples[1]);
    std::vector<Ring> rings;
    for (const RingSums& ring : sums) {
        if (ring.weight == 0.0) continue;
        rings.push_back(
            {std::exp(ring.log_k / ring.weight), ring.density / ring.weight, ring.weight * share});
    }
    return rings;
}

}  // namespace ocean
