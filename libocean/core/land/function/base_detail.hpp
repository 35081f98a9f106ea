// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The waves that an elevation model lacks: waves below its cell, and waves that its production
// smoothed away.
//
// S_law continues the model's spectrum by the power law of its rings between 0.2 and 0.5 of the
// Nyquist wavenumber kN = pi / cell, where smoothing does not reach. The spline through the samples
// has the density
//   S_base(k) = S_measured(k') H(kx)^2 H(ky)^2,   H = sinc^4(t/2) / ((2 + cos t) / 3), t = k cell,
// k' the wave below kN to which k is aliased on the grid [Unser 1999]. The detail is the difference
// S_law - S_base, so that both together have S_law. Test: land_function_test.cpp.
#pragma once

#include "land/function/fine_waves.hpp"
#include "ocean/internal/measured_rings.hpp"
#include "ocean/terrain_model.hpp"

namespace ocean {

class BaseDetail {
  public:
    /// shortest: the shortest wave to be added [m]; 0: none.
    BaseDetail(const TerrainBase& base, double shortest);

    bool has_waves() const { return has_waves_; }
    double longest() const { return longest_; }  // [m]
    /// Returns the density of the detail; it keeps no reference to the base.
    RadialDensity density() const;

  private:
    double measured(double k) const;  // density of the base's own waves, below kN
    double law(double k) const;
    double of_base(double k) const;

    MeasuredRings rings_;
    double cell_;
    double nyquist_;
    double log_density_ = 0.0, slope_ = 0.0;  // the law's, at log k = 0
    double longest_, shortest_;
    bool has_waves_;
};

/// Returns a tenth of the rms slope of the base times its cell [m].
double default_base_error(const TerrainBase& base);

/// Returns the density of the waves down to `shortest` [m] that a terrain's law has but its lattice
/// lacks, because they lie beyond the square of its Nyquist lines; the mean over all directions.
RadialDensity waves_below_lattice(const TerrainModel& terrain, double gain, double shortest);

}  // namespace ocean
