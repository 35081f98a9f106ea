// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea-file reader is strict: each kind of mistake ends in an error that names the file, the
// line, the key, the value and the allowed values.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "helpers.hpp"

namespace ocean::test {
namespace {

struct Mistake {
    std::string name;
    std::string body;  // begins on line 2
    std::vector<std::string> says;
    ErrorKind kind = ErrorKind::invalid_value;
};

std::string name_of(const testing::TestParamInfo<Mistake>& info) {
    return info.param.name;
}

class SeaFileMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SeaFileMistake, IsRefusedWithFileLineKeyValueAndRange) {
    const Refusal refusal = refusal_of_sea(GetParam().body);
    ASSERT_TRUE(refusal.refused);
    EXPECT_EQ(refusal.kind, GetParam().kind) << refusal.message;
    for (const std::string& words : GetParam().says) {
        EXPECT_TRUE(refusal.says(words)) << "'" << words << "' is not in: " << refusal.message;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Each, SeaFileMistake,
    testing::Values(
        Mistake{"UnknownKey",
                "[grid]\npatch_size = 100\nresolutoin = 512\n",
                {"test.toml:4: ", "grid.resolutoin", "did you mean grid.resolution?"}},
        Mistake{"UnknownKeyOfAWaveSystem",
                "[[waves]]\n[[waves]]\nwindspeed = 3\n",
                {"test.toml:4: ", "waves.1.windspeed", "wind_speed"}},
        Mistake{"KeyOfAnotherSection", "[grid]\ndepth = 5.0\n", {"test.toml:3: ", "grid.depth"}},
        Mistake{"UnknownSection", "\n[grd]\n", {"test.toml:3: grd", "did you mean grid?", "water"}},
        Mistake{"KeyOutsideItsSection",
                "resolution = 512\n",
                {"test.toml:2: resolution = 512", "[grid]"}},
        Mistake{"TextForANumber",
                "[grid]\npatch_size = \"big\"\n",
                {"test.toml:3: grid.patch_size = \"big\"", "allowed: 1 .. "}},
        Mistake{"TrueForANumber",
                "[grid]\npatch_size = true\n",
                {"test.toml:3: grid.patch_size = true", "not a number"}},
        Mistake{"FractionForAWholeNumber",
                "[grid]\nresolution = 512.0\n",
                {"test.toml:3: grid.resolution = 512.0", "32 .. 8192"}},
        Mistake{"NumberForAWord",
                "[[waves]]\nspectrum = 2\n",
                {"test.toml:3: waves.0.spectrum = 2", "jonswap"}},
        Mistake{"UnknownWord",
                "[[waves]]\nspectrum = \"jonswop\"\n",
                {"test.toml:3: waves.0.spectrum = \"jonswop\"", "pierson_moskowitz, jonswap"}},
        Mistake{"DateForAText",
                "[[waves]]\nrecord = 2020-06-08T03:50:00\n",
                {"test.toml:3: waves.0.record = a date", "in quotes"}},
        Mistake{"NumberForAList",
                "[grid]\ncascade_divisors = 7\n",
                {"test.toml:3: grid.cascade_divisors = 7", "whole numbers"}},
        Mistake{"TextInAList",
                "[grid]\ncascade_divisors = [1, \"7\"]\n",
                {"test.toml:3: grid.cascade_divisors", "\"7\""}},
        Mistake{"TableForAValue",
                "[grid.resolution]\nvalue = 3\n",
                {"test.toml:2: grid.resolution = a table"}},
        Mistake{"ValueForASection", "grid = 3\n", {"test.toml:2: grid = 3", "[grid]"}},
        Mistake{"SectionTwiceAsArray", "[[grid]]\n", {"test.toml:2: grid", "[grid]"}},
        Mistake{"WavesInSingleBrackets",
                "[waves]\nswell = 0.0\n",
                {"test.toml:2: waves = a table", "[[waves]]"}},
        Mistake{"NoWaveSystem", "waves = []\n", {"test.toml:2: waves", "[[waves]]"}},
        Mistake{"NotANumber",
                "[grid]\npatch_size = nan\n",
                {"test.toml:3: grid.patch_size = nan", "allowed: 1 .. "}},
        Mistake{"InfiniteWhereItIsNotAllowed",
                "[time]\nstart = inf\n",
                {"test.toml:3: time.start = inf", "out of range"}},
        Mistake{"BelowItsRange",
                "[water]\ndepth = 0.001\n",
                {"test.toml:3: water.depth = 0.001", "allowed: 0.01 .. inf m"}},
        Mistake{
            "AboveItsRange",
            "[random]\nseed = 4294967296\n",
            {"test.toml:3: random.seed = 4294967296", "allowed: a whole number, 0 .. 4294967295"}},
        Mistake{"WholeNumberThatNoFloatHolds",
                "[grid]\npatch_size = 9223372036854775807\n",
                {"test.toml:3: grid.patch_size = ", "out of range"}},
        Mistake{"NoPowerOfTwo",
                "[grid]\nresolution = 300\n",
                {"test.toml:3: grid.resolution = 300", "allowed: a power of two, 32 .. 8192"}},
        Mistake{"OddAlignment",
                "[[waves]]\nalignment = 3\n",
                {"test.toml:3: waves.0.alignment = 3", "allowed: an even number, 2 .. 16"}},
        Mistake{"KeyTwice",
                "[grid]\nresolution = 512\nresolution = 256\n",
                {"test.toml:4: ", "resolution"},
                ErrorKind::bad_file},
        Mistake{"SectionTwice",
                "[grid]\n[water]\n[grid]\n",
                {"test.toml:4: ", "grid"},
                ErrorKind::bad_file},
        Mistake{"BandLimitsInTheWrongOrder",
                "[surface]\nlongest_wavelength = 1\nshortest_wavelength = 5\n",
                {"test.toml:3: surface.longest_wavelength = 1", "surface.shortest_wavelength = 5"}},
        Mistake{"CascadesThatHaveNoLattice",
                "[grid]\ncascades = 2\ncascade_divisors = [1, 1]\n",
                {"test.toml:4: grid.cascade_divisors = [1, 1]", "must ascend"}},
        Mistake{"MeasuredSeaWithoutFile",
                "[[waves]]\nspectrum = \"measured\"\n",
                {"test.toml:3: waves.0.spectrum = \"measured\"", "file"}},
        Mistake{"SpectrumFileThatIsNotThere",
                "[[waves]]\nspectrum = \"measured\"\nfile = \"nowhere.data_spec\"\n",
                {"test.toml:4: waves.0.file = \"nowhere.data_spec\"", "no such file"},
                ErrorKind::bad_file},
        Mistake{"RecordThatIsNotThere",
                "[[waves]]\nspectrum = \"measured\"\nfile = \"ndbc_41010.data_spec\"\n"
                "record = \"2020-06-08T05:00\"\n",
                {"test.toml:4: waves.0.file", "2020-06-08T05:00", "nearest is 2020-06-08T03:50"},
                ErrorKind::not_found},
        Mistake{"RecordThatIsNoTime",
                "[[waves]]\nspectrum = \"measured\"\nfile = \"ndbc_41010.data_spec\"\n"
                "record = \"yesterday\"\n",
                {"test.toml:4: waves.0.file", "record = \"yesterday\"", "2020-06-08T03:50"}},
        Mistake{"ControlCharacterInAText",
                "[[waves]]\nfile = \"a\\u0000b\"\n",
                {"test.toml:3: waves.0.file = \"a?b\"", "control character"}}),
    name_of);

TEST(SeaFile, WithoutVersionIsRefused) {
    const Refusal refusal = refusal_of([] { parse_sea("[grid]\n", "test.toml", ""); });
    EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
    EXPECT_TRUE(refusal.says("test.toml: ") && refusal.says("libocean = 1")) << refusal.message;
}

TEST(SeaFile, OfAnotherVersionIsRefused) {
    for (const char* version : {"2", "0", "1.0", "\"1\""}) {
        const std::string line = "libocean = " + std::string(version);
        const Refusal refusal = refusal_of([&] { parse_sea("\n" + line, "test.toml", ""); });
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
        EXPECT_TRUE(refusal.says("test.toml:2: " + line)) << refusal.message;
        EXPECT_TRUE(refusal.says("allowed: libocean = 1")) << refusal.message;
    }
}

TEST(SeaFile, ThatIsMissingIsABadFileWithItsPath) {
    const Refusal refusal = refusal_of([] { read_sea(kData + "/no_such_sea.toml"); });
    EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
    EXPECT_TRUE(refusal.says(kData + "/no_such_sea.toml: no such file")) << refusal.message;
}

TEST(SeaFile, TheFirstMistakeInTheFileIsReportedFirst) {
    const Refusal refusal = refusal_of_sea("[water]\ndepth = -1\n[grid]\nresolution = 3\n");
    EXPECT_TRUE(refusal.says("test.toml:3: water.depth")) << refusal.message;
}

TEST(SeaFile, EmptyOfSectionsIsOneDefaultSystem) {
    EXPECT_EQ(difference(parse(""), Sea{}), "");
    EXPECT_EQ(parse("").parameters.waves.size(), 1u);
}

TEST(SeaFile, WholeNumbersStandForFloats) {
    const Parameters parameters = parse("[grid]\npatch_size = 100\n").parameters;
    EXPECT_EQ(parameters.grid.patch_size, 100.0);
}

TEST(SeaFile, OptionalsAreUnsetUnlessGiven) {
    const Parameters parameters = parse("[[waves]]\n[[waves]]\nwind_direction = 0\n").parameters;
    EXPECT_FALSE(parameters.waves[0].wind_direction.has_value());
    EXPECT_FALSE(parameters.waves[0].significant_wave_height.has_value());
    EXPECT_FALSE(parameters.waves[0].peak_period.has_value());
    EXPECT_EQ(parameters.waves[1].wind_direction, 0.0);
}

TEST(SeaFile, InfiniteDepthIsAllowed) {
    EXPECT_EQ(parse("[water]\ndepth = inf\n").parameters.water.depth,
              std::numeric_limits<double>::infinity());
}

TEST(SeaFile, SixteenWaveSystemsAreReadSeventeenRefused) {
    std::string body;
    for (int i = 0; i < 16; ++i) body += "[[waves]]\n";
    EXPECT_EQ(parse(body).parameters.waves.size(), 16u);
    const Refusal refusal = refusal_of_sea(body + "[[waves]]\n");
    EXPECT_TRUE(refusal.says("test.toml:18: waves: 17")) << refusal.message;
}

TEST(SeaFile, WindowsLineEndsAndByteOrderMarkAreRead) {
    const Sea sea = parse_sea("\xEF\xBB\xBFlibocean = 1\r\n[grid]\r\nresolution = 64\r\n", "t", "");
    EXPECT_EQ(sea.parameters.grid.resolution, 64);
}

TEST(SeaFile, Utf16WithItsByteOrderMarkIsRead) {
    // "libocean = 1 # ü 𝄞", as PowerShell's `>` writes it.
    const std::u16string text =
        u"\uFEFFlibocean = 1 # \u00FC \U0001D11E\r\n[grid]\r\nresolution = 64\r\n";
    for (const bool little : {true, false}) {
        std::string bytes;
        for (const char16_t unit : text) {
            const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit);
            bytes += little ? low : high;
            bytes += little ? high : low;
        }
        EXPECT_EQ(parse_sea(bytes, "t", "").parameters.grid.resolution, 64);
        const Refusal cut =
            refusal_of([&] { parse_sea(bytes.substr(0, bytes.size() - 1), "test.toml", ""); });
        EXPECT_TRUE(cut.says("UTF-16")) << cut.message;
        std::string half = bytes;
        half.erase(bytes.find(little ? "\x1e\xdd" : "\xdd\x1e"), 2);
        const Refusal halved = refusal_of([&] { parse_sea(half, "test.toml", ""); });
        EXPECT_TRUE(halved.says("test.toml:1")) << halved.message;
        EXPECT_TRUE(halved.says("half a character")) << halved.message;
    }
}

TEST(SeaFile, TimeOfAFrameFollowsFromTheKeysAlone) {
    const Sea sea = parse("[time]\nstart = 5.0\nfirst_frame = 11\nfps = 25.0\n");
    EXPECT_EQ(sea.time_of(11), 5.0);
    EXPECT_EQ(sea.time_of(36), 6.0);
    EXPECT_EQ(sea.time_of(1), 4.6);
    EXPECT_EQ(sea.time_of(11.5), 5.02);
}

}  // namespace
}  // namespace ocean::test
