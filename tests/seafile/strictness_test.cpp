// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The sea-file reader is strict: each kind of mistake ends in an error that names the file, the
// line, the key, the value and the allowed values.

#include "helpers.hpp"

namespace ocean::test {
namespace {

TEST(SeaFile, WithoutVersionIsRefused) {
    expect_bad_file(refusal_of([] { parse_sea("[grid]\n", "test.toml", ""); }),
                    "test.toml: ", "libocean = 1");
}

TEST(SeaFile, OfAnotherVersionIsRefused) {
    for (const char* version : {"2", "0", "1.0", "\"1\""}) {
        const std::string line = "libocean = " + std::string(version);
        expect_bad_file(refusal_of([&] { parse_sea("\n" + line, "test.toml", ""); }),
                        "test.toml:2: " + line, "allowed: libocean = 1");
    }
}

TEST(SeaFile, ThatIsMissingIsABadFileWithItsPath) {
    expect_bad_file(refusal_of([] { read_sea(kData + "/no_such_sea.toml"); }),
                    kData + "/no_such_sea.toml: no such file");
}

TEST(SeaFile, TheFirstMistakeInTheFileIsReportedFirst) {
    EXPECT_TRUE(refusal_of_sea("[water]\ndepth = -1\n[grid]\nresolution = 3\n")
                    .says("test.toml:3: water.depth"));
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
    EXPECT_TRUE(refusal_of_sea(body + "[[waves]]\n").says("test.toml:18: waves: 17"));
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
        EXPECT_TRUE(
            says(message_of([&] { parse_sea(bytes.substr(0, bytes.size() - 1), "test.toml", ""); }),
                 "UTF-16"));
        std::string half = bytes;
        half.erase(bytes.find(little ? "\x1e\xdd" : "\xdd\x1e"), 2);
        const Refusal halved = refusal_of([&] { parse_sea(half, "test.toml", ""); });
        EXPECT_TRUE(halved.says("test.toml:1", "half a character"));
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
