// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Double-precision fields, straight from the definitions, and the distance of a frame from them.
#include "judge.hpp"

#include <fftw3.h>

#include <cmath>
#include <complex>

#include "waves/synthesis/synthesis.hpp"

namespace ocean::bench {

namespace {

using Complex = std::complex<double>;

/// h(k, t) over the half plane of kx >= 0.
std::vector<Complex> height_spectrum(const Modes& modes, double time) {
    const CascadeModes& cascade = modes.cascades.front();
    const int n = cascade.lattice.resolution;
    const auto width = static_cast<std::size_t>(n);
    const double tau = modes.tau(time);
    std::vector<Complex> spectrum;
    spectrum.reserve(width * (width / 2 + 1));
    for (int j = 0; j < n; ++j) {
        const std::size_t row = static_cast<std::size_t>(j) * width;
        const std::size_t mirror_row = static_cast<std::size_t>(mirror_index(j, n)) * width;
        for (int i = 0; i <= n / 2; ++i) {
            const std::size_t at = row + static_cast<std::size_t>(i);
            const std::size_t mirror = mirror_row + static_cast<std::size_t>(mirror_index(i, n));
            const double turns = (static_cast<double>(cascade.rate_high[at]) +
                                  static_cast<double>(cascade.rate_low[at])) *
                                 tau;
            const Complex turn = std::polar(1.0, kTwoPi * (turns - std::floor(turns)));
            spectrum.push_back(Complex(cascade.h0[at]) * std::conj(turn) +
                               std::conj(Complex(cascade.h0[mirror])) * turn);
        }
    }
    return spectrum;
}

std::vector<Complex> field_spectrum(const CascadeModes& cascade, const std::vector<Complex>& height,
                                    Linear field) {
    const int n = cascade.lattice.resolution;
    const double step = cascade.lattice.wavenumber_step();
    const LinearShape shape = linear_shape(field);
    std::vector<Complex> spectrum(height.size());
    std::size_t to = 0;
    for (int j = 0; j < n; ++j) {
        const double ky = step * signed_wavenumber(j, n);
        for (int i = 0; i <= n / 2; ++i, ++to) {
            const double kx = step * i;
            double factor = shape.sign * std::pow(kx, shape.x_power) * std::pow(ky, shape.y_power);
            if (shape.displacement) {
                factor *=
                    cascade.displacement[static_cast<std::size_t>(j) * static_cast<std::size_t>(n) +
                                         static_cast<std::size_t>(i)];
            }
            const Complex h = height[to];
            spectrum[to] = shape.odd ? Complex(-factor * h.imag(), factor * h.real()) : factor * h;
        }
    }
    return spectrum;
}

/// Root of a sum of squares over another.
struct Distance {
    double error = 0.0;
    double size = 0.0;

    void add(double value, double right) {
        error += (value - right) * (value - right);
        size += right * right;
    }
    double relative() const { return std::sqrt(error / size); }
};

double sample(const FieldView& view, std::size_t j, std::size_t i) {
    return view.factor * static_cast<double>(view.data[static_cast<std::ptrdiff_t>(j) * view.row +
                                                       static_cast<std::ptrdiff_t>(i) * view.step]);
}

}  // namespace

Judge::Judge(const Sea& sea, double time)
    : time_(time), n_(static_cast<std::size_t>(sea.modes.lattice.resolution)) {
    const int n = sea.modes.lattice.resolution;
    const std::vector<Complex> height = height_spectrum(sea.modes, time);
    for (const Linear field : fields_of(FrameKind::planar)) {
        std::vector<Complex> spectrum = field_spectrum(sea.modes.cascades.front(), height, field);
        std::vector<double>& plane = planes_.emplace_back(n_ * n_);
        const fftw_plan plan =
            fftw_plan_dft_c2r_2d(n, n, reinterpret_cast<fftw_complex*>(spectrum.data()),
                                 plane.data(), FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
        fftw_execute(plan);
        fftw_destroy_plan(plan);
    }
}

double Judge::field_error(const FieldView& view, Linear field) const {
    const std::vector<double>& right = planes_[static_cast<std::size_t>(field)];
    double error = 0.0;
    double size = 0.0;
#pragma omp parallel for reduction(+ : error, size)
    for (std::size_t j = 0; j < n_; ++j) {
        Distance distance;
        for (std::size_t i = 0; i < n_; ++i) distance.add(sample(view, j, i), right[j * n_ + i]);
        error += distance.error;
        size += distance.size;
    }
    return Distance{error, size}.relative();
}

/// (-slope, 1) / |(-slope, 1)|.
double Judge::normal_error(const Subject& subject) const {
    const FieldView x = subject.normal(Channel::nx);
    const FieldView y = subject.normal(Channel::ny);
    const FieldView z = subject.normal(Channel::nz);
    const std::vector<double>& slope_x = planes_[static_cast<std::size_t>(Linear::slope_x)];
    const std::vector<double>& slope_y = planes_[static_cast<std::size_t>(Linear::slope_y)];
    Distance distance_x, distance_y, distance_z;
    for (std::size_t j = 0; j < n_; ++j) {
        for (std::size_t i = 0; i < n_; ++i) {
            const double sx = slope_x[j * n_ + i];
            const double sy = slope_y[j * n_ + i];
            const double unit = 1.0 / std::sqrt(1.0 + sx * sx + sy * sy);
            distance_x.add(sample(x, j, i), -sx * unit);
            distance_y.add(sample(y, j, i), -sy * unit);
            distance_z.add(sample(z, j, i), unit);
        }
    }
    return std::sqrt(std::pow(distance_x.relative(), 2) + std::pow(distance_y.relative(), 2) +
                     std::pow(distance_z.relative(), 2));
}

double Judge::error(const Subject& subject, FrameKind kind) const {
    double worst = kind == FrameKind::vertices ? normal_error(subject) : 0.0;
    for (const Linear field : fields_of(kind)) {
        const FieldView view = subject.field(field);
        if (view.data == nullptr) continue;
        const double error = field_error(view, field);
        if (!(error <= worst)) worst = error;  // also what is not a number
    }
    return worst;
}

}  // namespace ocean::bench
