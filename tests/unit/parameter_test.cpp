// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The parameter table is complete and consistent, and its access functions are strict.

#include <cstddef>
#include <set>

#include "ocean/enum_words.hpp"
#include "ocean/internal/spectrum.hpp"
#include "ocean/parameter_table.hpp"
#include "refusal.hpp"

namespace ocean {
namespace {

test::Refusal refusal_of(std::string_view name, std::string_view text) {
    Parameters parameters;
    return test::refusal_of([&] { set_parameter(parameters, name, text); });
}

TEST(ParameterErrors, HaveTheirPartsAsFields) {
    const ErrorFields range = refusal_of("water.depth", "-3").fields;
    EXPECT_EQ(range.parameter, "water.depth");
    EXPECT_EQ(range.value, "-3");
    EXPECT_EQ(range.what, "is out of range");
    EXPECT_EQ(range.allowed, "0.01 .. inf m");
    const ErrorFields word = refusal_of("waves.0.fetch", "far").fields;
    EXPECT_EQ(word.parameter, "waves.0.fetch");
    EXPECT_EQ(word.value, "\"far\"");
    EXPECT_EQ(refusal_of("watre.depth", "3").fields.parameter, "watre.depth");
    EXPECT_EQ(Error(ErrorKind::bad_file, "no such file").fields().what, "no such file");
}

/// The keys without a neutral value are those that every text has. One more would change the text
/// of each sea, and so orphan every bake and cache: a new row has a neutral value.
TEST(ParameterTable, HasEveryKeyOnceAndEachLaterOneIsNeutral) {
    const std::string expected =
        "water: depth gravity surface_tension density\n"
        "grid: resolution patch_size cascades cascade_divisors\n"
        "surface: choppiness shortest_wavelength longest_wavelength foam_lifetime foam_step"
        " foam_coverage foam_threshold foam_width\n"
        "time: start first_frame fps loop_period glide take\n"
        "random: seed\n"
        "waves.0: spectrum wind_speed wind_direction fetch peak_enhancement spreading swell"
        " opposing significant_wave_height peak_period amplitude alignment cutoff_wavelength"
        " file record place estimator\n";
    const Parameters defaults;
    std::set<std::string> found;
    std::string always_written, section;
    for (const ParameterInfo& info : parameter_table()) {
        EXPECT_TRUE(found.insert(info.path()).second) << info.path();
        if (!info.neutral && info.member.items(defaults) > 0) {
            const std::string here = info.path().substr(0, info.path().rfind('.'));
            if (here != section) always_written += (section.empty() ? "" : "\n") + here + ":";
            section = here;
            always_written += " " + std::string(info.key);
        }
        EXPECT_FALSE(info.help.empty());
        EXPECT_LE(info.min, info.max);
        EXPECT_LE(info.min, info.soft_min) << info.path();
        EXPECT_GE(info.max, info.soft_max) << info.path();
    }
    EXPECT_EQ(always_written + "\n", expected);
}

TEST(ParameterTable, DefaultsAreThePublishedOnes) {
    const Parameters p;
    std::istringstream defaults(
        "depth inf gravity 9.81 surface_tension 0.074 resolution 512 patch_size 500 choppiness 1 "
        "foam_lifetime 4 foam_step 0.05 foam_coverage monahan foam_threshold 0.75 fps 24 "
        "glide 0.5 seed 1 spectrum phillips fetch 300000 peak_enhancement 3.3 "
        "spreading cosine_squared opposing 1 alignment 2 estimator maximum_entropy "
        "cascade_divisors []");
    for (std::string name, value; defaults >> name >> value;) {
        EXPECT_EQ(get_parameter(p, name), value) << name;
    }
    for (const char* unset : {"wind_speed", "wind_direction", "significant_wave_height"}) {
        EXPECT_EQ(get_parameter(p, unset), "") << unset;
    }
}

TEST(ParameterTable, EveryDefaultIsAcceptedBackAsText) {
    Parameters p;
    p.crests.resize(1);
    p.hulls.resize(1);
    for (const ParameterInfo& info : parameter_table()) {
        const std::string text = get_parameter(p, info.path());
        EXPECT_NO_THROW(set_parameter(p, info.path(), text)) << info.path() << " = " << text;
        EXPECT_EQ(get_parameter(p, info.path()), text);
    }
}

TEST(ParameterTable, HeightsOfCrestsAreMetresOrMultiplesOfHs) {
    Parameters p;
    p.crests.resize(1);
    for (const char* text : {"5.25", "1.3 Hs", "-0.7 Hs"}) {
        set_parameter(p, "crests.0.height", text);
        EXPECT_EQ(get_parameter(p, "crests.0.height"), text);
    }
    set_parameter(p, "crests.0.height", "1.30Hs");
    EXPECT_EQ(p.crests[0].height, (WaveHeight{1.3, true}));
    EXPECT_EQ(p.crests[0].height.metres(2.0), 2.6);
    set_parameter(p, "crests.0.height", "5");
    EXPECT_EQ(p.crests[0].height.metres(2.0), 5.0);
    for (const char* text : {"", "Hs", "5 m", "1.3 hs", "nan", "nan Hs", "inf Hs", "201"}) {
        EXPECT_THROW(set_parameter(p, "crests.0.height", text), Error) << text;
    }
    EXPECT_THROW(set_parameter(p, "height", "1"), Error) << "no bare key of so common a word";
}

TEST(ParameterTable, BareKeysPathsAndWaveNumbersNameTheSame) {
    Parameters p;
    p.waves.resize(2);
    set_parameter(p, "wind_speed", "11");
    set_parameter(p, "waves.1.wind_speed", "12");
    set_parameter(p, "grid.resolution", "64");
    EXPECT_EQ(get_parameter(p, "waves.0.wind_speed"), "11");
    EXPECT_EQ(p.waves[1].wind_speed, 12.0);
    EXPECT_EQ(get_parameter(p, "resolution"), "64");
    EXPECT_THROW(set_parameter(p, "waves.2.wind_speed", "1"), Error);
    EXPECT_THROW(find_parameter("waves.wind_speed"), Error);
    EXPECT_THROW(find_parameter("waves.-1.wind_speed"), Error);
    EXPECT_THROW(find_parameter("water.resolution"), Error);
}

TEST(ParameterTable, WhatIsWrongIsSaidWithTheAllowedRange) {
    constexpr std::array<const char*, 3> kWrong[] = {
        {"depth", "-3", "water.depth = -3: is out of range; allowed: 0.01 .. inf m"},
        {"resolution", "300", "a power of two, 32 .. 8192"},
        {"resolution", "64.5", "not a whole number"},
        {"wind_speed", "nan", "not a number"},
        {"wind_speed", "inf", "out of range"},
        {"wind_speed", "10 m", "not a number"},
        {"fetch", "", "not a number"},
        {"alignment", "3", "is not even"},
        {"spectrum", "jonswop", "jonswap, tma, measured"},
        {"wind_sped", "3", "did you mean waves.0.wind_speed?"},
        {"seed", "4294967296", "out of range"}};
    for (const auto& [name, text, words] : kWrong) {
        EXPECT_TRUE(test::says(refusal_of(name, text).message, words)) << name << " = " << text;
    }
    for (const auto& [name, text] :
         {std::pair("seed", "4294967295"), {"depth", "inf"}, {"significant_wave_height", ""}}) {
        EXPECT_FALSE(refusal_of(name, text).refused) << name;
    }
}

TEST(ParameterTable, EachSpectrumUsesTheParameterThatItsDirectionsFollow) {
    const auto is_used = [](std::string_view parameter, std::string_view spectrum) {
        const std::string words = ", " + std::string(find_parameter(parameter).info->used_by) + ",";
        return words.find(", " + std::string(spectrum) + ",") != std::string::npos;
    };
    for (std::size_t i = 0; i < enum_count<SpectrumKind>(); ++i) {
        const auto kind = static_cast<SpectrumKind>(i);
        const bool is_aligned = direction_law(kind) == DirectionLaw::alignment;
        EXPECT_EQ(is_used("alignment", word_of(kind)), is_aligned) << word_of(kind);
        EXPECT_EQ(is_used("spreading", word_of(kind)), !is_aligned) << word_of(kind);
    }
}

TEST(ParameterTable, AnotherFileOrRecordDropsTheOldRecord) {
    Parameters p;
    p.waves.front().measured = std::make_shared<SpectrumRecord>();
    set_parameter(p, "file", "");
    EXPECT_TRUE(p.waves.front().measured) << "nothing changed";
    set_parameter(p, "record", "2020-06-08T02:50");
    EXPECT_FALSE(p.waves.front().measured);
}

TEST(ParameterTable, AMeasuredRecordMustBeUsable) {
    SpectrumRecord record;
    record.frequency = {0.1, 0.2};
    for (const double density : {2.0, -1.0}) {
        record.density = {1.0, density};
        Parameters p;
        p.waves.front().spectrum = SpectrumKind::measured;
        p.waves.front().measured = std::make_shared<SpectrumRecord>(record);
        EXPECT_EQ(test::refusal_of([&] { validate(p); }).refused, density < 0.0);
    }
}

TEST(ParameterTable, MarkdownAndJsonListEveryParameter) {
    const std::string markdown = parameters_markdown();
    const std::string json = parameters_json();
    for (const ParameterInfo& info : parameter_table()) {
        EXPECT_TRUE(test::says(markdown, "." + std::string(info.key) + "`")) << info.key;
        EXPECT_TRUE(test::says(json, "\"key\": \"" + std::string(info.key) + "\"")) << info.key;
    }
    EXPECT_TRUE(test::says(json, R"("used_by": ["jonswap", "tma"])"));
}

}  // namespace
}  // namespace ocean
