// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See spectrum_csv.hpp.
#include "spectrum_csv.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <span>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::app {
namespace {

constexpr double kDegrees = 180.0 / kPi;

std::span<const double> row_of(const DirectionalSpectrum& spectrum, std::size_t row) {
    const auto columns = static_cast<std::size_t>(spectrum.directions());
    return spectrum.table().subspan(row * columns, columns);
}

/// Returns "mean,spread" of one row [degrees], with empty cells if it has no energy. The spread is
/// sqrt(2 (1 - r)), where r is the length of the mean direction vector.
std::string direction_cells(std::span<const double> row) {
    std::complex<double> vector = 0.0;
    double sum = 0.0;
    for (std::size_t j = 0; j < row.size(); ++j) {
        const double theta = kTwoPi * static_cast<double>(j) / static_cast<double>(row.size());
        vector += std::polar(row[j], theta);
        sum += row[j];
    }
    if (!(sum > 0.0)) return ",";
    const double degrees = std::arg(vector) * kDegrees;
    const double spread = std::sqrt(std::max(0.0, 2.0 * (1.0 - std::abs(vector) / sum)));
    return format_text("%.6g,%.6g", degrees < 0.0 ? degrees + 360.0 : degrees, spread * kDegrees);
}

}  // namespace

std::string frequency_csv(const DirectionalSpectrum& spectrum) {
    std::string csv = "frequency_hz,density_m2_per_hz,mean_direction_deg,directional_spread_deg\n";
    const std::span<const double> omega = spectrum.angular_frequencies();
    for (std::size_t i = 0; i < omega.size(); ++i) {
        csv += format_text("%.12g,%.12g,", omega[i] / kTwoPi,
                           kTwoPi * spectrum.frequency_density(omega[i]));
        csv += direction_cells(row_of(spectrum, i)) + '\n';
    }
    return csv;
}

std::string directional_csv(const DirectionalSpectrum& spectrum) {
    std::string csv = "frequency_hz,direction_deg,density_m2_per_hz_per_deg\n";
    const std::span<const double> omega = spectrum.angular_frequencies();
    for (std::size_t i = 0; i < omega.size(); ++i) {
        const std::span<const double> row = row_of(spectrum, i);
        for (std::size_t j = 0; j < row.size(); ++j) {
            const double degrees = 360.0 * static_cast<double>(j) / static_cast<double>(row.size());
            csv += format_text("%.12g,%.9g,%.9g\n", omega[i] / kTwoPi, degrees,
                               row[j] * kTwoPi / kDegrees);
        }
    }
    return csv;
}

}  // namespace ocean::app
