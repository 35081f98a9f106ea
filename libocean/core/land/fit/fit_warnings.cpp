// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The warnings of a fit; see fit_warnings.hpp.
#include "fit_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ocean/internal/text.hpp"
#include "relief.hpp"

namespace ocean {
namespace {

std::string length_text(double metres) {
    return metres < 10'000.0 ? significant_text(metres, 4) + " m"
                             : significant_text(metres / 1e3, 4) + " km";
}

/// Warns of each part of the land's variance that the terrain does not keep.
void add_variance_warnings(const ElevationModel& bed, TerrainFit& fit) {
    constexpr double kKept = 0.025;  // of the rms, 5 % of the variance
    const double length = std::max(bed.domain.size[0], bed.domain.size[1]);
    if (length > 1.1 * fit.terrain.patch_size) {
        fit.warnings.push_back(
            "the model is " + length_text(length) + " long and the terrain repeats after " +
            length_text(fit.terrain.patch_size) + ": waves longer than " +
            length_text(fit.terrain.patch_size / 2.0) +
            " are not fitted, and the rms of the heights is " + significant_text(fit.rms, 4) +
            " m, not the " +
            significant_text(relief_of(bed.domain, bed.heights).rms_about_mean, 4) +
            " m of the whole model; a model with larger cells has them");
    }
    if (fit.kept_rms < (1.0 - kKept) * fit.bed.rms_about_mean) {
        fit.warnings.push_back(
            "the land is tilted: its rms is " + significant_text(fit.bed.rms_about_mean, 4) +
            " m, and " + significant_text(fit.kept_rms, 4) +
            " m about its plane, which the terrain has: land that repeats has no plane");
    }
    if (std::abs(fit.rms / fit.kept_rms - 1.0) > kKept) {
        fit.warnings.push_back("the rms of the land is " + significant_text(fit.kept_rms, 4) +
                               " m, that of the terrain " + significant_text(fit.rms, 4) +
                               " m: no seed of the law comes closer");
    }
}

}  // namespace

void add_warnings(const ElevationModel& bed, TerrainFit& fit) {
    constexpr double kGoodError = 0.05, kClearAnisotropy = 1.3, kClearSkewness = 0.5;
    for (const FittedParameter& parameter : fit.parameters) {
        if (!parameter.is_at_bound) continue;
        fit.warnings.push_back(parameter.name + " = " + significant_text(parameter.value, 4) +
                               " is at the bound of its range: this law does not describe the "
                               "land; choose another");
    }
    if (fit.error_above_lowest() > kGoodError) {
        fit.warnings.push_back("above the longest octave the density is off by up to " +
                               fixed_text(fit.error_above_lowest(), 2) +
                               " in log10 in an octave; " +
                               (fit.terrain.rings != nullptr ? "the model has few waves there"
                                                             : "the table law follows the rings"));
    }
    add_variance_warnings(bed, fit);
    if (fit.bed.anisotropy > kClearAnisotropy) {
        fit.warnings.push_back("the land is steeper along " + fixed_text(fit.bed.direction, 0) +
                               " degrees than across, by " + fixed_text(fit.bed.anisotropy, 2) +
                               "; the fit is the same in all directions: see anisotropy");
    }
    if (std::abs(fit.bed.skewness - fit.model.skewness) > kClearSkewness) {
        fit.warnings.push_back("the heights of the land have a skewness of " +
                               fixed_text(fit.bed.skewness, 2) +
                               ", which no spectrum holds: peaks and valleys of the terrain are "
                               "alike");
    }
}

}  // namespace ocean
