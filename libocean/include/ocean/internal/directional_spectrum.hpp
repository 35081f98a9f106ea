// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The one table E(omega, theta) of all wave systems together. Every spectrum, analytic or measured,
// ends here; modes, CPU and GPU read it by the same interpolation and know no formula of a
// spectrum.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

class ThreadPool;

/// Integrals of the table, exact for its bilinear interpolation in omega. A flat sea has no waves.
struct SpectralMoments {
    double m0 = 0.0;                  // variance [m^2]
    double m1 = 0.0;                  // integral of omega E [m^2 rad/s]
    double m_minus1 = 0.0;            // integral of E / omega [m^2 s/rad]
    double mean_square_slope = 0.0;   // integral of k^2 E
    double peak_omega = 0.0;          // where the density over all directions peaks; 0 if flat
    double mean_direction = 0.0;      // energy-weighted [rad]; 0 if flat
    double directional_spread = 0.0;  // circular standard deviation sqrt(2 (1 - |c1|)) [rad]

    double significant_wave_height() const;  // 4 sqrt(m0) [m]
};

/// A table of densities [m^2 s/rad^2]. A row for each of a set of angular frequencies, which lie
/// close where the density bends; a column for each direction 2 pi j / directions(), a multiple of
/// four. Bilinear between the entries, 0 outside the rows. Immutable; copies share the table.
///
/// In memory a row has, for j = 0 .. directions() / 4 + 1, the densities towards theta = 2 pi j /
/// directions(), pi - theta, pi + theta and -theta side by side. Modes are read in these four
/// directions, and would otherwise wait for memory in four places.
class DirectionalSpectrum {
  public:
    DirectionalSpectrum() = default;
    /// Takes the table, as it is in memory. row_sum: the density over all directions at each row,
    /// see frequency_density.
    DirectionalSpectrum(std::vector<double> angular_frequencies, int directions,
                        std::shared_ptr<const double[]> density, std::vector<double> row_sum);
    /// Returns the numbers of a row in memory.
    static std::size_t row_size(int directions) {
        return 4 * (static_cast<std::size_t>(directions) / 4 + 2);
    }
    /// Writes a row of the table in memory from its densities, one for each direction.
    static void store_row(std::span<const double> densities, double* row);
    /// Returns the density [m^2 s/rad^2] at omega [rad/s] and theta [rad].
    double density(double omega, double theta) const;
    /// Returns the integral of the density over all directions [m^2 s/rad].
    double frequency_density(double omega) const;
    /// Returns the integrals over wavelengths shortest .. longest [m]; 0 = no limit.
    SpectralMoments moments(const Water& water, double shortest = 0.0, double longest = 0.0) const;
    /// Returns the m0 of moments() alone, in far less time.
    double variance(const Water& water, double shortest = 0.0, double longest = 0.0) const;

    std::span<const double> angular_frequencies() const { return omega_; }
    int directions() const { return directions_; }
    /// Returns the densities of a row, one for each direction.
    std::vector<double> row(std::size_t number) const;
    /// Returns the table as it is in memory, row by row.
    std::span<const double> table() const {
        return {density_.get(), omega_.size() * row_size(directions_)};
    }
    bool flat() const { return omega_.empty(); }

  private:
    std::vector<double> omega_;
    int directions_ = 0;
    std::shared_ptr<const double[]> density_;
    std::vector<double> row_sum_;
};

/// Returns the sum of all wave systems. The energy of each parametric system is exact to 1e-5, the
/// shape of its density to 1e-4 of its peak; a measured one is linear between its listed
/// frequencies and 0 beyond them. Needs validated parameters. The bits are the same for any number
/// of threads.
DirectionalSpectrum make_directional_spectrum(const Parameters& parameters, ThreadPool& pool);
/// Returns the same spectrum, computed on the calling thread alone.
DirectionalSpectrum make_directional_spectrum(const Parameters& parameters);

}  // namespace ocean
