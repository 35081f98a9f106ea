// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "cover_pattern.hpp"

#include <algorithm>

#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/parameter_table.hpp"

namespace ocean::preview {
namespace {

bool have_same_waves(const Parameters& a, const Parameters& b) {
    const auto first = first_dirty_stage(a, b);
    return !first || *first > Stage::spectrum;
}

}  // namespace

const CoverPattern& CoverPatterns::of(const Parameters& parameters, ThreadPool& pool) {
    if (made_of_ && have_same_waves(parameters, *made_of_)) return pattern_;
    const SpectralMoments moments =
        make_directional_spectrum(parameters, pool).moments(parameters.water);
    const double height = moments.significant_wave_height();
    pattern_.direction = moments.mean_direction;
    pattern_.stretch = 1.5 + 0.7 * std::clamp((height - 4.0) / 3.0, 0.0, 1.0);
    pattern_.streaks = 0.3 * std::clamp((height - 2.0) / 4.0, 0.0, 1.0);
    made_of_ = parameters;
    return pattern_;
}

}  // namespace ocean::preview
