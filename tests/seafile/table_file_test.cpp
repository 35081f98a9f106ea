// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A model that is no sea is read from its files as strictly as a sea, with the file's lines, and
// written so that it reads back. A key that came later changes no text of a model without it.

#include "helpers.hpp"
#include "table_reader.hpp"
#include "table_writer.hpp"
#include "toy_model.hpp"

namespace ocean::test {
namespace {

/// The body begins on line 2 of "kiln.toml".
Kiln read_kiln(const std::string& body) {
    const toml::table root = parse_toml("libocean = 1\n" + body, "kiln.toml");
    return TableReader<Kiln>(kKilnTable, "kiln.toml").read(root);
}

ErrorFields table_fields_of(const std::string& body) {
    return refusal_of([&] { read_kiln(body); }).fields;
}

TEST(TableFile, HoldsSectionsListsAndSectionsInside) {
    const Kiln kiln = read_kiln(
        "[kiln]\nheat = 1300\nbricks = 64\nvented = true\n[kiln.lid]\nlid_angle = 10.5\n"
        "[[kiln.tray]]\nbowls = 8\n[[kiln.tray]]\nglaze = \"matt\"\n");
    EXPECT_EQ(kiln.heat, 1300.0);
    EXPECT_EQ(kiln.bricks, 64);
    EXPECT_TRUE(kiln.vented);
    EXPECT_EQ(kiln.lid_angle, 10.5);
    ASSERT_EQ(kiln.trays.size(), 2u);
    EXPECT_EQ(kiln.trays[0].bowls, 8);
    EXPECT_EQ(kiln.trays[1].bowls, 4);
    EXPECT_EQ(kiln.trays[1].glaze, Glaze::matt);
}

TEST(TableFile, EachMistakeIsRefusedWithItsLine) {
    const std::vector<std::pair<std::string, std::string>> mistakes = {
        {"[kiln]\n\nheet = 900\n",
         "kiln.toml:4: kiln.heet = 900: unknown parameter 'kiln.heet'; did you mean kiln.heat?"},
        {"[[kiln.tray]]\n[[kiln.tray]]\nbowl = 2\n",
         "kiln.toml:4: kiln.tray.1.bowl = 2: unknown parameter 'kiln.tray.1.bowl'; did you mean "
         "kiln.tray.0.bowls?"},
        {"[kiln]\nheat = \"hot\"\n",
         "kiln.toml:3: kiln.heat = \"hot\": is not a number; allowed: 300 .. 1600 K"},
        {"[kiln]\nvented = 1\n",
         "kiln.toml:3: kiln.vented = 1: is neither true nor false; allowed: true or false"},
        {"[kiln]\nheat = true\n",
         "kiln.toml:3: kiln.heat = true: is not a number; allowed: 300 .. 1600 K"},
        {"[kiln]\nvented = true\nheat = 200\n",
         "kiln.toml:4: kiln.heat = 200: is out of range; allowed: 300 .. 1600 K"},
        {"[kiln]\nbricks = 100\n",
         "kiln.toml:3: kiln.bricks = 100: is not a power of two; allowed: a power of two, 16 .. "
         "4096"},
        {"heat = 900\n",
         "kiln.toml:2: heat = 900: is outside its section; allowed: below "
         "[kiln]"},
        {"bowls = 2\n",
         "kiln.toml:2: bowls = 2: is outside its section; allowed: below [[kiln.tray]]"},
        {"[kiln.tray]\n",
         "kiln.toml:2: kiln.tray = a table: is not a list of trays; allowed: [[kiln.tray]], in "
         "double brackets, once for each tray"},
        {"[[kiln.tray]]\n[[kiln.tray]]\n[[kiln.tray]]\n[[kiln.tray]]\n",
         "kiln.toml:5: kiln.tray: 4 trays; allowed: 1 .. 3"},
        {"[[kiln.lid]]\n",
         "kiln.toml:2: kiln.lid = an array of 1: is a section; allowed: one [kiln.lid] with keys"},
        {"[kilm]\n", "kiln.toml:2: kilm: no such section; did you mean kiln?; allowed: kiln"},
        {"[kiln]\n[grid]\n", "kiln.toml:3: is a sea file, not a kiln file"},
        {"[[waves]]\n", "kiln.toml:2: is a sea file, not a kiln file"},
        {"[take]\n", "kiln.toml:2: is a sea file, not a kiln file"},
        {"[terrain]\n", "kiln.toml:2: is a terrain file, not a kiln file"},
        {"terrain = 3\n", "kiln.toml:2: terrain: no such section; allowed: kiln"}};
    for (const auto& [body, message] : mistakes) {
        EXPECT_EQ(refusal_of([&, text = body] { read_kiln(text); }).message, message) << body;
    }
}

TEST(TableFile, WithoutItsFirstLineIsNoFileOfThatKind) {
    const auto read = [] {
        TableReader<Kiln>(kKilnTable, "kiln.toml").read(parse_toml("[kiln]\n", "kiln.toml"));
    };
    EXPECT_EQ(refusal_of(read).message,
              "kiln.toml: is not a kiln file: the line 'libocean = 1' is missing");
}

TEST(TableFile, MistakesHaveTheirPartsAsFields) {
    const ErrorFields type = table_fields_of("[kiln]\nvented = 1\n");
    EXPECT_EQ(type.parameter, "kiln.vented");
    EXPECT_EQ(type.value, "1");
    EXPECT_EQ(type.what, "is neither true nor false");
    EXPECT_EQ(type.allowed, "true or false");
    const ErrorFields range = table_fields_of("[[kiln.tray]]\nbowls = 65\n");
    EXPECT_EQ(range.parameter, "kiln.tray.0.bowls");
    EXPECT_EQ(range.allowed, "an even number, 0 .. 64");
    EXPECT_EQ(table_fields_of("[kiln]\nheet = 1\n").parameter, "kiln.heet");
}

TEST(TableFile, IsWrittenSoThatItReadsBack) {
    Kiln kiln;
    kiln.heat = 1.0 / 3.0 + 900.0;
    kiln.vented = true;
    kiln.trays.resize(2);
    kiln.trays[1].glaze = Glaze::matt;
    const std::string text = table_text(kKilnTable, kiln);
    EXPECT_EQ(text,
              "libocean = 1\n\n[kiln]\nheat = 900.3333333333334\nbricks = 256\nvented = true\n\n"
              "[[kiln.tray]]\nbowls = 4\nglaze = \"glossy\"\n\n"
              "[[kiln.tray]]\nbowls = 4\nglaze = \"matt\"\n\n"
              "[kiln.lid]\nlid_angle = 0.0\n");
    const Kiln again = read_kiln(text.substr(text.find('\n') + 1));
    EXPECT_EQ(table_text(kKilnTable, again), text);
    EXPECT_TRUE(again.vented);
    EXPECT_EQ(again.heat, kiln.heat);
}

TEST(TableFile, AKeyThatCameLaterIsLeftOutAtItsNeutralValue) {
    Kiln kiln;
    const std::string before = table_text(kKilnTable, kiln);
    EXPECT_FALSE(test::says(before, "vented"));
    EXPECT_TRUE(test::says(before, "lid_angle = 0.0")) << "no default of another row";
    kiln.vented = true;
    EXPECT_TRUE(test::says(table_text(kKilnTable, kiln), "vented = true\n"));
}

TEST(SeaFile, OfATerrainSaysSo) {
    for (const char* body :
         {"[terrain]\nbeta = 2.0\n", "[[terrain.layer]]\nbeta = 2.0\n", "[terrain.coast]\n"}) {
        const Refusal refusal = refusal_of_sea(body);
        EXPECT_EQ(refusal.message, "test.toml:2: is a terrain file, not a sea file");
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
    }
    EXPECT_TRUE(
        refusal_of_sea("[water]\ndepth = 5\n[terrain]\n").says("test.toml:4: is a terrain"));
}

/// The fields that programs read beside the sentence pass through the file's readers.
TEST(SeaFile, MistakesKeepTheirFields) {
    const auto fields = [](const std::string& body) { return refusal_of_sea(body).fields; };
    EXPECT_EQ(fields("[water]\ndepth = 0.001\n").parameter, "water.depth");
    EXPECT_EQ(fields("[water]\ndepth = 0.001\n").allowed, "0.01 .. inf m");
    EXPECT_EQ(fields("[surface]\nlongest_wavelength = 1\nshortest_wavelength = 5\n").parameter,
              "surface.longest_wavelength");
    const ErrorFields file =
        fields("[[waves]]\nspectrum = \"measured\"\nfile = \"/waves.0.fetch = 5\"\n");
    EXPECT_EQ(file.parameter, "waves.0.file");
    EXPECT_EQ(file.value, "\"/waves.0.fetch = 5\"");
    EXPECT_EQ(file.what, "/waves.0.fetch = 5: no such file");
    EXPECT_EQ(fields("[[waves]]\nspectrum = \"measured\"\n").parameter, "waves.0.spectrum");
    EXPECT_EQ(fields("[time]\ntake = \"nowhere\"\n").parameter, "time.take");
    EXPECT_EQ(fields("[take]\nlines = [\"1 wind_speed 99\"]\n").parameter, "waves.0.wind_speed");
}

}  // namespace
}  // namespace ocean::test
