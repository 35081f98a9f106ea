// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sums over all modes at single points: of Re(2 h e^(i k x)) over half the plane, since the field
// is real. Along a row of one ky all terms share e^(i ky y), and e^(i kx x) comes from a table, so
// that a mode costs multiplications only.
#include "ocean/internal/wave_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "wave/wave.hpp"
#include "waves/query/orbital_decay.hpp"
#include "waves/query/wave_sum_fixed.hpp"

namespace ocean {

namespace formula = wave::double_precision;

namespace {

/// Writes e^(i 2 pi n x / period) for n = first .. first + count - 1.
void add_phases(double x, double period, int first, int count, double* re, double* im) {
    const double turns = x / period - std::floor(x / period);
    for (int i = 0; i < count; ++i) {
        const formula::SinCos phase = formula::sin_cos_turns((first + i) * turns);
        re[i] = phase.cosine;
        im[i] = phase.sine;
    }
}

/// e^(i ky y).
struct Turn {
    double c;
    double s;
};

/// A complex sum in kLanes parts.
struct LaneSum {
    double re[kLanes] = {};
    double im[kLanes] = {};

    void add(std::size_t lane, double factor, double x, double y) {
        re[lane] += factor * x;
        im[lane] += factor * y;
    }
    std::complex<double> turned(Turn turn) const {
        double x = 0.0;
        double y = 0.0;
        for (std::size_t l = 0; l < kLanes; ++l) {
            x += re[l];
            y += im[l];
        }
        return {x * turn.c - y * turn.s, x * turn.s + y * turn.c};
    }
};

}  // namespace

/// The waves e^(i kx x), e^(i ky y) of one point, of all columns and rows.
struct WaveSum::Waves {
    std::vector<double> x_re, x_im, y_re, y_im;

    Waves(const Fixed& fixed, double x, double y)
        : x_re(fixed.kx.size()),
          x_im(fixed.kx.size()),
          y_re(fixed.ky.size()),
          y_im(fixed.ky.size()) {
        for (const Fixed::Wavenumbers& w : fixed.cascades) {
            add_phases(x, w.period, -w.half, 2 * w.half, &x_re[w.column], &x_im[w.column]);
            add_phases(y, w.period, 0, w.half, &y_re[w.row], &y_im[w.row]);
        }
    }
};

WaveSum::WaveSum(const Modes& modes, const Water& water, int resolution)
    : fixed_(std::make_shared<const Fixed>(modes, water, resolution)) {
    for (std::vector<double>* values : {&re_, &im_, &rate_re_, &rate_im_}) {
        values->resize(fixed_->size());
    }
    set_time(0.0);
}

void WaveSum::set_time(double time) {
    const Fixed& fixed = *fixed_;
    const double tau = fixed.clock.tau(time);
    for (std::size_t i = 0; i < fixed.size(); ++i) {
        const double turns = formula::phase_turns(fixed.rate[i], 0.0, tau, 0.0);
        const formula::ModeState state =
            formula::mode_state(fixed.h0_re[i], fixed.h0_im[i], fixed.mirror_re[i],
                                fixed.mirror_im[i], turns, fixed.omega(i));
        re_[i] = 2.0 * state.re;
        im_[i] = 2.0 * state.im;
        rate_re_[i] = 2.0 * state.rate_re;
        rate_im_[i] = 2.0 * state.rate_im;
    }
}

// A mode is a harmonic oscillator: h(t + dt) = h cos(omega dt) + dh/dt sin(omega dt) / omega.
void WaveSum::advance(const WaveStep& step) {
    for (std::size_t i = 0; i < re_.size(); ++i) {
        const double c = step.cosine_[i];
        const double over = step.sine_over_[i];
        const double times = step.sine_times_[i];
        const double re = re_[i];
        const double im = im_[i];
        re_[i] = re * c + rate_re_[i] * over;
        im_[i] = im * c + rate_im_[i] * over;
        rate_re_[i] = rate_re_[i] * c - re * times;
        rate_im_[i] = rate_im_[i] * c - im * times;
    }
}

WaveStep WaveSum::wave_step(double seconds) const {
    const Fixed& fixed = *fixed_;
    WaveStep step;
    for (std::vector<double>* values : {&step.cosine_, &step.sine_over_, &step.sine_times_}) {
        values->resize(fixed.size());
    }
    for (std::size_t i = 0; i < fixed.size(); ++i) {
        const double omega = fixed.omega(i);
        if (omega == 0.0) continue;  // padding of a block, not a wave
        const formula::SinCos phase = formula::sin_cos_turns(omega / kTwoPi * seconds);
        step.cosine_[i] = phase.cosine;
        step.sine_over_[i] = phase.sine / omega;
        step.sine_times_[i] = phase.sine * omega;
    }
    return step;
}

/// Adds up all modes at one point, row by row of equal ky: `term` adds a mode to the sums of its
/// row, `row` gets these sums, ky and e^(i ky y).
template <int kSums, typename Term, typename Row>
void WaveSum::sweep(double x, double y, const Term& term, const Row& row) const {
    const Fixed& fixed = *fixed_;
    const Waves waves(fixed, x, y);
    for (const Fixed::Run& run : fixed.runs) {
        std::array<LaneSum, kSums> sums;
        for (std::size_t i = run.begin; i < run.end; i += kLanes) {
            for (std::size_t l = 0; l < kLanes; ++l) {
                const std::size_t column = run.column + i - run.begin + l;
                term(sums, l, i + l, fixed.kx[column], waves.x_re[column], waves.x_im[column]);
            }
        }
        const Turn turn{waves.y_re[run.row], waves.y_im[run.row]};
        row(sums, fixed.ky[run.row], turn);
    }
}

// Every field is a sum of kx^a ky^b (coth(kd)/k)^c h e^(i k x), see linear_shape in synthesis.hpp;
// along a row ky is a constant.
LinearSample WaveSum::at_label(double x, double y) const {
    LinearSample sample{};
    enum { h, h_x, d, d_x, d_xx, rate, d_rate, d_rate_x, count };
    const auto term = [this](auto& sums, std::size_t l, std::size_t at, double kx, double c,
                             double s) {
        const double displacement = fixed_->displacement[at];
        const double re = re_[at] * c - im_[at] * s;
        const double im = re_[at] * s + im_[at] * c;
        const double v_re = rate_re_[at] * c - rate_im_[at] * s;
        const double v_im = rate_re_[at] * s + rate_im_[at] * c;
        sums[h].add(l, 1.0, re, im);
        sums[h_x].add(l, kx, re, im);
        sums[d].add(l, displacement, re, im);
        sums[d_x].add(l, kx * displacement, re, im);
        sums[d_xx].add(l, kx * kx * displacement, re, im);
        sums[rate].add(l, 1.0, v_re, v_im);
        sums[d_rate].add(l, displacement, v_re, v_im);
        sums[d_rate_x].add(l, kx * displacement, v_re, v_im);
    };
    const auto row = [&sample](const auto& sums, double ky, Turn turn) {
        const std::complex<double> height = sums[h].turned(turn);
        const std::complex<double> along_y = sums[d].turned(turn);
        const std::complex<double> along_x = sums[d_x].turned(turn);
        sample.height += height.real();
        sample.slope_x -= sums[h_x].turned(turn).imag();
        sample.slope_y -= ky * height.imag();
        sample.displacement_x += along_x.imag();
        sample.displacement_y += ky * along_y.imag();
        sample.gradient_xx += sums[d_xx].turned(turn).real();
        sample.gradient_yy += ky * ky * along_y.real();
        sample.gradient_xy += ky * along_x.real();
        sample.height_rate += sums[rate].turned(turn).real();
        sample.displacement_x_rate += sums[d_rate_x].turned(turn).imag();
        sample.displacement_y_rate += ky * sums[d_rate].turned(turn).imag();
    };
    sweep<count>(x, y, term, row);
    return sample;
}

DisplacementSample WaveSum::displacement_at(double x, double y) const {
    DisplacementSample sample{};
    enum { d, d_x, d_xx, count };
    const auto term = [this](auto& sums, std::size_t l, std::size_t at, double kx, double c,
                             double s) {
        const double displacement = fixed_->displacement[at];
        const double re = re_[at] * c - im_[at] * s;
        const double im = re_[at] * s + im_[at] * c;
        sums[d].add(l, displacement, re, im);
        sums[d_x].add(l, kx * displacement, re, im);
        sums[d_xx].add(l, kx * kx * displacement, re, im);
    };
    const auto row = [&sample](const auto& sums, double ky, Turn turn) {
        const std::complex<double> along_y = sums[d].turned(turn);
        const std::complex<double> along_x = sums[d_x].turned(turn);
        sample.displacement_x += along_x.imag();
        sample.displacement_y += ky * along_y.imag();
        sample.gradient_xx += sums[d_xx].turned(turn).real();
        sample.gradient_yy += ky * ky * along_y.real();
        sample.gradient_xy += ky * along_x.real();
    };
    sweep<count>(x, y, term, row);
    return sample;
}

double WaveSum::displacement_rms() const {
    return fixed_->displacement_rms;
}

WaterLevel WaveSum::water_level(double z) const {
    const Fixed& fixed = *fixed_;
    WaterLevel level;
    level.along_.resize(fixed.size());
    level.up_.resize(fixed.size());
    z = std::min(z, 0.0);
    if (!(fixed.water.depth + z >= 0.0)) return level;
    for (const Fixed::Run& run : fixed.runs) {
        for (std::size_t i = run.begin; i < run.end; ++i) {
            const double k = std::hypot(fixed.kx[run.column + i - run.begin], fixed.ky[run.row]);
            if (k == 0.0) continue;
            const OrbitalDecay decay = orbital_decay(k, z, fixed.water.depth);
            level.along_[i] = decay.along / k;
            level.up_[i] = decay.upright;
        }
    }
    return level;
}

WaterMotion WaveSum::water_motion(double x, double y, double z) const {
    return water_motion(x, y, water_level(z));
}

// The potential of linear waves over a flat bottom has d phi/dz = dh/dt at z = 0 and 0 at z = -d:
// phi = dh/dt cosh k(z+d) / (k sinh kd) for each mode. Velocity = grad phi, so that at z = 0 it is
// -dD/dt, dh/dt; pressure = -rho d phi/dt = rho omega^2 h cosh k(z+d) / (k sinh kd), which is
// (rho g + sigma k^2) h cosh k(z+d) / cosh kd by the dispersion relation.
// [Dean and Dalrymple 1991] eq. 3.30, 4.24; [Lamb 1932] art. 267 for the tension.
WaterMotion WaveSum::water_motion(double x, double y, const WaterLevel& level) const {
    WaterMotion motion{};
    enum { potential, potential_x, up, pressure, count };
    const auto term = [&](auto& sums, std::size_t l, std::size_t at, double kx, double c,
                          double s) {
        const double along = level.along_[at];
        const double omega = fixed_->omega(at);
        const double re = re_[at] * c - im_[at] * s;
        const double im = re_[at] * s + im_[at] * c;
        const double v_re = rate_re_[at] * c - rate_im_[at] * s;
        const double v_im = rate_re_[at] * s + rate_im_[at] * c;
        sums[potential].add(l, along, v_re, v_im);
        sums[potential_x].add(l, kx * along, v_re, v_im);
        sums[up].add(l, level.up_[at], v_re, v_im);
        sums[pressure].add(l, omega * omega * along, re, im);
    };
    const auto row = [&](const auto& sums, double ky, Turn turn) {
        motion.velocity_x -= sums[potential_x].turned(turn).imag();
        motion.velocity_y -= ky * sums[potential].turned(turn).imag();
        motion.velocity_z += sums[up].turned(turn).real();
        motion.pressure += fixed_->water.density * sums[pressure].turned(turn).real();
    };
    sweep<count>(x, y, term, row);
    return motion;
}

std::uint64_t WaveSum::bytes(const Modes& modes, std::size_t copies, std::size_t levels,
                             std::size_t steps) {
    constexpr std::uint64_t kFixed = 5 * sizeof(float) + sizeof(double);
    std::uint64_t pairs = 0;
    for (const CascadeModes& cascade : modes.cascades) pairs += cascade.lattice.size() / 2;
    // The constant part counts twice, because vectors grow.
    return pairs * (2 * kFixed + (4 * copies + 2 * levels + 3 * steps) * sizeof(double));
}

}  // namespace ocean
