// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Cases that the suite has of its own seas and of the user's: each fills the rest of a row that has
// its id and its claim.
#pragma once

#include "bench.hpp"

namespace ocean::verify {

/// The variance of maps over seeds is the sum over the modes.
Row variance_row(Bench& bench, const Parameters& parameters, int seeds, Row row);

/// The motion of waves, each measured by its own coefficient in maps `step` [s] apart.
struct Propagation {
    double error = 0.0;         // rms over the modes of omega over theory, less 1
    double direction = 0.0;     // energy-weighted mean [degrees]
    double against_wind = 0.0;  // share of the energy that travels by more than 90 degrees off it,
                                // less the waves at the border
    std::vector<Point> omega = {};  // omega over k, some modes
};
Propagation measure_propagation(Ocean& sea, int frames, double step);
/// Returns the samples along a side of its maps: with several cascades those that show a part of
/// the second one too. Each wave is one of the patch's lattice, whichever its cascade.
int samples_of_propagation(const Grid& grid);

/// The frequency of each wave is that of theory.
Row dispersion_row(Ocean& sea, double step, Row row);

/// The mean whitecap over seeds is Monahan's.
Row whitecap_row(Bench& bench, const Parameters& parameters, int seeds, Row row);

/// Linear fields of a backend are those of sums in double precision, and the rows of a backend that
/// does not run say why.
Row precision_row(Bench& bench, const Parameters& parameters, const Backend& backend, Row row);

/// Returns the case of Michell's energy for a hull at a speed [m/s] in deep water.
Row michell_row(Bench& bench, Hull hull, double speed, Row row);

}  // namespace ocean::verify
