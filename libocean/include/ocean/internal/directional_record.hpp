// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Directions of spectrum formats, converted to libocean's: degrees counter-clockwise from east, the
// direction waves travel to. Formats pass the numbers that they read; conventions are converted
// here.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "ocean/parameters.hpp"

namespace ocean {

/// The reference and sense of a direction: where it is measured from, and whether waves come from
/// it or travel to it.
enum class DirectionConvention {
    from_nautical,  // degrees clockwise from north, coming from: buoys, meteorology
    to_nautical,    // degrees clockwise from north, travelling to: oceanography
    to_cartesian,   // degrees counter-clockwise from east, travelling to: libocean
};
/// Returns a direction in libocean's convention, 0 <= d < 360 [degrees].
double travel_direction(double degrees, DirectionConvention convention);

/// The direction bins of a file: in any order, wrapped anywhere, even or not, with or without the
/// first bin repeated after 360 degrees, over the whole circle or a sector. One axis serves all
/// spectra with these bins.
class DirectionAxis {
  public:
    /// Returns the fault of the bins as a message; empty for 3 .. 720 finite, distinct bins.
    static std::string fault(std::span<const double> degrees);
    /// Requires bins for which fault() is empty.
    DirectionAxis(std::span<const double> degrees, DirectionConvention convention);

    /// Sets `direction`, `directional_density` and `density` of a record that has its frequencies.
    /// `values`: [frequency][bin] in the order of the file, NaN (missing) counts as 0;
    /// `to_per_degree` converts them to m^2/Hz/degree. A sector falls to 0 within a bin of its
    /// edges.
    void fill(SpectrumRecord& record, std::span<const double> values, double to_per_degree) const;

  private:
    void close_sector();

    std::size_t bins_;                 // of the file
    std::vector<double> direction_;    // ascending
    std::vector<std::size_t> source_;  // the file's bin for each direction; bins_: none, value 0
    std::vector<double> weight_;       // of each direction in the integral [degrees]
};

/// Appends the first moment of one frequency, r1 = 1 - spread^2 / 2, from a mean travel direction
/// and a directional spread, the circular standard deviation [Kuik 1988], both in degrees; NaN =
/// missing. The second moment is not known.
void append_mean_and_spread(SpectrumRecord& record, double mean, double spread);
/// Appends both moments of one frequency as NDBC publishes them, a_n = r_n cos(n theta_n) and b_n =
/// r_n sin(n theta_n) [Longuet-Higgins 1963]: the mean and the principal travel direction in
/// degrees, and the two ratios. If one of the four is missing (NaN), all moments count as missing.
void append_mean_and_principal(SpectrumRecord& record, double mean, double principal, double r1,
                               double r2);
/// Appends the unchanged moments of one frequency; if one of the four is missing, all count as
/// missing.
void append_moments(SpectrumRecord& record, const std::array<double, 4>& a1_b1_a2_b2);
/// Removes the moments of a record if they are missing in every bin.
void drop_unknown_moments(SpectrumRecord& record);

}  // namespace ocean
