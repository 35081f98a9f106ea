// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Units of spectral densities: the factor of each spelling, in units/density.toml, and
// what is no unit.
#include "ocean/internal/density_units.hpp"

#include "corpus.hpp"

namespace ocean {
namespace {

TEST(DensityUnits, HaveTheFactorsOfTheTable) {
    const toml::table table =
        test::read_table(test::source_dir() + "/tests/seafile/units/density.toml");
    for (const auto& [key, over] :
         {std::pair{"frequency", DensityOver::frequency},
          {"frequency_and_direction", DensityOver::frequency_and_direction}}) {
        for (const toml::node& row : *table[key].as_array()) {
            const std::string text = test::text_of((*row.as_array())[0]);
            const double factor = (*row.as_array())[1].value<double>().value();
            const DensityUnit unit = parse_density_unit(text, over);
            EXPECT_EQ(unit.fault, "") << text;
            EXPECT_NEAR(unit.factor, factor, 1e-12 * factor) << text;
        }
    }
}

TEST(DensityUnits, WhatIsNoDensityIsRefusedAsItWasUnderstood) {
    const auto fault = [](std::string_view text, DensityOver over = DensityOver::frequency) {
        return parse_density_unit(text, over).fault;
    };
    const auto says = [](const std::string& message, const char* words) {
        EXPECT_TRUE(test::says(message, words));
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
