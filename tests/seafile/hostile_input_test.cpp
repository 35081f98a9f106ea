// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Input that was made to hurt: each ends in one printable sentence, quickly, without a crash.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "helpers.hpp"
#include "spectrum_format.hpp"

namespace ocean::test {
namespace {

Refusal refusal_of_text(const std::string& text) {
    return refusal_of([&] { parse_sea(text, "test.toml", ""); });
}
Refusal refusal_of_spectrum(const std::string& content) {
    return refusal_of([&] { read_spectra_from({content, "b.data_spec", nullptr}); });
}
std::string repeated(const std::string& text, int times) {
    std::string out;
    for (int i = 0; i < times; ++i) out += text;
    return out;
}

void expect_one_printable_line(const Refusal& refusal) {
    EXPECT_LT(refusal.message.size(), 2000u);
    for (char c : refusal.message)
        EXPECT_GE(static_cast<unsigned char>(c), 0x20) << refusal.message;
}

TEST(HostileSeaFile, KeyOfAMillionPartsDoesNotOverflowTheStack) {
    const std::string dots = repeated("a.", 1000000) + "a";
    for (const std::string& text :
         {dots + " = 1", "[" + dots + "]\n", "x = { " + dots + " = 1 }", "\"#\"." + dots + " = 1",
          "x = [\"\"\"q\"\"\"\", { " + dots + " = 1 }]", "'''it's''' = 1\n" + dots + " = 1",
          "\"\\\"\"." + dots + " = 1"}) {
        const Refusal refusal = refusal_of_text("libocean = 1\n" + text);
        EXPECT_TRUE(refusal.says("test.toml:") && refusal.says("more than 16 parts"))
            << refusal.message;
    }
}

TEST(HostileSeaFile, DotsInTextsAndCommentsAndNumbersAreNoKeys) {
    const std::string dots(100, '.');
    const Sea sea = parse("# " + dots + "\n[[waves]]\nfile = \"" + dots +
                          "\" # \"\n[waves.measured_record]\n" + "frequency = [" +
                          repeated("0.1,\n", 0) + "0.1, 0.2]\ndensity = [\n1.0\n," + "\n2.0]\n");
    EXPECT_EQ(sea.parameters.waves[0].file, dots);
}

TEST(HostileSeaFile, CharactersBeyondAsciiAreForCommentsAndTexts) {
    // From U+00A1 to U+0499 the parser's own test for blanks had no answer: see toml_input.hpp.
    for (const char* text : {"caf\xC3\xA9 = 1", "x = \"a\" \xC3\xA9", "x = \xC3\xA9",
                             "x = 0X0Ape'pe'''on'\xCE\x88i'", "\xCE\x88 = 1", "x\xD2\x99 = 1"}) {
        const Refusal refusal = refusal_of_text("libocean = 1\n" + std::string(text));
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
        EXPECT_TRUE(refusal.says("test.toml:2: is not TOML")) << refusal.message;
    }
    for (const char* quote : {"'", "\"", "\"\"\"", "'''"}) {
        const std::string word = std::string(quote) + "M\xC3\xA9t\xC3\xA9o" + quote;
        const Sea sea = parse("# \xC3\xA9 '\n[[waves]]\nfile = " + word + "\n");
        EXPECT_EQ(sea.parameters.waves[0].file, "M\xC3\xA9t\xC3\xA9o");
    }
}

TEST(HostileSeaFile, DeepNestingIsRefused) {
    for (const char* open : {"[", "{a="}) {
        const Refusal refusal = refusal_of_text("libocean = 1\nx = " + repeated(open, 100000));
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
        EXPECT_TRUE(refusal.says("test.toml:2: ")) << refusal.message;
    }
}

TEST(HostileSeaFile, HugeTextIsRefusedBeforeItIsParsed) {
    const Refusal refusal = refusal_of_text("libocean = 1\n" + std::string(5 << 20, '#'));
    EXPECT_TRUE(refusal.says("4 MiB")) << refusal.message;
}

TEST(HostileSeaFile, NulByteIsRefusedWithItsLine) {
    const Refusal refusal = refusal_of_text(std::string("libocean = 1\n# \0\n", 17));
    EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
    EXPECT_TRUE(refusal.says("test.toml:2: ") && refusal.says("NUL")) << refusal.message;
}

TEST(HostileSeaFile, InvalidUtf8IsRefusedAndNotRepeated) {
    for (const char* text :
         {"libocean = 1\n# caf\xE9\n", "libocean = 1\n[[waves]]\nfile = \"\xC0\xAF\"",
          "libocean = 1\n\xFF\xFE = 3", "\xED\xA0\x80"}) {
        const Refusal refusal = refusal_of_text(text);
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
        expect_one_printable_line(refusal);
    }
}

TEST(HostileSeaFile, LongAndControlCharactersAreNotRepeated) {
    const std::string terminal_escape = "\\u001b[31m";
    for (const std::string& value :
         {"\"" + std::string(100000, 'x') + "\"", "\"" + repeated(terminal_escape, 5000) + "\""}) {
        for (const char* key : {"spectrum", "spreading", "file", "unknown", "wind_speed"}) {
            const Refusal refusal =
                refusal_of_sea("[[waves]]\n" + std::string(key) + " = " + value);
            ASSERT_TRUE(refusal.refused) << key;
            expect_one_printable_line(refusal);
        }
    }
    expect_one_printable_line(refusal_of_sea("\"\\u001b" + std::string(100000, 'k') + "\" = 1"));
}

TEST(HostileSeaFile, AbsurdArraysAreRefused) {
    const std::string many = "[" + repeated("1,", 100000) + "]";
    EXPECT_TRUE(refusal_of_sea("[grid]\ncascade_divisors = " + many).says("test.toml:3: "));
    EXPECT_TRUE(refusal_of_sea("[[waves]]\n[waves.measured_record]\nfrequency = " + many)
                    .says("at most 4096"));
    EXPECT_TRUE(
        refusal_of_sea("waves = [" + repeated("{},", 100000) + "]").says("allowed: 1 .. 16"));
}

TEST(HostileSeaFile, DirectoryAsPathIsABadFile) {
    const Refusal refusal = refusal_of([] { read_sea(kData); });
    EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
    EXPECT_TRUE(refusal.says("directory")) << refusal.message;
    EXPECT_TRUE(
        refusal_of_sea("[[waves]]\nspectrum = \"measured\"\nfile = \".\"\n").says("directory"));
}

TEST(HostileSeaFile, LargeFileIsRefusedWhileReading) {
    const auto path = std::filesystem::path(testing::TempDir()) / "ocean_large_sea.toml";
    std::ofstream(path) << std::string(5 << 20, '\n');
    const Refusal refusal = refusal_of([&] { read_sea(path.string()); });
    std::filesystem::remove(path);
    EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
    EXPECT_TRUE(refusal.says("4 MiB")) << refusal.message;
}

TEST(HostileSpectrum, WhatIsNoSpectrumIsRefusedWithTheKnownFormats) {
    for (const std::string& content :
         {std::string("hello"), std::string(1000, '\0'), std::string("\x89PNG\r\n\x1A\n"),
          std::string("#YY MM DD hh mm WDIR WSPD\n2020 06 08 03 50 120 5\n"), std::string("\n\n"),
          std::string("libocean = 1\n")}) {
        const Refusal refusal = refusal_of_spectrum(content);
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
        EXPECT_TRUE(refusal.says("b.data_spec: ") && refusal.says("NDBC real-time"))
            << refusal.message;
    }
    EXPECT_TRUE(refusal_of_spectrum("").says("b.data_spec: the file is empty"));
}

TEST(HostileSpectrum, HeaderAloneHoldsNoSpectrum) {
    EXPECT_TRUE(refusal_of_spectrum("#YY MM DD hh mm Sep_Freq < spec_1\n").says("no spectrum"));
}

TEST(HostileSpectrum, AbsurdNumbersOfColumnsAndRowsAreRefused) {
    const std::string header = "#YY MM DD hh mm Sep_Freq < spec_1 (freq_1) ... >\n";
    std::string columns = header + "2020 06 08 03 50 0.2";
    for (int i = 1; i <= 5000; ++i) columns += " 1 (" + std::to_string(i * 1e-3) + ")";
    EXPECT_TRUE(refusal_of_spectrum(columns).says("b.data_spec:2: more than 4096 frequencies"));
    const std::string rows = repeated("2020 06 08 03 50 0.2 1 (0.1) 1 (0.2)\n", 100001);
    EXPECT_TRUE(refusal_of_spectrum(header + rows).says(":100002: more than 100000 records"));
}

TEST(HostileSpectrum, GarbageInALineIsNotRepeated) {
    const std::string header = "#YY MM DD hh mm Sep_Freq < spec_1 (freq_1) ... >\n";
    const Refusal refusal =
        refusal_of_spectrum(header + "2020\x1B[31m\xFF" + std::string(9000, 'x'));
    EXPECT_TRUE(refusal.says("b.data_spec:2: ")) << refusal.message;
    expect_one_printable_line(refusal);
}

TEST(HostileSpectrum, NetcdfIsRefusedWithTheWayOut) {
    for (const std::string& magic : {std::string("CDF\x01"), std::string("\x89HDF\r\n\x1a\n")}) {
        const Refusal refusal = refusal_of([&] {
            read_spectra_from({magic + "rest", "era5.nc", {}});
        });
        EXPECT_TRUE(refusal.says("era5.nc: is NetCDF") && refusal.says("--sea-file"))
            << refusal.message;
    }
}

}  // namespace
}  // namespace ocean::test
