// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/wake_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "field/ease.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

/// Waves end by a C2 step of k between these shares of the Nyquist line.
constexpr double kRollBegin = 0.8;
constexpr double kRollEnd = 1.0;
constexpr double kNoGain = 1e-6;

/// Returns Int_0^1 (1 - s^2) e^(-qs) ds.
double parabola_integral(double q) {
    return 1.0 / q - 2.0 / (q * q * q) + std::exp(-q) * (2.0 / (q * q) + 2.0 / (q * q * q));
}

}  // namespace

WakeSize wake_size(const Hull& hull, double highest_speed, const Water& water) {
    WakeSize size{hull.wake_size, hull.wake_resolution, hull.wake_age};
    const double transverse = kTwoPi * highest_speed * highest_speed / water.gravity;
    if (size.side == 0.0) {
        size.side = std::min(std::max(16.0 * hull.length, 12.0 * transverse), 32.0 * hull.length);
    }
    if (size.age == 0.0) {
        size.age = std::clamp(3.2 * size.side / std::max(highest_speed, 0.1), 60.0, 600.0);
    }
    return size;
}

double hull_volume(const Hull& hull) {
    const double box = hull.length * hull.beam * hull.draught;
    return hull.shape == HullShape::wigley ? box * 4.0 / 9.0 : box * 2.0 / 3.0;
}

double down_hull(const Hull& hull, double k, double depth) {
    const double q = k * hull.draught;
    const double bottom = std::exp(-2.0 * k * depth);  // 0 in deep water
    const double upward = bottom > 0.0 ? std::exp(q - 2.0 * k * depth) : 0.0;
    const bool is_wigley = hull.shape == HullShape::wigley;
    // To q^2 where the closed forms cancel.
    constexpr double kSmall = 1e-3;
    if (q < kSmall) return 1.0 - (is_wigley ? 3.0 / 8.0 : 0.5) * q * std::tanh(k * depth);
    if (!is_wigley) {
        return (-std::expm1(-q) + (upward - bottom)) / (q * (1.0 + bottom));
    }
    // e^(2kd) may overflow, so that the part that rises with the depth is written out.
    const double rising =
        upward * (2.0 / (q * q) - 2.0 / (q * q * q)) + bottom * (2.0 / (q * q * q) - 1.0 / q);
    return 1.5 * (parabola_integral(q) + rising) / (1.0 + bottom);
}

WakeLattice::WakeLattice(const Hull& hull, const WakeSize& size, const Water& water)
    : lattice_{size.resolution, size.side}, displacement_(lattice_.size()) {
    const Dispersion dispersion(water);
    const double step = lattice_.wavenumber_step();
    const int half = lattice_.resolution / 2;
    const double nyquist = step * half;
    const double whole = 0.5 * hull.factor * hull_volume(hull) / (size.side * size.side);
    constexpr int kWidth = kWakeBlock;
    const auto share = [&](int n, int m) {
        if ((n == 0 && m == 0) || n == -half || m == -half) return 0.0;
        const double roll = 1.0 - ease(kRollBegin, kRollEnd, step * std::hypot(n, m) / nyquist);
        return roll < kNoGain ? 0.0 : roll;
    };
    for (const int sign : {1, -1}) {
        for (int first = 0; first < half; first += kWidth) {
            for (int n = -half + 1; n < half; ++n) {
                // The waves nearest to the origin are at one end.
                if (share(n, first) == 0.0 && share(n, first + kWidth - 1) == 0.0) continue;
                for (int m = first; m < first + kWidth; ++m) {
                    add(dispersion, sign * n, sign * m, whole * share(n, m), hull, water);
                }
                const auto bounds = [&](const PageVector<float>& values) {
                    return std::minmax_element(values.end() - kWidth, values.end());
                };
                const auto [least_x, most_x] = bounds(group_x_);
                const auto [least_y, most_y] = bounds(group_y_);
                blocks_.push_back({((sign < 0 ? half : 0) + first) / kWidth, sign * n + half,
                                   *least_x, *most_x, *least_y, *most_y});
            }
        }
    }
}

void WakeLattice::add(const Dispersion& dispersion, int n, int m, double gain, const Hull& hull,
                      const Water& water) {
    const double step = lattice_.wavenumber_step();
    const double k = step * std::hypot(n, m);
    n_.push_back(static_cast<float>(n));
    m_.push_back(static_cast<float>(m));
    if (k == 0.0) {
        rate_high_.push_back(1.0f);
        for (PageVector<float>* const values :
             {&rate_low_, &group_x_, &group_y_, &moved_, &gain_}) {
            values->push_back(0.0f);
        }
        return;
    }
    const DispersionPoint wave = dispersion.at(k);
    const double rate = wave.angular_frequency / kTwoPi;
    rate_high_.push_back(static_cast<float>(rate));
    rate_low_.push_back(static_cast<float>(rate - static_cast<double>(static_cast<float>(rate))));
    group_x_.push_back(static_cast<float>(wave.group_velocity * step * n / k));
    group_y_.push_back(static_cast<float>(wave.group_velocity * step * m / k));
    moved_.push_back(
        static_cast<float>(wave.horizontal_displacement * wave.horizontal_displacement));
    gain_.push_back(static_cast<float>(gain == 0.0 ? 0.0 : gain * down_hull(hull, k, water.depth)));
    const std::size_t at = mode_index(n, m, lattice_.resolution);
    displacement_[at] = static_cast<float>(wave.horizontal_displacement / k);
}

WakeWaves WakeLattice::waves(int first, int last) const {
    const std::size_t from = static_cast<std::size_t>(first) * kWakeBlock;
    return {.count = static_cast<std::size_t>(last - first) * kWakeBlock,
            .blocks = blocks_.data() + first,
            .n = n_.data() + from,
            .m = m_.data() + from,
            .rate_high = rate_high_.data() + from,
            .rate_low = rate_low_.data() + from,
            .group_x = group_x_.data() + from,
            .group_y = group_y_.data() + from,
            .gain = gain_.data() + from};
}

Modes WakeLattice::still_modes() const {
    Modes modes;
    modes.lattice = lattice_;
    CascadeModes& waves = modes.cascades.emplace_back();
    waves.lattice = lattice_;
    waves.h0.assign(lattice_.size(), std::complex<float>{});
    waves.rate_high.assign(lattice_.size(), 0.0f);
    waves.rate_low.assign(lattice_.size(), 0.0f);
    waves.displacement.assign(displacement_.begin(), displacement_.end());
    waves.shell_covariance.resize(static_cast<std::size_t>(lattice_.resolution / 2));
    for (std::size_t i = 0; i < count(); ++i) {
        waves.rate_high[index(i)] = rate_high_[i];
        waves.rate_low[index(i)] = rate_low_[i];
    }
    modes.lattice_revision = Revision::begin();
    return modes;
}

std::size_t WakeLattice::index(std::size_t i) const {
    return mode_index(static_cast<int>(n_[i]), static_cast<int>(m_[i]), lattice_.resolution);
}

void WakeLattice::set_amplitudes(const float* re, const float* im, Modes& modes) const {
    PageVector<std::complex<float>>& h0 = modes.cascades.front().h0;
    for (std::size_t i = 0; i < count(); ++i) h0[index(i)] = {re[i], im[i]};
    modes.revision = Revision::begin();
}

std::vector<std::size_t> WakeLattice::places(const PackedModes& packed) const {
    std::vector<std::size_t> places;
    const auto lanes = static_cast<std::size_t>(kernel_code(packed.level()).lanes);
    for (std::size_t i = 0; i < count() / 2; i += lanes) {
        const int kx = fft_index(static_cast<int>(n_[i]), packed.size());
        places.push_back(packed.place(kx, static_cast<int>(m_[i]) / static_cast<int>(lanes)));
    }
    return places;
}

void WakeLattice::pack(const float* re, const float* im, const float* factors,
                       const std::vector<std::size_t>& places, PackedModes& packed,
                       ThreadPool& pool) const {
    const std::size_t half = count() / 2;
    const std::size_t lanes = half / places.size();
    pool.for_each_range(static_cast<int>(places.size()), [&](int first, int last) {
        for (auto piece = static_cast<std::size_t>(first); piece < static_cast<std::size_t>(last);
             ++piece) {
            float* const to = packed.amplitudes() + places[piece];
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const std::size_t i = piece * lanes + lane;
                const float factor = factors[i];
                to[lane] = factor * (re[i] + re[half + i]);
                to[lanes + lane] = factor * (im[i] - im[half + i]);
                to[2 * lanes + lane] = factor * (im[i] + im[half + i]);
                to[3 * lanes + lane] = factor * (re[half + i] - re[i]);
            }
        }
    });
}

PageVector<float> WakeLattice::factors(const ModeFactor& factor) const {
    PageVector<float> factors(count());
    for (std::size_t i = 0; i < count(); ++i) {
        factors[i] = factor(0, static_cast<int>(n_[i]), static_cast<int>(m_[i])).amplitude;
    }
    return factors;
}

double WakeLattice::farthest(const float* re, const float* im) const {
    float squares[kWakeBlock] = {};
    for (std::size_t i = 0; i < count(); i += kWakeBlock) {
        for (std::size_t l = 0; l < kWakeBlock; ++l) {
            const std::size_t at = i + l;
            squares[l] += (re[at] * re[at] + im[at] * im[at]) * moved_[at];
        }
    }
    double sum = 0.0;
    for (const float square : squares) sum += static_cast<double>(square);
    return 1.0001 * 8.0 * std::sqrt(2.0 * sum);
}

std::uint64_t WakeLattice::bytes(int resolution) {
    constexpr std::uint64_t kArrays = 8 + 1;  // of the waves and of the lattice
    constexpr std::uint64_t kModes = 2 + 1 + 1 + 1;
    constexpr std::uint64_t kAmplitudes = 4 + 2 + 2 + 1;  // windows, ticks, the frame, factors
    return Lattice{resolution, 1.0}.size() * sizeof(float) * (kArrays + kModes + kAmplitudes);
}

}  // namespace ocean
