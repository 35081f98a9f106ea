// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any model with a table is set, read, found and listed as a sea is: names and lists are the
// table's, types and rules its columns.
#include "ocean/table.hpp"

#include "ocean/parameter_table.hpp"
#include "refusal.hpp"
#include "toy_model.hpp"

namespace ocean::test {
namespace {

Kiln kiln_with_trays(std::size_t count) {
    Kiln kiln;
    kiln.trays.resize(count);
    return kiln;
}

void set(Kiln& kiln, std::string_view name, std::string_view text) {
    const RefOf<Kiln> ref = find_parameter(kKilnTable, name);
    assign(kiln, ref, parse_value(*ref.info, ref.item, text));
}

std::string get(const Kiln& kiln, std::string_view name) {
    return to_text(value_of(kiln, find_parameter(kKilnTable, name)));
}

std::string refusal(std::string_view name, std::string_view text) {
    Kiln kiln = kiln_with_trays(2);
    return message_of([&] { set(kiln, name, text); });
}

TEST(Table, EveryTypeOfAnyModelIsSetAndReadByName) {
    Kiln kiln = kiln_with_trays(2);
    for (const auto& [name, text] :
         std::vector<std::pair<std::string, std::string>>{{"kiln.heat", "1234.5"},
                                                          {"bricks", "512"},
                                                          {"vented", "true"},
                                                          {"kiln.tray.1.bowls", "12"},
                                                          {"glaze", "matt"},
                                                          {"kiln.lid.lid_angle", "30"}}) {
        EXPECT_NE(get(kiln, name), text);
        set(kiln, name, text);
        EXPECT_EQ(get(kiln, name), text);
    }
    EXPECT_TRUE(kiln.vented);
    EXPECT_EQ(kiln.trays[1].bowls, 12);
    EXPECT_EQ(kiln.trays[0].glaze, Glaze::matt) << "a bare key is of the first item";
    EXPECT_EQ(kiln.lid_angle, 30.0);
}

TEST(Table, RefusalsSayWhatTheColumnsAllow) {
    EXPECT_EQ(refusal("heat", "200"), "kiln.heat = 200: is out of range; allowed: 300 .. 1600 K");
    EXPECT_EQ(refusal("bricks", "300"),
              "kiln.bricks = 300: is not a power of two; allowed: a power of two, 16 .. 4096");
    EXPECT_EQ(refusal("kiln.tray.1.bowls", "3"),
              "kiln.tray.1.bowls = 3: is not even; allowed: an even number, 0 .. 64");
    EXPECT_EQ(refusal("kiln.tray.2.bowls", "2"),
              "kiln.tray.2.bowls: only 2 trays exist, numbered from 0");
    for (const char* text : {"1", "yes", "True", ""}) {
        EXPECT_EQ(refusal("vented", text), "kiln.vented = \"" + std::string(text) +
                                               "\": is neither true nor false; allowed: true or "
                                               "false");
    }
}

TEST(Table, ABooleanIsNoNumberAndNoNumberIsABoolean) {
    Kiln kiln;
    const RefOf<Kiln> vented = find_parameter(kKilnTable, "vented");
    EXPECT_THROW(assign(kiln, vented, std::int64_t{1}), Error);
    EXPECT_THROW(assign(kiln, vented, std::string("true")), Error);
    EXPECT_THROW(assign(kiln, find_parameter(kKilnTable, "heat"), true), Error);
    assign(kiln, vented, true);
    EXPECT_EQ(value_of(kiln, vented), ParameterValue(true));
}

TEST(Table, NamesAreOfTheWholeSection) {
    for (const char* name : {"tray.0.bowls", "kiln.bowls", "kiln.tray.bowls", "kiln.tray.x.bowls",
                             "kiln.lid_angle", "kiln.tray.0.heat", "waves.0.heat", "heats"}) {
        EXPECT_THROW(find_parameter(kKilnTable, name), Error) << name;
    }
    EXPECT_EQ(message_of([] { find_parameter(kKilnTable, "kiln.tray.1.bowl"); }),
              "unknown parameter 'kiln.tray.1.bowl'; did you mean kiln.tray.0.bowls?");
}

TEST(Table, ARowKnowsItsMember) {
    EXPECT_TRUE(find_parameter(kKilnTable, "bowls").info->holds<&Tray::bowls>());
    EXPECT_FALSE(find_parameter(kKilnTable, "bowls").info->holds<&Tray::glaze>());
    EXPECT_FALSE(find_parameter(kKilnTable, "heat").info->holds<&Kiln::lid_angle>());
}

TEST(Table, IsListedAsMarkdown) {
    EXPECT_EQ(
        parameters_markdown(listed(kKilnTable)),
        "| Parameter | Default | Allowed | Class | What it is |\n"
        "| --- | --- | --- | --- | --- |\n"
        "| `kiln.heat` | `1200` | 300 .. 1600 K | live | Temperature of the fire. |\n"
        "| `kiln.bricks` | `256` | a power of two, 16 .. 4096 | rebuild | Bricks of the wall. "
        "|\n"
        "| `kiln.vented` | `false` | true or false | live | Whether smoke leaves by a flue. "
        "|\n"
        "| `kiln.tray.N.bowls` | `4` | an even number, 0 .. 64 | rebuild | Bowls on the "
        "tray. |\n"
        "| `kiln.tray.N.glaze` | `glossy` | one of matt, glossy | rebuild | Glaze of the "
        "bowls. |\n"
        "| `kiln.lid.lid_angle` | `0` | 0 .. 90 deg | live | How far the lid stands open. "
        "|\n");
}

TEST(Table, IsListedAsJson) {
    const std::string json = parameters_json(listed(kKilnTable));
    for (const char* part :
         {R"({"section": "kiln", "key": "heat", "type": "float", "unit": "K", "label": "Heat", )"
          R"("help": "Temperature of the fire.", "class": "live", "allowed": "300 .. 1600 K", )"
          R"("min": 300, "max": 1600, "soft_min": 900, "soft_max": 1500, "default": 1200})",
          R"("type": "bool", "unit": "", "label": "Vented", "help": "Whether smoke leaves by a )"
          R"(flue.", "class": "live", "allowed": "true or false", "neutral": "false", )"
          R"("default": false})",
          R"({"section": "kiln.tray", "key": "glaze", "type": "enum")",
          R"("choices": ["matt", "glossy"], "default": "glossy"})"}) {
        EXPECT_TRUE(test::says(json, part));
    }
}

template <typename Model>
void expect_neutral_defaults(const Table<Model>& table) {
    for (const auto& [spec, default_value] : listed(table)) {
        EXPECT_EQ(spec->neutral.value_or(to_text(default_value)), to_text(default_value))
            << spec->path();
    }
}

/// A key that is left out reads back as the default: another neutral value would be lost.
TEST(Table, NeutralValuesAreDefaults) {
    expect_neutral_defaults(kKilnTable);
    expect_neutral_defaults(sea_table());
}

// A section that is a list for its rows and none for the table, a row behind another section, a key
// twice: each is found while the table is compiled.
constexpr TableRow<Kiln> kHeat = kKilnRows[0];
constexpr TableRow<Kiln> kLidAngle = kKilnRows[5];
constexpr TableRow<Kiln> kTwice[] = {kHeat, kHeat, kLidAngle};
constexpr TableRow<Kiln> kBackwards[] = {kLidAngle, kHeat};
constexpr TableRow<Kiln> kNoList[] = {{kLid, "bowls", "", "", "",
                                       member<&Kiln::trays, &Tray::bowls>(), 0, 64, 0, 16,
                                       ParameterClass::rebuild, StagesOf<Kiln>::type::all}};
static_assert(!is_consistent(Table<Kiln>{"kiln", kKilnSections, kTwice}));
static_assert(!is_consistent(Table<Kiln>{"kiln", kKilnSections, kBackwards}));
static_assert(!is_consistent(Table<Kiln>{"kiln", kKilnSections, kNoList}));

}  // namespace
}  // namespace ocean::test
