// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The density of a terrain; see terrain_law.hpp.
#include "ocean/internal/terrain_law.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/measured_rings.hpp"

namespace ocean {
namespace {

constexpr double kRadians = kTwoPi / 360.0;
constexpr double kEndless = std::numeric_limits<double>::infinity();

/// log(1 + e^x), without overflow.
double log_one_plus_exp(double x) {
    return x > 40.0 ? x : std::log1p(std::exp(x));
}

/// Waves steer gullies if they are at least this many times longer than the largest gullies.
constexpr double kSteering = 7.0 / 3.0;

double smallest_gully(const GullySettings& gullies) {
    return gullies.longest * std::exp2(1 - gullies.octaves);
}

/// Returns the slope of the straight line through the points, by least squares.
double fitted_slope(std::vector<double>::const_iterator x, std::vector<double>::const_iterator y,
                    std::ptrdiff_t count) {
    double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        mean_x += x[i] / static_cast<double>(count);
        mean_y += y[i] / static_cast<double>(count);
    }
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    return xy / xx;
}

}  // namespace

TerrainLaw::TerrainLaw(const TerrainModel& terrain, LawPart part)
    : exponent_(terrain.beta),
      min_k_(terrain.longest_wavelength > 0.0 ? kTwoPi / terrain.longest_wavelength : 0.0),
      max_k_(terrain.shortest_wavelength > 0.0 ? kTwoPi / terrain.shortest_wavelength : kEndless),
      anisotropy_(terrain.anisotropy),
      cosine_(std::cos(terrain.direction * kRadians)),
      sine_(std::sin(terrain.direction * kRadians)),
      part_(terrain.has_gullies() || part == LawPart::fine ? part : LawPart::whole) {
    const double wavelength = part == LawPart::fine ? smallest_gully(terrain.gullies)
                                                    : kSteering * terrain.gullies.longest;
    log_part_k_ = std::log(kTwoPi / wavelength);
    if (part == LawPart::fine && !terrain.has_gullies()) log_part_k_ = kEndless;
    // A wave of exactly the limiting length stays, however its k was rounded.
    constexpr double kRounding = 1e-9;
    min_k_ *= 1.0 - kRounding;
    max_k_ *= 1.0 + kRounding;
    double before = terrain.beta;
    for (const auto& [wavelength, exponent] : terrain.breaks) {
        breaks_.push_back({std::log(kTwoPi / wavelength), exponent - before});
        before = exponent;
    }
    if (terrain.outer_scale > 0.0) {
        const double ko = kTwoPi / terrain.outer_scale;
        outer_square_ = ko * ko;
    }
    if (terrain.ridge_wavelength > 0.0) {
        ridge_log_k_ = std::log(kTwoPi / terrain.ridge_wavelength);
        ridge_gain_ = terrain.ridge_gain;
        ridge_width_ = terrain.ridge_width * std::log(2.0);
        ridge_turns_ = terrain.ridge_direction.has_value();
        ridge_direction_ = terrain.ridge_direction.value_or(0.0) * kRadians;
        ridge_spread_ = terrain.ridge_spread;
    }
    if (terrain.rings == nullptr) return;
    absolute_ = terrain.has_measured_rms();
    for (std::size_t i = 0; i < terrain.rings->wavenumber.size(); ++i) {
        // A ring without energy has a floor far below the others: its logarithm must be finite.
        constexpr double kFloor = 1e-30;
        log_k_.push_back(std::log(terrain.rings->wavenumber[i]));
        log_s_.push_back(std::log(std::max(terrain.rings->density[i], kFloor)));
    }
    constexpr std::ptrdiff_t kEndRings = 6;
    const auto rings = static_cast<std::ptrdiff_t>(log_k_.size());
    const std::ptrdiff_t used = std::min(kEndRings, rings);
    first_slope_ = fitted_slope(log_k_.begin(), log_s_.begin(), used);
    last_slope_ = fitted_slope(log_k_.end() - used, log_s_.end() - used, used);
}

/// The rings end where the elevation model does; beyond them the density continues with the slope
/// of the six outermost rings.
double TerrainLaw::measured(double log_k) const {
    if (log_k <= log_k_.front()) {
        return log_s_.front() + first_slope_ * (log_k - log_k_.front());
    }
    if (log_k >= log_k_.back()) return log_s_.back() + last_slope_ * (log_k - log_k_.back());
    const auto above = std::upper_bound(log_k_.begin(), log_k_.end(), log_k);
    const auto i = static_cast<std::size_t>(above - log_k_.begin());
    const double part = (log_k - log_k_[i - 1]) / (log_k_[i] - log_k_[i - 1]);
    return log_s_[i - 1] + part * (log_s_[i] - log_s_[i - 1]);
}

double TerrainLaw::log_part(double log_k) const {
    const double distance = log_k - log_part_k_;
    switch (part_) {
        case LawPart::whole:
            break;
        case LawPart::smooth:
            return -0.9 * log_one_plus_exp(4.0 * distance);
        case LawPart::fine:
            return -log_one_plus_exp(-8.0 * distance);
    }
    return 0.0;
}

double TerrainLaw::ridge(double k) const {
    const double distance = (std::log(k) - ridge_log_k_) / ridge_width_;
    return ridge_gain_ * std::exp(-0.5 * distance * distance);
}

double TerrainLaw::turning(double theta) const {
    return std::pow(std::abs(std::cos(theta - ridge_direction_)), 2.0 * ridge_spread_);
}

double TerrainLaw::radial(double k) const {
    const double log_k = std::log(k);
    double log_density = 0.0;
    if (!log_k_.empty()) {
        log_density = measured(log_k);
    } else {
        log_density = outer_square_ > 0.0 ? -exponent_ * std::log(k * k + outer_square_)
                                          : -2.0 * exponent_ * log_k;
        for (const Break& part : breaks_) {
            log_density -= 0.5 * part.change * log_one_plus_exp(4.0 * (log_k - part.log_k));
        }
    }
    const double density = std::exp(log_density + log_part(log_k));
    return ridge_gain_ > 0.0 && !ridge_turns_ ? density * (1.0 + ridge(k)) : density;
}

double TerrainLaw::scaled_square(double kx, double ky) const {
    const double along = kx * cosine_ + ky * sine_;
    const double across = ky * cosine_ - kx * sine_;
    return along * along / anisotropy_ + across * across * anisotropy_;
}

bool TerrainLaw::has_wave(double k) const {
    return k > 0.0 && k >= min_k_ && k <= max_k_;
}

double TerrainLaw::density(double kx, double ky) const {
    if (!has_wave(std::hypot(kx, ky))) return 0.0;
    const double k = std::sqrt(scaled_square(kx, ky));
    const double density = radial(k);
    if (!ridge_turns_) return density;
    return density * (1.0 + ridge(k) * turning(std::atan2(ky, kx)));
}

double TerrainLaw::exponent(double k) const {
    constexpr int kDirections = 32;
    const double factor = std::pow(2.0, 0.25);
    const auto mean = [&](double at) {
        double sum = 0.0;
        for (int i = 0; i < kDirections; ++i) {
            const double theta = kTwoPi * i / kDirections;
            const double k_scaled =
                std::sqrt(scaled_square(at * std::cos(theta), at * std::sin(theta)));
            const double turned = ridge_turns_ ? 1.0 + ridge(k_scaled) * turning(theta) : 1.0;
            sum += radial(k_scaled) * turned;
        }
        return std::log(sum / kDirections);
    };
    return -0.5 * (mean(k * factor) - mean(k / factor)) / std::log(factor * factor);
}

namespace {

constexpr int kShift = 52 - WavenumberCells::kOctaveBits;

}  // namespace

WavenumberCells::Place WavenumberCells::place_of(double square) {
    constexpr std::uint64_t kBelow = (std::uint64_t{1} << kShift) - 1;
    const auto bits = std::bit_cast<std::int64_t>(square);
    // Reads the bits below the cell's own as the double 1.xxx - 1, without a 64-bit conversion.
    constexpr std::int64_t kOne = std::int64_t{1023} << 52;
    const std::int64_t below = (bits & static_cast<std::int64_t>(kBelow)) << kOctaveBits;
    return {bits >> kShift, std::bit_cast<double>(kOne | below) - 1.0};
}

double WavenumberCells::begin_of(std::int64_t cell) {
    return std::bit_cast<double>(cell << kShift);
}

TerrainAmplitudes::TerrainAmplitudes(const TerrainLaw& law, double min_k, double max_k)
    : law_(law),
      turns_(law.anisotropy_ != 1.0 || law.ridge_turns_),
      min_k_(min_k),
      max_k_(max_k),
      first_(WavenumberCells::place_of(min_k * min_k / law.anisotropy_).cell) {
    const std::int64_t last = WavenumberCells::place_of(max_k * max_k * law.anisotropy_).cell + 1;
    table_.reserve(static_cast<std::size_t>(last - first_ + 1));
    for (std::int64_t cell = first_; cell <= last; ++cell) {
        table_.push_back(std::sqrt(law.radial(std::sqrt(WavenumberCells::begin_of(cell)))));
    }
}

bool TerrainAmplitudes::has_limits() const {
    return law_.min_k_ > min_k_ || law_.max_k_ < max_k_;
}

double TerrainAmplitudes::operator()(double kx, double ky) const {
    const double own = kx * kx + ky * ky;
    if (own == 0.0 || own < law_.min_k_ * law_.min_k_ || own > law_.max_k_ * law_.max_k_) {
        return 0.0;
    }
    const double square = turns_ ? law_.scaled_square(kx, ky) : own;
    const auto [cell, part] = WavenumberCells::place_of(square);
    const auto at = static_cast<std::size_t>(cell - first_);
    const double amplitude = table_[at] + part * (table_[at + 1] - table_[at]);
    if (!law_.ridge_turns_) return amplitude;
    const double k = std::sqrt(square);
    return amplitude * std::sqrt(1.0 + law_.ridge(k) * law_.turning(std::atan2(ky, kx)));
}

void TerrainAmplitudes::row(double dk, double ky, std::span<double> row) const {
    if (turns_ || has_limits()) {
        for (std::size_t n = 0; n < row.size(); ++n)
            row[n] = (*this)(static_cast<double>(n) * dk, ky);
        return;
    }
    const double* const table = table_.data();
    for (std::size_t n = ky == 0.0 ? 1 : 0; n < row.size(); ++n) {
        const double kx = static_cast<double>(n) * dk;
        const auto [cell, part] = WavenumberCells::place_of(kx * kx + ky * ky);
        const double* const at = table + (cell - first_);
        row[n] = at[0] + part * (at[1] - at[0]);
    }
    if (ky == 0.0) row[0] = 0.0;
}

}  // namespace ocean
