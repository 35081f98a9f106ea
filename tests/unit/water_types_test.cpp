// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Jerlov's water types against measurements that the table was not made from.
#include "ocean/internal/water_types.hpp"

#include "ocean/error.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

TEST(WaterTypes, AreNamedInJerlovsOrder) {
    constexpr std::string_view kNames[] = {"jerlov_i",   "jerlov_ia", "jerlov_ib", "jerlov_ii",
                                           "jerlov_iii", "jerlov_1c", "jerlov_3c", "jerlov_5c",
                                           "jerlov_7c",  "jerlov_9c"};
    ASSERT_EQ(water_types().size(), std::size(kNames));
    for (std::size_t i = 0; i < std::size(kNames); ++i) {
        EXPECT_EQ(water_types()[i].name, kNames[i]);
    }
}

TEST(WaterTypes, GetMurkierFromOneToTheNext) {
    for (std::size_t i = 1; i < water_types().size(); ++i) {
        const WaterType& clearer = water_types()[i - 1];
        const WaterType& murkier = water_types()[i];
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_GE(murkier.absorption[c], clearer.absorption[c]) << murkier.name << " " << c;
            EXPECT_GT(murkier.scattering[c], clearer.scattering[c]) << murkier.name << " " << c;
        }
        EXPECT_GT(murkier.absorption[2], clearer.absorption[2]) << murkier.name;
    }
}

TEST(WaterTypes, AbsorbAndScatterNoLessThanPureWater) {
    constexpr Rgb kAbsorbed = {0.2644, 0.0565, 0.01011};  // [Pope and Fry 1997] table 3
    for (const WaterType& type : water_types()) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_GT(type.absorption[c], kAbsorbed[c]) << type.name << " " << c;
            const double of_water = 0.005826 * std::pow(400.0 / kRgbWavelengths[c], 4.322);
            EXPECT_GT(type.scattering[c], of_water) << type.name << " " << c;
        }
    }
}

TEST(WaterTypes, AttenuateDaylightAsJerlovMeasured) {
    // K_d, 1/m, of [Jerlov 1976] table XXVII at 610 nm (between 600 and 625) and 550 nm; for a sun
    // at the zenith K_d = sqrt(a^2 + 0.256 a b) [Kirk 1984]. In the blue the measured absorption of
    // IB is above Jerlov's K_d, by which the types were once defined: that is the state of the art.
    constexpr double kJerlov[][2] = {{0.263, 0.063}, {0.268, 0.067}, {0.273, 0.072}, {0.290, 0.089},
                                     {0.327, 0.120}, {0.328, 0.120}, {0.358, 0.190}, {0.432, 0.300},
                                     {0.504, 0.460}, {0.620, 0.630}};
    ASSERT_EQ(water_types().size(), std::size(kJerlov));
    for (const auto [c, i] : test::pairs<std::size_t>(2, std::size(kJerlov))) {
        const double a = water_types()[i].absorption[c];
        const double b = water_types()[i].scattering[c];
        const double attenuated = std::sqrt(a * a + 0.256 * a * b);
        EXPECT_NEAR(attenuated / kJerlov[i][c], 1.0, 0.2) << water_types()[i].name << " " << c;
    }
}

TEST(WaterTypes, OceansAreBlueAndCoastsGreen) {
    for (const WaterType& type : water_types()) {
        const Rgb albedo = type.water_leaving_albedo();
        const bool coast = type.name.back() == 'c';
        EXPECT_EQ(albedo[1] > albedo[2], coast) << type.name;
        EXPECT_LT(albedo[0], albedo[1]) << type.name;
        for (const double channel : albedo) {
            EXPECT_GT(channel, 0.0);
            EXPECT_LT(channel, 0.05) << type.name;
        }
    }
}

TEST(WaterTypes, ClearOceanReflectsWhatIsObserved) {
    // R just below the surface of blue waters is 2 to 8 % in the blue, under 1 % in the green and
    // next to nothing in the red [Morel and Prieur 1977] fig. 3.
    const Rgb reflected = water_types()[0].irradiance_reflectance();
    EXPECT_GT(reflected[2], 0.02);
    EXPECT_LT(reflected[2], 0.08);
    EXPECT_LT(reflected[1], 0.01);
    EXPECT_LT(reflected[0], 0.001);
    // b_b / a = (0.00305 / 2 + 0.0183 * 0.00031) / 0.0182 by hand.
    EXPECT_NEAR(reflected[2], 0.33 * 0.001528 / 0.0182, 2e-4);
}

TEST(WaterTypes, CrestsAreGreenerThanTheDeepAndDarkInTurbidWater) {
    for (const WaterType& type : water_types()) {
        const Rgb crest = type.crest_colour();
        const Rgb deep = type.water_leaving_albedo();
        EXPECT_GT(crest[1] / crest[2], deep[1] / deep[2]) << type.name;
        EXPECT_LT(crest[0], 0.06) << type.name;
        EXPECT_LT(crest[1], 0.35) << type.name;
    }
    // By hand for II, green: 0.55 (1 - exp(-8 (0.177 + 0.15))) exp(-8 0.0724).
    const Rgb crest = water_type("jerlov_ii").crest_colour();
    EXPECT_NEAR(crest[1], 0.55 * 0.9269 * 0.5603, 2e-4);
    EXPECT_LT(water_type("jerlov_9c").crest_colour()[2], 0.002);
}

TEST(WaterTypes, AreFoundByTheirNames) {
    for (const WaterType& type : water_types()) EXPECT_EQ(&water_type(type.name), &type);
    EXPECT_THROW(water_type("jerlov_x"), Error);
}

}  // namespace
}  // namespace ocean
