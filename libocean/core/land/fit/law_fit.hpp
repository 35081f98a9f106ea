// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits the parameters of a law to rings by least squares of the logarithm of their densities.
#pragma once

#include <span>
#include <vector>

#include "ocean/internal/ring_spectrum.hpp"
#include "ocean/internal/terrain_fit.hpp"

namespace ocean {

struct LawFit {
    std::vector<FittedParameter> parameters;
    double level = 0.0;      // log of S over the law's relative density
    bool has_break = false;  // FitLaw::broken: the rings need two exponents
};

/// Sets the exponents, break and ridge of the terrain: the best of five starts. A broken law that
/// describes the rings no better than chance would becomes a law of one exponent.
LawFit fit_law(std::span<const Ring> rings, FitLaw law, bool ridge, TerrainModel& terrain);

}  // namespace ocean
