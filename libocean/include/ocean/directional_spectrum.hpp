// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The one table E(omega, theta) of all wave systems together. Every spectrum, analytic or measured,
// ends here; modes, CPU and GPU read it by the same interpolation and know no formula.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

class ThreadPool;

/// Integrals of the table, exact for its bilinear interpolation in omega.
struct SpectralMoments {
    double m0 = 0.0;                  // m^2
    double m1 = 0.0;                  // m^2 rad/s, integral of omega E
    double m_minus1 = 0.0;            // m^2 s/rad, integral of E / omega
    double mean_square_slope = 0.0;   // integral of k^2 E
    double peak_omega = 0.0;          // where the density over all directions is largest; 0 if flat
    double mean_direction = 0.0;      // rad, energy-weighted; 0 if flat
    double directional_spread = 0.0;  // rad, sqrt(2 (1 - |c1|)), circular standard deviation

    double significant_wave_height() const;  // 4 sqrt(m0)
};

/// Immutable; copies share the table. A row for each of some angular frequencies, which lie close
/// where the density bends; a column for each direction 2 pi j / directions, a multiple of four of
/// them. Densities are in m^2 s/rad^2: bilinear between the entries, 0 outside the rows.
class DirectionalSpectrum {
  public:
    DirectionalSpectrum() = default;
    /// row_sum: frequency_density at each row.
    DirectionalSpectrum(std::vector<double> angular_frequencies, int directions,
                        std::shared_ptr<const double[]> density, std::vector<double> row_sum);

    double density(double omega, double theta) const;
    /// Integral over all directions, m^2 s/rad.
    double frequency_density(double omega) const;
    /// Over wavelengths shortest..longest metres (0 = no limit).
    SpectralMoments moments(const Water& water, double shortest = 0.0, double longest = 0.0) const;
    /// The m0 of moments() alone, in far less time.
    double variance(const Water& water, double shortest = 0.0, double longest = 0.0) const;

    std::span<const double> angular_frequencies() const { return omega_; }
    int directions() const { return directions_; }
    /// rows * directions values, row by row.
    std::span<const double> table() const {
        return {density_.get(), omega_.size() * static_cast<std::size_t>(directions_)};
    }
    bool flat() const { return omega_.empty(); }

  private:
    std::vector<double> omega_;
    int directions_ = 0;
    std::shared_ptr<const double[]> density_;
    std::vector<double> row_sum_;
};

/// Adds up all wave systems. Energy of each parametric system exact to 1e-5, the shape of its
/// density to 1e-4 of its peak; a measured one is linear between its listed frequencies and 0
/// beyond them. Needs validated parameters. The bits are the same for any number of threads.
DirectionalSpectrum make_directional_spectrum(const Parameters& parameters, ThreadPool& pool);
/// On the caller's thread alone.
DirectionalSpectrum make_directional_spectrum(const Parameters& parameters);

}  // namespace ocean
