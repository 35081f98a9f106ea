// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The table of values: every parameter under every name that it has, the last writer named, nothing
// refused changed, and no file named from outside.
#include "ocean/internal/bridge/value_table.hpp"

#include <bit>

#include "ocean/internal/text.hpp"
#include "refusal.hpp"
#include "toy_model.hpp"

namespace ocean::bridge {
namespace {

ErrorKind refusal_of(ValueTable& table, const std::string& name, const std::string& value) {
    const std::uint64_t before = table.revision();
    try {
        table.set(table.find(name), value, "test");
    } catch (const Error& error) {
        EXPECT_EQ(table.revision(), before);
        return error.kind();
    }
    ADD_FAILURE() << name << " = " << value << " was taken";
    return ErrorKind::output;
}

TEST(ValueTable, APathAndABareKeyAreOneValue) {
    Parameters parameters;
    parameters.waves.resize(2);
    const ValueTable table(parameters);
    EXPECT_EQ(table.find("wind_speed"), table.find("waves.0.wind_speed"));
    EXPECT_NE(table.find("wind_speed"), table.find("waves.1.wind_speed"));
    EXPECT_EQ(table[table.find("resolution")].text, "512");
    EXPECT_EQ(table[table.find("wind_speed")].text, kUnset);
    EXPECT_EQ(table.number(table.find("wind_speed")), kDefaultWind);
    for (const ValueEntry& entry : table.entries()) {
        EXPECT_EQ(table[table.find(entry.name)].name, entry.name);
    }
}

TEST(ValueTable, UnknownNamesSayWhatIsNear) {
    const ValueTable table;
    for (const auto& [name, near] :
         std::vector<std::pair<std::string, std::string>>{{"wind_sped", "wind_speed"},
                                                          {"app.paus", "app.pause"},
                                                          {"waves.1.fetch", "waves.0"}}) {
        ocean::test::expect_refusal(ErrorKind::not_found, near,
                                    [&table, &name = name] { table.find(name); });
    }
}

TEST(ValueTable, TheLastWriterWinsAndIsNamed) {
    ValueTable table;
    const std::size_t wind = table.find("wind_speed");
    EXPECT_TRUE(table.set(wind, "12", "board0/a1"));
    EXPECT_EQ(table[wind].writer, "board0/a1");
    const std::uint64_t changed = table[wind].changed;
    EXPECT_FALSE(table.set(wind, "12.0", "127.0.0.1:5"));
    EXPECT_EQ(table[wind].writer, "127.0.0.1:5");
    EXPECT_EQ(table[wind].changed, changed);
    EXPECT_GT(table[wind].taken, changed);
    EXPECT_EQ(table[wind].text, "12");
    EXPECT_EQ(table.parameters().waves[0].wind_speed, 12.0);
    EXPECT_TRUE(table.set(wind, "unset", "x"));
    EXPECT_FALSE(table.parameters().waves[0].wind_speed);
}

TEST(ValueTable, WhatIsRefusedChangesNothing) {
    ValueTable table;
    for (const char* value : {"-1", "76", "nan", "inf", "1e309", "12x", ""}) {
        if (std::string(value).empty()) continue;  // a line has a value
        EXPECT_EQ(refusal_of(table, "wind_speed", value), ErrorKind::invalid_value) << value;
    }
    for (const char* value : {"2", "-1", "0.5", "nan", "yes"}) {
        EXPECT_EQ(refusal_of(table, "app.pause", value), ErrorKind::invalid_value) << value;
    }
    for (const char* value : {"61", "1e9", "nan", "-1"}) {
        EXPECT_EQ(refusal_of(table, "app.hull.speed", value), ErrorKind::invalid_value) << value;
    }
    EXPECT_EQ(refusal_of(table, "app.hull.heading", "361"), ErrorKind::invalid_value);
    ocean::test::expect_refusal(ErrorKind::invalid_value, "app.hull.drive = 17: allowed: 0 .. 16",
                                [&] { table.set(table.find("app.hull.drive"), "17", "test"); });
    EXPECT_EQ(refusal_of(table, "spectrum", "measured"), ErrorKind::invalid_value);  // of no record
    EXPECT_EQ(refusal_of(table, "file", "/etc/passwd"), ErrorKind::unsupported);
    EXPECT_EQ(refusal_of(table, "time.take", "x.take"), ErrorKind::unsupported);
}

/// Returns the outcome of a set(): the error, or the text, the number's bits and the parameters'
/// bits.
template <typename Value>
std::string outcome_of(ValueTable table, std::size_t entry, const Value& value) {
    try {
        table.set(entry, value, "board0/a1");
    } catch (const Error& error) {
        return error.what();
    }
    const double number = table.number(entry);
    const ParameterRef ref = table.ref(entry);
    const std::string stored =
        ref.info == nullptr ? "" : to_text(value_of(table.parameters(), ref));
    return table[entry].text + " " + std::to_string(std::bit_cast<std::uint64_t>(number)) + " " +
           stored + " " + std::to_string(table.revision());
}

TEST(ValueTable, ANumberIsStoredAsItsTextIs) {
    const ValueTable table;
    std::vector<double> numbers = {0.0,  -0.0,  1.0,    0.5, 1e-6,     1e15,     15.0588, 1.0 / 3.0,
                                   0.1,  1e300, 1e-310, 512, 513,      4e9,      -1.0,    75.0,
                                   30.0, 100.0, 0.01,   NAN, INFINITY, -INFINITY};
    std::mt19937_64 random(40);
    for (int i = 0; i < 200; ++i) {
        numbers.push_back(std::bit_cast<double>(random()));
        numbers.push_back(std::ldexp(static_cast<double>(random()), -60));
        numbers.push_back(static_cast<double>(random() % 10000));
    }
    for (std::size_t entry = 0; entry < table.entries().size(); ++entry) {
        if (!table.is_number(entry)) continue;
        for (const double number : numbers) {
            ASSERT_EQ(outcome_of(table, entry, number),
                      outcome_of(table, entry, plain_text(number)))
                << table[entry].name << " = " << plain_text(number);
        }
    }
}

/// number() has the bits that the text of the entry spells.
TEST(ValueTable, TheNumberIsThatOfTheText) {
    ValueTable table;
    for (std::size_t entry = 0; entry < table.entries().size(); ++entry) {
        if (!table.is_number(entry)) continue;
        for (const double value : {1.0, 1.0 / 3.0, 0.1, 64.0}) {
            try {
                table.set(entry, value, "board0/a1");
            } catch (const Error&) {
                continue;
            }
            EXPECT_EQ(table.number(entry), std::stod(table[entry].text)) << table[entry].name;
        }
    }
}

/// Each type of a table, a boolean too, comes back from the line as it went.
TEST(ValueTable, WhatVALSpellsSETReads) {
    ocean::test::Kiln kiln;
    kiln.vented = true;
    kiln.trays.resize(1);
    for (const auto& row : ocean::test::kKilnRows) {
        const ParameterValue value = value_of(kiln, {&row, 0});
        const std::string text = wire_text(row, value);
        ocean::test::Kiln other;
        other.trays.resize(1);
        assign(other, {&row, 0}, parse_value(row, 0, text));
        EXPECT_EQ(value_of(other, {&row, 0}), value) << row.path() << " = " << text;
    }
    EXPECT_EQ(wire_text(*find_parameter(ocean::test::kKilnTable, "vented").info, true), "true");
    EXPECT_EQ(wire_text(*find_parameter("peak_period").info, std::string()), kUnset);
    EXPECT_EQ(wire_text(*find_parameter("file").info, std::string()), "");
}

}  // namespace
}  // namespace ocean::bridge
