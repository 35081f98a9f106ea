// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Units of spectral densities: the factor of each spelling to m^2/Hz or m^2/Hz/degree, by hand.
#include "ocean/internal/density_units.hpp"
#include "ocean/internal/grid.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

namespace ocean {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kEnergy = 1025.0 * 9.81;  // J/m^4, rho g as SWAN has it

using Cases = std::initializer_list<std::pair<const char*, double>>;

void expect_factors(const Cases& cases, DensityOver over) {
    for (const auto& [text, factor] : cases) {
        const DensityUnit unit = parse_density_unit(text, over);
        EXPECT_EQ(unit.fault, "") << text;
        EXPECT_NEAR(unit.factor, factor, 1e-12 * factor) << text;
    }
}

TEST(DensityUnits, OfFrequencyAlone) {
    expect_factors(
        {
            {"m2 s", 1.0},
            {"m2s", 1.0},
            {"m^2/Hz", 1.0},
            {"M**2/HZ", 1.0},
            {"m2 Hz-1", 1.0},
            {"m2 hertz-1", 1.0},
            {"m2 per Hz", 1.0},
            {"m2.s", 1.0},
            {"m2_s", 1.0},
            {"m^2-s", 1.0},
            {"m 2 s", 1.0},
            {"m^{2} Hz^{-1}", 1.0},
            {"$m^2/Hz$", 1.0},
            {"[m^2/Hz]", 1.0},
            {"m\u00b2 s", 1.0},
            {"m\u00b2\u00b7Hz\u207b\u00b9", 1.0},
            {"m\xb2/Hz", 1.0},
            {"meter^2 second", 1.0},
            {"meter**2/hertz", 1.0},
            {"metres^2 seconds", 1.0},
            {"m2 sec", 1.0},
            {"(meter * meter)/Hz", 1.0},
            {"square meters per hertz", 1.0},
            {"meters squared per Hertz", 1.0},
            {"meter-squared second", 1.0},
            {"sq m/Hz", 1.0},
            {"m2/s-1", 1.0},
            {"m2/(1/s)", 1.0},
            {"m2/(cycles/s)", 1.0},
            {"m2/cps", 1.0},
            {"m2/cph", 3600.0},
            {"cm2/Hz", 1e-4},
            {"cm^2 s", 1e-4},
            {"mm2/Hz", 1e-6},
            {"centimeters^2/Hz", 1e-4},
            {"m2/mHz", 1e3},
            {"1e-4 m2/Hz", 1e-4},
            {"10^-3 m2 s", 1e-3},
            {"0.01 m2/Hz", 0.01},
            {"ft2/Hz", 0.3048 * 0.3048},
            {"feet^2 / Hz", 0.3048 * 0.3048},
            {"J/m2/Hz", 1.0 / kEnergy},
            {"J m-2 Hz-1", 1.0 / kEnergy},
            {"kJ/m^2/Hz", 1e3 / kEnergy},
            {"joules per square meter per hertz", 1.0 / kEnergy},
            {"J/m2/(rad/s)", kTurn / kEnergy},
            {"m2/(rad/s)", kTurn},
            {"m2 s/rad", kTurn},
            {"m^2.s.rad^-1", kTurn},
            {"m2 s rad-1", kTurn},
            {"m^2 / (rad s^-1)", kTurn},
            {"m^2-s/rad", kTurn},
            {"m2 per radian per second-1", kTurn},
        },
        DensityOver::frequency);
}

TEST(DensityUnits, OfFrequencyAndDirection) {
    expect_factors(
        {
            {"m2 s degree-1", 1.0},
            {"m^{2}.s.degree^{-1}", 1.0},
            {"m2/Hz/deg", 1.0},
            {"m2/Hz/degr", 1.0},
            {"m^2/(Hz deg)", 1.0},
            {"m2/(Hz.deg)", 1.0},
            {"m2/(Hz*degrees)", 1.0},
            {"m2/Hz deg", 1.0},
            {"m2/Hz-deg", 1.0},
            {"m2 per Hz degree", 1.0},
            {"m2/Hz/\u00b0", 1.0},
            {"m2 degree-1 s", 1.0},
            {"m2 s deg -1", 1.0},
            {"metre^2 Hz^-1 degree^-1", 1.0},
            {"cm2/Hz/deg", 1e-4},
            {"m**2 s radian**-1", kDegree},
            {"m2 s rad-1", kDegree},
            {"m2 s/rad", kDegree},
            {"m2 Hz-1 rad-1", kDegree},
            {"m2/Hz/radian", kDegree},
            {"m2 s rad\u207b\u00b9", kDegree},
            {"m2/(rad/s)/deg", kTurn},
            {"m2/(rad/s)/rad", kTurn * kDegree},
            {"m2 s rad-2", kTurn * kDegree},
            {"J/m2/Hz/deg", 1.0 / kEnergy},
            {"J/m2/Hz/rad", kDegree / kEnergy},
        },
        DensityOver::frequency_and_direction);
}

TEST(DensityUnits, WhatIsNoDensityIsRefusedAsItWasUnderstood) {
    const auto fault = [](std::string_view text, DensityOver over = DensityOver::frequency) {
        return parse_density_unit(text, over).fault;
    };
    const auto says = [](const std::string& message, const char* words) {
        EXPECT_NE(message.find(words), std::string::npos) << words << " not in: " << message;
    };
    says(fault("m2"), "units 'm2': m^2 is not a unit of a density over frequency");
    says(fault("m2 Hz"), "m^2 Hz is not a");
    says(fault("m2/Hz/rad"), "m^2 rad^-1 Hz^-1 is not a unit of a density over frequency, like");
    says(fault("m2/rad/s"), "m^2 s^-1 rad^-1 is not a");
    says(fault("m2/Hz/deg"), "m^2 degree^-1 Hz^-1 is not a unit of a density over frequency, like");
    says(fault("m2 s", DensityOver::frequency_and_direction),
         "m^2 s is not a unit of a density over "
         "frequency and direction");
    says(fault("m2 s deg", DensityOver::frequency_and_direction), "m^2 s degree is not a");
    says(fault("m2/Hz/degx", DensityOver::frequency_and_direction), "'degx' is not a known unit");
    says(fault("kW/m/Hz"), "'kw' is not a known unit");
    says(fault("1"), "a number is not a unit");
    says(fault(""), "a unit is missing");
    says(fault("m2/"), "is not a known unit");
    says(fault("m2/(Hz"), "a parenthesis is not closed");
    says(fault("m2/Hz)"), "')' is not understood");
    says(fault("m^99 s"), "must begin with a power of at most 9");
    says(fault("1e-300 m2 s"), "must begin with a number, 1e-12 .. 1e12");
    says(fault(std::string(101, 'm')), "too long");
    for (const char* other :
         {"m", "cm2", "J/m2", "m 2.5 s", "m^2.5 s", "m3 s", "m2 s s", "((((((((((", "^2", "per",
          "m2 s kg", "**", "-", "m2 s +", "\xff\xfe"}) {
        EXPECT_NE(fault(other), "") << other;
        EXPECT_NE(fault(other, DensityOver::frequency_and_direction), "") << other;
    }
}

}  // namespace
}  // namespace ocean
