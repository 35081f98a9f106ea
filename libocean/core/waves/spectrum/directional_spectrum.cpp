// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The table E(omega, theta): adds up the wave systems. All later stages read it.
#include "ocean/internal/directional_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ocean/internal/cascades.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/spreading.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/spectrum/spreading_rows.hpp"
#include "waves/spectrum/wave_system_table.hpp"

namespace ocean {

namespace {

constexpr double kShortestTabulated = 0.01;  // m: capillary waves; finer grids extend the table
constexpr double kJustOutside = 1e-9;        // relative to a frequency

/// Returns all rows of all systems, ascending, with a zero row just outside the support of each, so
/// that a system that ends with energy does not fade into a neighbour's next row.
std::vector<double> merge_rows(const std::vector<WaveSystemTable>& systems) {
    std::vector<double> rows;
    for (const WaveSystemTable& system : systems) {
        if (system.rows.empty()) continue;
        rows.insert(rows.end(), system.rows.begin(), system.rows.end());
        rows.push_back(system.rows.front() * (1.0 - kJustOutside));
        rows.push_back(system.rows.back() * (1.0 + kJustOutside));
    }
    std::sort(rows.begin(), rows.end());
    const auto same = [](double a, double b) { return b - a < 1e-12 * b; };
    rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
    return rows;
}

/// Returns the factor that makes the trapezoid over the rows give the exact variance: within 1e-4
/// of 1.
double calibration(const WaveSystemTable& system) {
    const std::vector<double>& rows = system.rows;
    const std::vector<double>& density = system.density;
    double sum =
        0.5 * kJustOutside * (density.front() * rows.front() + density.back() * rows.back());
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        sum += 0.5 * (density[i] + density[i + 1]) * (rows[i + 1] - rows[i]);
    }
    return sum > 0.0 ? system.m0 / sum : 1.0;
}

/// One system on its way through the merged rows, which ascend: keeps the two rows of its own
/// around the last merged row. Between them it is linear, as the whole table is.
class SystemRows {
  public:
    SystemRows(const WaveSystemTable& system, std::size_t directions)
        : system_(system),
          factor_(calibration(system)),
          own_(static_cast<std::size_t>(system.directions)),
          low_(directions),
          high_(directions),
          between_(directions) {}

    /// Returns the row at omega; null: it is zero. Valid until the next call.
    const double* at(double omega) {
        const std::vector<double>& rows = system_.rows;
        // A merged row may belong to another system and differ by a rounding error from a row of
        // this system.
        if (omega < rows.front() * (1.0 - 0.5 * kJustOutside) ||
            omega > rows.back() * (1.0 + 0.5 * kJustOutside)) {
            return nullptr;
        }
        const auto upper = std::upper_bound(rows.begin() + 1, rows.end() - 1, omega);
        const auto high = static_cast<std::size_t>(upper - rows.begin());
        const double v = (omega - rows[high - 1]) / (rows[high] - rows[high - 1]);
        if (v <= 0.0) return part(low_, high - 1);
        if (v >= 1.0) return part(high_, high);
        const double* below = part(low_, high - 1);
        const double* above = part(high_, high);
        for (std::size_t j = 0; j < between_.size(); ++j) {
            between_[j] = (1.0 - v) * below[j] + v * above[j];
        }
        return between_.data();
    }

  private:
    struct Part {
        explicit Part(std::size_t directions) : values(directions) {}
        std::vector<double> values;
        std::size_t row = static_cast<std::size_t>(-1);
    };

    /// Returns the system's own row `row`, and keeps it in `kept`.
    const double* part(Part& kept, std::size_t row) {
        Part& other = &kept == &low_ ? high_ : low_;
        if (other.row == row) std::swap(low_, high_);
        if (kept.row != row) fill(row, kept.values);
        kept.row = row;
        return kept.values.data();
    }

    /// Writes the density over the directions of the table, linear between the system's directions.
    void fill(std::size_t row, std::span<double> values) {
        const double density = factor_ * system_.density[row];
        if (density <= 0.0) {
            std::fill(values.begin(), values.end(), 0.0);
            return;
        }
        system_.spreading(row, own_);
        const std::size_t finer = values.size() / own_.size();
        if (finer == 1) {
            for (std::size_t j = 0; j < own_.size(); ++j) values[j] = density * own_[j];
            return;
        }
        for (std::size_t j = 0; j < own_.size(); ++j) {
            const double here = density * own_[j];
            const double next = density * own_[j + 1 < own_.size() ? j + 1 : 0];
            for (std::size_t i = 0; i < finer; ++i) {
                const double u = static_cast<double>(i) / static_cast<double>(finer);
                values[j * finer + i] = here + u * (next - here);
            }
        }
    }

    const WaveSystemTable& system_;
    double factor_;
    std::vector<double> own_;
    Part low_;
    Part high_;
    std::vector<double> between_;
};

struct Frequencies {
    double low;
    double high;
};

/// Returns the frequencies of wavelengths shortest .. longest [m]; 0 = no limit.
Frequencies frequencies_of(const Dispersion& dispersion, double shortest, double longest) {
    return {longest > 0.0 ? dispersion.angular_frequency(kTwoPi / longest) : 0.0,
            shortest > 0.0 ? dispersion.angular_frequency(kTwoPi / shortest)
                           : std::numeric_limits<double>::infinity()};
}

/// Returns the place of a direction in a row in memory. Each quarter of the directions is a mirror
/// image of the first.
std::size_t place_in_row(std::size_t direction, std::size_t directions) {
    const std::size_t quarter = directions / 4, half = directions / 2;
    if (direction <= quarter) return 4 * direction;
    if (direction < half) return 4 * (half - direction) + 1;
    if (direction <= half + quarter) return 4 * (direction - half) + 2;
    return 4 * (directions - direction) + 3;
}

}  // namespace

double SpectralMoments::significant_wave_height() const {
    return 4.0 * std::sqrt(m0);
}

DirectionalSpectrum::DirectionalSpectrum(std::vector<double> angular_frequencies, int directions,
                                         std::shared_ptr<const double[]> density,
                                         std::vector<double> row_sum)
    : omega_(std::move(angular_frequencies)),
      directions_(directions),
      density_(std::move(density)),
      row_sum_(std::move(row_sum)) {}

void DirectionalSpectrum::store_row(std::span<const double> densities, double* row) {
    const std::size_t count = densities.size();
    const double* const from = densities.data();
    const std::size_t half = count / 2;
    const auto store = [&](std::size_t j, double opposite) {
        row[4 * j] = from[j];
        row[4 * j + 1] = from[half - j];
        row[4 * j + 2] = from[half + j];
        row[4 * j + 3] = opposite;
    };
    store(0, from[0]);
    for (std::size_t j = 1; j < count / 4 + 2; ++j) store(j, from[count - j]);
}

std::vector<double> DirectionalSpectrum::row(std::size_t number) const {
    const double* const from = density_.get() + number * row_size(directions_);
    const auto count = static_cast<std::size_t>(directions_);
    std::vector<double> densities(count);
    for (std::size_t j = 0; j < count; ++j) densities[j] = from[place_in_row(j, count)];
    return densities;
}

double DirectionalSpectrum::density(double omega, double theta) const {
    if (flat() || omega < omega_.front() || omega >= omega_.back()) return 0.0;
    const auto upper = std::upper_bound(omega_.begin(), omega_.end(), omega);
    const auto row = static_cast<std::size_t>(upper - omega_.begin()) - 1;
    const double v = (omega - omega_[row]) / (omega_[row + 1] - omega_[row]);

    double column = theta / kTwoPi;
    column = (column - std::floor(column)) * directions_;
    const auto j = static_cast<std::size_t>(column);
    const double u = column - static_cast<double>(j);
    const auto width = static_cast<std::size_t>(directions_);
    const std::size_t left = place_in_row(j % width, width);
    const std::size_t right = place_in_row((j + 1) % width, width);

    const double* low = density_.get() + row * row_size(directions_);
    const double* high = low + row_size(directions_);
    const double at_low = low[left] + u * (low[right] - low[left]);
    const double at_high = high[left] + u * (high[right] - high[left]);
    return at_low + v * (at_high - at_low);
}

double DirectionalSpectrum::frequency_density(double omega) const {
    if (flat() || omega < omega_.front() || omega >= omega_.back()) return 0.0;
    const auto upper = std::upper_bound(omega_.begin(), omega_.end(), omega);
    const auto row = static_cast<std::size_t>(upper - omega_.begin()) - 1;
    const double v = (omega - omega_[row]) / (omega_[row + 1] - omega_[row]);
    return row_sum_[row] + v * (row_sum_[row + 1] - row_sum_[row]);
}

double DirectionalSpectrum::variance(const Water& water, double shortest, double longest) const {
    const auto [low, high] = frequencies_of(Dispersion(water), shortest, longest);
    double m0 = 0.0;
    for (std::size_t i = 0; i + 1 < omega_.size(); ++i) {
        const double from = std::max(omega_[i], low);
        const double to = std::min(omega_[i + 1], high);
        if (from >= to) continue;
        const double v = (0.5 * (from + to) - omega_[i]) / (omega_[i + 1] - omega_[i]);
        m0 += (to - from) * (row_sum_[i] + v * (row_sum_[i + 1] - row_sum_[i]));
    }
    return m0;
}

SpectralMoments DirectionalSpectrum::moments(const Water& water, double shortest,
                                             double longest) const {
    SpectralMoments result;
    if (flat()) return result;
    const Dispersion dispersion(water);
    const auto [low, high] = frequencies_of(dispersion, shortest, longest);

    // The first circular moment of each row.
    const auto width = static_cast<std::size_t>(directions_);
    std::vector<double> cosine(width);
    std::vector<double> sine(width);
    for (std::size_t j = 0; j < width; ++j) {
        cosine[j] = std::cos(kTwoPi * static_cast<double>(j) / directions_) * kTwoPi / directions_;
        sine[j] = std::sin(kTwoPi * static_cast<double>(j) / directions_) * kTwoPi / directions_;
    }
    std::vector<double> east(omega_.size());
    std::vector<double> north(omega_.size());
    for (std::size_t i = 0; i < omega_.size(); ++i) {
        const std::vector<double> row = this->row(i);
        for (std::size_t j = 0; j < width; ++j) {
            east[i] += row[j] * cosine[j];
            north[i] += row[j] * sine[j];
        }
    }
    // Three-point Gauss in each interval is exact for the linear densities, and k^2 is smooth
    // there.
    constexpr double kNode[3] = {-0.7745966692414834, 0.0, 0.7745966692414834};
    constexpr double kWeight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    double mean_east = 0.0;
    double mean_north = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i + 1 < omega_.size(); ++i) {
        const double from = std::max(omega_[i], low);
        const double to = std::min(omega_[i + 1], high);
        if (from >= to) continue;
        for (int q = 0; q < 3; ++q) {
            const double omega = 0.5 * (from + to) + 0.5 * (to - from) * kNode[q];
            const double v = (omega - omega_[i]) / (omega_[i + 1] - omega_[i]);
            const double weight = kWeight[q] * (to - from);
            const double energy = weight * (row_sum_[i] + v * (row_sum_[i + 1] - row_sum_[i]));
            const double k = dispersion.wavenumber(omega);
            result.m0 += energy;
            result.m1 += omega * energy;
            result.m_minus1 += energy / omega;
            result.mean_square_slope += k * k * energy;
            mean_east += weight * (east[i] + v * (east[i + 1] - east[i]));
            mean_north += weight * (north[i] + v * (north[i + 1] - north[i]));
        }
        for (const std::size_t end : {i, i + 1}) {
            if (row_sum_[end] > largest && omega_[end] >= low && omega_[end] <= high) {
                largest = row_sum_[end];
                result.peak_omega = omega_[end];
            }
        }
    }
    if (result.m0 > 0.0) {
        result.mean_direction = std::atan2(mean_north, mean_east);
        const double c1 = std::hypot(mean_east, mean_north) / result.m0;
        result.directional_spread = circular_spread(c1);
    }
    return result;
}

double highest_frequency(const Parameters& parameters) {
    const double corner = std::sqrt(2.0) * kPi * parameters.grid.resolution *
                          cascade_divisors(parameters.grid).back() / parameters.grid.patch_size;
    return Dispersion(parameters.water)
        .angular_frequency(std::max(corner, kTwoPi / kShortestTabulated));
}

DirectionalSpectrum make_directional_spectrum(const Parameters& parameters, ThreadPool& pool) {
    const double highest = highest_frequency(parameters);
    std::vector<WaveSystemTable> systems;
    int directions = 0;
    for (const WaveSystem& system : parameters.waves) {
        WaveSystemTable table = make_wave_system_table(system, parameters.water, highest);
        if (table.rows.empty()) continue;
        directions = std::max(directions, table.directions);
        systems.push_back(std::move(table));
    }
    std::vector<double> rows = merge_rows(systems);
    if (rows.empty()) return {};

    const auto width = static_cast<std::size_t>(directions);
    std::vector<double> row_sum(rows.size());
    // Left uninitialised: each thread fills its rows.
    const std::size_t row_size = DirectionalSpectrum::row_size(directions);
    const std::shared_ptr<double[]> density(new double[rows.size() * row_size]);
    pool.for_each_range(static_cast<int>(rows.size()), [&](int first, int last) {
        std::vector<SystemRows> parts;
        for (const WaveSystemTable& system : systems) parts.emplace_back(system, width);
        std::vector<double> sum(width);
        const std::vector<double> zero(width);
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
            const double* row = nullptr;
            for (SystemRows& part : parts) {
                const double* const other = part.at(rows[i]);
                if (row != nullptr && other != nullptr) {
                    for (std::size_t j = 0; j < width; ++j) sum[j] = row[j] + other[j];
                    row = sum.data();
                } else if (other != nullptr) {
                    row = other;
                }
            }
            const std::span<const double> densities(row != nullptr ? row : zero.data(), width);
            row_sum[i] = row_total(densities) * kTwoPi / directions;
            DirectionalSpectrum::store_row(densities, density.get() + i * row_size);
        }
    });
    return DirectionalSpectrum(std::move(rows), directions, density, std::move(row_sum));
}

DirectionalSpectrum make_directional_spectrum(const Parameters& parameters) {
    ThreadPool alone(1);
    return make_directional_spectrum(parameters, alone);
}

}  // namespace ocean
