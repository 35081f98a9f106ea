// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The steps of the numbers of the waves; see passage_steps.hpp.
#include "waves/state/passage_steps.hpp"

#include <algorithm>
#include <cmath>

namespace ocean {

std::optional<PassageSteps> PassageSteps::of(const ParameterInfo& info) {
    // The peak of a JONSWAP spectrum, 0.07 of its frequency wide below it, moves by a third of the
    // steps of wind and fetch [Hasselmann 1973], and by all of a step of the period.
    if (info.holds<&WaveSystem::wind_speed>()) return PassageSteps(Kind::factors, 0.0175, 1.0);
    if (info.holds<&WaveSystem::fetch>()) return PassageSteps(Kind::factors, 0.02, 1000.0);
    if (info.holds<&WaveSystem::peak_period>()) return PassageSteps(Kind::factors, 0.007, 0.1);
    if (info.holds<&WaveSystem::significant_wave_height>()) {
        return PassageSteps(Kind::factors, 0.5, 0.1);
    }
    if (info.holds<&WaveSystem::peak_enhancement>()) {
        return PassageSteps(Kind::factors, 0.12, 1.0);
    }
    if (info.holds<&WaveSystem::swell>()) return PassageSteps(Kind::sums, 0.05);
    if (info.holds<&WaveSystem::wind_direction>()) return PassageSteps(Kind::directions, 2.0);
    return std::nullopt;
}

double PassageSteps::number_of(double value) const {
    if (kind_ != Kind::factors) return value / step_;
    return (value < first_ ? value / first_ - 1.0 : std::log(value / first_)) / std::log1p(step_);
}

double PassageSteps::value_of(double number) const {
    if (kind_ != Kind::factors) return number * step_;
    const double scaled = number * std::log1p(step_);
    return scaled < 0.0 ? first_ * (scaled + 1.0) : first_ * std::exp(scaled);
}

double PassageSteps::between(double a, double b) const {
    if (kind_ == Kind::directions) return std::abs(std::remainder(b - a, 360.0)) / step_;
    return std::abs(number_of(b) - number_of(a));
}

PassageSteps::Around PassageSteps::around(double value, double min, double max) const {
    const double number = std::floor(number_of(value));
    const Around steps{std::max(value_of(number), min), std::min(value_of(number + 1.0), max)};
    // Rounding may put a value that is a step itself outside.
    return {std::min(steps.low, value), std::max(steps.high, value)};
}

}  // namespace ocean
