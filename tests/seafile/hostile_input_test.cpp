// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Input that was made to hurt: each ends in one printable sentence, quickly, without a crash.

#include "helpers.hpp"

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
        EXPECT_TRUE(
            refusal_of_text("libocean = 1\n" + text).says("test.toml:", "more than 16 parts"));
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
        expect_bad_file(refusal_of_text("libocean = 1\n" + std::string(text)),
                        "test.toml:2: is not TOML");
    }
    for (const char* quote : {"'", "\"", "\"\"\"", "'''"}) {
        const std::string word = std::string(quote) + "M\xC3\xA9t\xC3\xA9o" + quote;
        const Sea sea = parse("# \xC3\xA9 '\n[[waves]]\nfile = " + word + "\n");
        EXPECT_EQ(sea.parameters.waves[0].file, "M\xC3\xA9t\xC3\xA9o");
    }
}

TEST(HostileSeaFile, DeepNestingIsRefused) {
    for (const char* open : {"[", "{a="}) {
        expect_bad_file(refusal_of_text("libocean = 1\nx = " + repeated(open, 100000)),
                        "test.toml:2: ");
    }
}

TEST(HostileSeaFile, HugeTextIsRefusedBeforeItIsParsed) {
    EXPECT_TRUE(refusal_of_text("libocean = 1\n" + std::string(5 << 20, '#')).says("4 MiB"));
}

TEST(HostileSeaFile, NulByteIsRefusedWithItsLine) {
    expect_bad_file(refusal_of_text(std::string("libocean = 1\n# \0\n", 17)),
                    "test.toml:2: ", "NUL");
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
    expect_bad_file(refusal_of([] { read_sea(kData); }), "directory");
    EXPECT_TRUE(
        refusal_of_sea("[[waves]]\nspectrum = \"measured\"\nfile = \".\"\n").says("directory"));
}

TEST(HostileSeaFile, LargeFileIsRefusedWhileReading) {
    const auto path = std::filesystem::path(testing::TempDir()) / "ocean_large_sea.toml";
    std::ofstream(path) << std::string(5 << 20, '\n');
    const Refusal refusal = refusal_of([&] { read_sea(path.string()); });
    std::filesystem::remove(path);
    EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
    EXPECT_TRUE(refusal.says("4 MiB"));
}

TEST(HostileSpectrum, WhatIsNoSpectrumIsRefusedWithTheKnownFormats) {
    for (const std::string& content :
         {std::string("hello"), std::string(1000, '\0'), std::string("\x89PNG\r\n\x1A\n"),
          std::string("#YY MM DD hh mm WDIR WSPD\n2020 06 08 03 50 120 5\n"), std::string("\n\n"),
          std::string("libocean = 1\n")}) {
        expect_bad_file(refusal_of_spectrum(content), "b.data_spec: ", "NDBC real-time");
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

/// `head`, then a row for each number from 1 to `count`.
template <typename Row>
std::string rows(const std::string& head, int count, Row row) {
    std::string text = head;
    for (int i = 1; i <= count; ++i) text += row(std::to_string(i));
    return text;
}

TEST(HostileSpectrum, ManyFrequenciesDirectionsAndRecordsAreRefusedInEachFormat) {
    const auto says = [](const std::string& content, const std::string& words) {
        EXPECT_TRUE(refusal_of_spectrum(content).says("b.data_spec" + words));
    };
    const auto pair = [](const std::string& i) {
        return " ." + std::string(5 - i.size(), '0') + i;
    };
    says(rows("#YY MM DD hh mm", 4097, pair) + "\n", ":1: more than 4096 frequencies");
    says("#YY MM DD hh mm .1 .2\n" + repeated("2019 01 02 03 40 1 2\n", 100001),
         ":100002: more than 100000 records");
    const auto csv = [](const std::string& i) { return i + "e-3,1\n"; };
    says(rows("frequency,density\n", 4097, csv), ":4098: more rows");
    const auto at = [](const char* f) {
        return [f](const std::string& d) { return f + d + "e-1,1\n"; };
    };
    const std::string one = rows("frequency,direction,density\n", 721, at(".1,"));
    says(rows(one, 721, at(".2,")),
         ":1443: in the record that ends here: a spectrum has at most 720 directions");
    const std::string head = "10\n85\n4.5\n0.5\n25\n19\n7\n-.1\n.3\n.2\n213.8\n68.2\n";
    const auto share = [](const std::string& i) { return i + "e-3,0.5,300.9,58.8,1.49,2.34\n"; };
    says(rows(head, 4097, share), ":4109: more than 4096 frequencies");
    const auto number = [](const std::string& i) { return i + "e-2\n"; };
    const std::string swan = rows("SWAN 1\nLONLAT\n1\n0 0\nAFREQ\n400\n", 400, number);
    says(swan + "NDIR\n720\n", ":408: a spectrum has at most 131072 values");
}

TEST(HostileSpectrum, ShortWordsForHugeSpectraAreRefused) {
    const auto number = [](const std::string& i) { return i + "e-2\n"; };
    std::string file = "SWAN 1\nLONLAT\n2000\n" + repeated("0 0\n", 2000);
    const auto angle = [](const std::string& i) { return i + "e-1\n"; };
    file = rows(rows(file + "AFREQ\n180\n", 180, number) + "CDIR\n720\n", 720, angle);
    file += "QUANT\n1\nVaDens\nm2/Hz/degr\n-99\n" + repeated("ZERO\n", 2000);
    EXPECT_TRUE(refusal_of_spectrum(file).says("more than 67108864 values over all records"));
}

TEST(HostileSpectrum, NestingAndListsOfJsonAreRefusedAtOnce) {
    const std::string key = "{\"spotterId\": ";
    EXPECT_TRUE(refusal_of_spectrum(key + repeated("[", 1000000))
                    .says("b.data_spec:1: is nested more than 64 deep"));
    EXPECT_TRUE(
        refusal_of_spectrum(repeated("{\"spotterId\":", 1000000)).says("more than 64 deep"));
    const std::string many =
        "{\"frequencyData\": [{\"frequency\": [" + repeated("1,", 5000) + "1]}]}";
    EXPECT_TRUE(refusal_of_spectrum(many).says(":1: more than 4096 frequencies"));
    const Refusal garbage =
        refusal_of_spectrum("{\"spotterId\": \x1B[31m\xFF" + std::string(9000, 'x'));
    EXPECT_LT(garbage.message.size(), 200u);
    expect_one_printable_line(garbage);
}

TEST(HostileSpectrum, GarbageInALineIsNotRepeated) {
    const std::string header = "#YY MM DD hh mm Sep_Freq < spec_1 (freq_1) ... >\n";
    const Refusal refusal =
        refusal_of_spectrum(header + "2020\x1B[31m\xFF" + std::string(9000, 'x'));
    EXPECT_TRUE(refusal.says("b.data_spec:2: "));
    expect_one_printable_line(refusal);
}

TEST(HostileSpectrum, NetcdfIsRefusedWithTheWayOut) {
    for (const std::string& magic : {std::string("CDF\x01"), std::string("\x89HDF\r\n\x1a\n")}) {
        const Refusal refusal = refusal_of([&] {
            read_spectra_from({magic + "rest", "era5.nc", {}});
        });
        EXPECT_TRUE(refusal.says("era5.nc: is NetCDF", "--sea-file"));
    }
}

}  // namespace
}  // namespace ocean::test
