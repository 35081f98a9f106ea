// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The parameter table is complete and consistent, and its access functions are strict.
#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/spectrum.hpp"
#include "ocean/parameter_table.hpp"

namespace ocean {
namespace {

std::string message_of(std::string_view name, std::string_view text) {
    Parameters parameters;
    try {
        set_parameter(parameters, name, text);
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

ErrorFields fields_of(std::string_view name, std::string_view text) {
    Parameters parameters;
    try {
        set_parameter(parameters, name, text);
    } catch (const Error& error) {
        return error.fields();
    }
    return {};
}

TEST(ParameterErrors, HaveTheirPartsAsFields) {
    const ErrorFields range = fields_of("water.depth", "-3");
    EXPECT_EQ(range.parameter, "water.depth");
    EXPECT_EQ(range.value, "-3");
    EXPECT_EQ(range.what, "is out of range");
    EXPECT_EQ(range.allowed, "0.01 .. inf m");
    const ErrorFields word = fields_of("waves.0.fetch", "far");
    EXPECT_EQ(word.parameter, "waves.0.fetch");
    EXPECT_EQ(word.value, "\"far\"");
    EXPECT_EQ(fields_of("watre.depth", "3").parameter, "watre.depth");
    EXPECT_EQ(Error(ErrorKind::bad_file, "no such file").fields().what, "no such file");
}

/// The keys without a neutral value are those that every text has. One more would change the text
/// of each sea, and so orphan every bake and cache: a new row has a neutral value.
TEST(ParameterTable, HasEveryKeyOnceAndEachLaterOneIsNeutral) {
    const std::set<std::string> expected = {"water.depth",
                                            "water.gravity",
                                            "water.surface_tension",
                                            "water.density",
                                            "grid.resolution",
                                            "grid.patch_size",
                                            "grid.cascades",
                                            "grid.cascade_divisors",
                                            "surface.choppiness",
                                            "surface.shortest_wavelength",
                                            "surface.longest_wavelength",
                                            "surface.foam_lifetime",
                                            "surface.foam_step",
                                            "surface.foam_coverage",
                                            "surface.foam_threshold",
                                            "surface.foam_width",
                                            "time.start",
                                            "time.first_frame",
                                            "time.fps",
                                            "time.loop_period",
                                            "time.glide",
                                            "time.take",
                                            "random.seed",
                                            "waves.0.spectrum",
                                            "waves.0.wind_speed",
                                            "waves.0.wind_direction",
                                            "waves.0.fetch",
                                            "waves.0.peak_enhancement",
                                            "waves.0.spreading",
                                            "waves.0.swell",
                                            "waves.0.opposing",
                                            "waves.0.significant_wave_height",
                                            "waves.0.peak_period",
                                            "waves.0.amplitude",
                                            "waves.0.alignment",
                                            "waves.0.cutoff_wavelength",
                                            "waves.0.file",
                                            "waves.0.place",
                                            "waves.0.record",
                                            "waves.0.estimator"};
    std::set<std::string> found, always_written;
    for (const ParameterInfo& info : parameter_table()) {
        EXPECT_TRUE(found.insert(info.path()).second) << info.path();
        if (!info.neutral && info.member.items(Parameters{}) > 0) {
            always_written.insert(info.path());
        }
        EXPECT_FALSE(info.help.empty());
        EXPECT_LE(info.min, info.max);
        EXPECT_LE(info.min, info.soft_min) << info.path();
        EXPECT_GE(info.max, info.soft_max) << info.path();
    }
    EXPECT_EQ(always_written, expected);
}

TEST(ParameterTable, DefaultsAreThePublishedOnes) {
    const Parameters p;
    const std::pair<const char*, const char*> defaults[] = {{"depth", "inf"},
                                                            {"gravity", "9.81"},
                                                            {"surface_tension", "0.074"},
                                                            {"resolution", "512"},
                                                            {"patch_size", "500"},
                                                            {"choppiness", "1"},
                                                            {"foam_lifetime", "4"},
                                                            {"foam_step", "0.05"},
                                                            {"foam_coverage", "monahan"},
                                                            {"foam_threshold", "0.75"},
                                                            {"fps", "24"},
                                                            {"glide", "0.5"},
                                                            {"seed", "1"},
                                                            {"spectrum", "phillips"},
                                                            {"wind_speed", ""},
                                                            {"fetch", "300000"},
                                                            {"peak_enhancement", "3.3"},
                                                            {"spreading", "cosine_squared"},
                                                            {"opposing", "1"},
                                                            {"wind_direction", ""},
                                                            {"significant_wave_height", ""},
                                                            {"alignment", "2"},
                                                            {"estimator", "maximum_entropy"},
                                                            {"cascade_divisors", "[]"}};
    for (const auto& [name, value] : defaults) EXPECT_EQ(get_parameter(p, name), value) << name;
}

TEST(ParameterTable, EveryDefaultIsAcceptedBackAsText) {
    Parameters p;
    p.crests.resize(1);
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

TEST(ParameterTable, NumbersKeepTheirBitsAsText) {
    Parameters p;
    p.waves.front().wind_speed = 0.1 + 0.2;
    const std::string text = get_parameter(p, "wind_speed");
    Parameters q;
    set_parameter(q, "wind_speed", text);
    EXPECT_EQ(p.waves.front().wind_speed, q.waves.front().wind_speed);
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
    EXPECT_TRUE(contains(message_of("depth", "-3"),
                         "water.depth = -3: is out of range; allowed: 0.01 .. inf m"));
    EXPECT_TRUE(contains(message_of("resolution", "300"), "a power of two, 32 .. 8192"));
    EXPECT_TRUE(contains(message_of("resolution", "64.5"), "not a whole number"));
    EXPECT_TRUE(contains(message_of("wind_speed", "nan"), "not a number"));
    EXPECT_TRUE(contains(message_of("wind_speed", "inf"), "out of range"));
    EXPECT_TRUE(contains(message_of("wind_speed", "10 m"), "not a number"));
    EXPECT_TRUE(contains(message_of("fetch", ""), "not a number"));
    EXPECT_TRUE(contains(message_of("alignment", "3"), "is not even"));
    EXPECT_TRUE(contains(message_of("spectrum", "jonswop"), "jonswap, tma, measured"));
    EXPECT_TRUE(contains(message_of("wind_sped", "3"), "did you mean waves.0.wind_speed?"));
    EXPECT_TRUE(contains(message_of("seed", "4294967296"), "out of range"));
    EXPECT_EQ(message_of("seed", "4294967295"), "accepted");
    EXPECT_EQ(message_of("depth", "inf"), "accepted");
    EXPECT_EQ(message_of("significant_wave_height", ""), "accepted");
}

TEST(ParameterTable, BandLimitsMustBeInOrderOnceAllAreSet) {
    Parameters p;
    set_parameter(p, "shortest_wavelength", "5");
    set_parameter(p, "longest_wavelength", "4");
    EXPECT_THROW(validate(p), Error);
    set_parameter(p, "longest_wavelength", "6");
    EXPECT_NO_THROW(validate(p));
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

TEST(ParameterTable, AMeasuredSystemNeedsItsFile) {
    Parameters p;
    set_parameter(p, "spectrum", "measured");
    try {
        validate(p);
        FAIL();
    } catch (const Error& error) {
        EXPECT_TRUE(contains(error.what(), "needs waves.0.file")) << error.what();
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
    const auto refused = [](SpectrumRecord record) {
        Parameters p;
        p.waves.front().spectrum = SpectrumKind::measured;
        p.waves.front().measured = std::make_shared<SpectrumRecord>(std::move(record));
        try {
            validate(p);
        } catch (const Error&) {
            return true;
        }
        return false;
    };
    SpectrumRecord good;
    good.frequency = {0.1, 0.2};
    good.density = {1.0, 2.0};
    EXPECT_FALSE(refused(good));
    SpectrumRecord bad = good;
    bad.frequency = {0.1};
    bad.density = {1.0};
    EXPECT_TRUE(refused(bad));
    bad = good;
    bad.frequency = {0.2, 0.1};
    EXPECT_TRUE(refused(bad));
    bad = good;
    bad.density = {1.0, -1.0};
    EXPECT_TRUE(refused(bad));
    bad = good;
    bad.a1 = {0.0, 0.0};
    EXPECT_TRUE(refused(bad));
}

TEST(ParameterTable, MarkdownAndJsonListEveryParameter) {
    const std::string markdown = parameters_markdown();
    const std::string json = parameters_json();
    for (const ParameterInfo& info : parameter_table()) {
        EXPECT_TRUE(contains(markdown, "." + std::string(info.key) + "`")) << info.key;
        EXPECT_TRUE(contains(json, "\"key\": \"" + std::string(info.key) + "\"")) << info.key;
    }
    EXPECT_TRUE(contains(json, R"("used_by": ["jonswap", "tma"])"));
}

}  // namespace
}  // namespace ocean
