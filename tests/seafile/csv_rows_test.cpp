// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables as spreadsheets, pandas, R and loggers write them give the same numbers; where a table can
// be read in two ways, the error says which.
#include "ocean/internal/csv_rows.hpp"

#include "ocean/internal/text.hpp"
#include "refusal.hpp"

namespace ocean::csv {
namespace {

/// Returns the columns of numbers by their titles; -1 for a cell without a number.
std::string numbers_of(const std::string& content) {
    TableReader table(content, "t.csv");
    std::string text;
    for (const std::string_view title : table.titles()) text += "[" + std::string(title) + "]";
    while (table.next()) {
        text += '\n';
        for (std::size_t i = 0; i < table.titles().size(); ++i) {
            text += (i == 0 ? "" : " ") + shortest_text(table.number(i).value_or(-1.0));
        }
    }
    return text;
}

std::string sentence_of(const std::string& content) {
    std::string read;
    return test::message_of([&] { read = "read as " + numbers_of(content); }) + read;
}

std::string utf16(std::string_view ascii, bool big_endian) {
    std::string text;
    for (const char c : ascii) {
        if (big_endian) text += '\0';
        text += c;
        if (!big_endian) text += '\0';
    }
    return text;
}

struct Dialect {
    const char* name;
    std::string content;
};

class SameTable : public testing::TestWithParam<Dialect> {};

TEST_P(SameTable, GivesTheSameNumbers) {
    EXPECT_EQ(numbers_of(GetParam().content), "[x][y]\n1.5 -2.25\n10 2000");
}

const std::string kGerman = "x;y\r\n1,5;-2,25\r\n10;2e3\r\n";

INSTANTIATE_TEST_SUITE_P(
    Dialects, SameTable,
    testing::Values(Dialect{"Commas", "x,y\n1.5,-2.25\n10,2e3\n"},
                    Dialect{"CommasAndBlanks", " x , y\n1.5, -2.25\n\n# a comment\n 10,2e3"},
                    Dialect{"Semicolons", "x;y\n1.5;-2.25\n10;2e3\n"},
                    Dialect{"DecimalCommas", kGerman},
                    Dialect{"ExcelSaysItsSeparator", "sep=;\r\n" + kGerman},
                    Dialect{"AnySeparatorThatIsTold", "SEP=|\nx|y\n1.5|-2.25\n10|2e3\n"},
                    Dialect{"Tabs", "x\ty\n1.5\t-2.25\n10\t2e3\n"},
                    Dialect{"TabsAndDecimalCommas", "x\ty\n1,5\t-2,25\n10\t2000\n"},
                    Dialect{"QuotedDecimalCommas",
                            "\"x\",\"y\"\n\"1,5\",\"-2,25\"\n\"10\",\"2e3\"\n"},
                    Dialect{"Blanks", "x y\n1.5 -2.25\n10 2e3\n"},
                    Dialect{"AlignedByBlanks", "    x      y\n  1.5  -2.25\n 10   2e3  \n"},
                    Dialect{"AlignedByTabs", "x\t\ty\n1.5\t-2.25\n10\t\t2e3\n"},
                    Dialect{"BlanksAndDecimalCommas", "x y\n1,5 -2,25\n10 2e3\n"},
                    Dialect{"ByteOrderMark", "\xEF\xBB\xBF" + kGerman},
                    Dialect{"Utf16Little", "\xFF\xFE" + utf16(kGerman, false)},
                    Dialect{"Utf16Big", "\xFE\xFF" + utf16(kGerman, true)},
                    Dialect{"Utf16LittleWithoutMark", utf16(kGerman, false)},
                    Dialect{"Utf16BigWithoutMark", utf16(kGerman, true)},
                    Dialect{"OldMacintosh", "x;y\r1,5;-2,25\r10;2e3\r"},
                    Dialect{"Quotes", "\"x\";\"y\"\n\"1.5\";\"-2.25\"\n\"10\";\"2e3\"\n"}),
    [](const auto& instance) { return instance.param.name; });

TEST(TableReader, TitlesKeepTheirUnits) {
    EXPECT_EQ(numbers_of("x [m]  y (m2 s)\n1 2\n"), "[x [m]][y (m2 s)]\n1 2");
    EXPECT_EQ(numbers_of("x [m, east];y [m, north]\n1,5;2,5\n"),
              "[x [m, east]][y [m, north]]\n1.5 2.5");
    EXPECT_EQ(numbers_of("x (m,y\n1,2\n"), "[x (m][y]\n1 2");  // a bracket that nothing closes
    EXPECT_EQ(numbers_of("\"x, east\",y\n1,2\n"), "[x, east][y]\n1 2");
    const Title title = parse_title("Density [m2/Hz]");
    EXPECT_EQ(title.name + "|" + title.unit, "density|m2/Hz");
}

TEST(TableReader, RowNamesWithoutATitleAreAColumn) {
    EXPECT_EQ(numbers_of(",x,y\n0,1.5,2\n1,3,4\n"), "[][x][y]\n0 1.5 2\n1 3 4");  // pandas
    EXPECT_EQ(numbers_of("\"x\" \"y\"\n\"7\" 1.5 2\n"), "[][x][y]\n7 1.5 2");     // R
    EXPECT_EQ(numbers_of("   x  y\n0  1  2\n"), "[][x][y]\n0 1 2");  // a printed DataFrame
    EXPECT_EQ(sentence_of("x y\n0 1 2\n"),
              "t.csv:2: more cells than the 2 columns of the header line");
}

TEST(TableReader, TextsMayHoldWhatNumbersMayNot) {
    TableReader table("\xFF\xFE" + utf16("name\tx\n\"a\tb, \"\"c\"\"\"\t1,5\n", false), "t.csv");
    ASSERT_TRUE(table.next());
    EXPECT_EQ(table.cell(0), "a\tb, \"\"c\"\"");
    EXPECT_EQ(table.number(0), std::nullopt);
    EXPECT_EQ(table.number(1), 1.5);
    EXPECT_FALSE(table.next());
    // An e with an acute accent, a beaver beyond the first plane, half a surrogate pair.
    using namespace std::string_literals;
    EXPECT_EQ(converted("\xFF\xFE\xE9\0\x3E\xD8\xAB\xDD\x3E\xD8"s),
              "\xC3\xA9\xF0\x9F\xA6\xAB\xEF\xBF\xBD");
    EXPECT_EQ(converted("x,y\n1,2\n"), std::nullopt);
}

TEST(TableReader, WhatCanBeReadInTwoWaysIsRefused) {
    const auto says = [](const std::string& content, const std::string& message) {
        const std::string refusal = sentence_of(content);
        EXPECT_TRUE(test::says(refusal, message));
    };
    says("a,b;c,d\n1,2;3,4\n", "t.csv:1: the separator of the cells is ambiguous: a semicolon");
    says("x\ty\n1,500\t2,000\n",
         "t.csv:2: the comma of '1,500' is ambiguous: it may separate decim");
    says("x,y\n\"1,500\",\"12,000\"\n", "t.csv:2: the comma of '1,500' is ambiguous");
    says("x;y\n1,5;2,5\n1.5;2\n", "t.csv:3: the decimal mark is ambiguous: '1.5' has a point, the");
    says("x;y\n1.5;2\n1,5;2,5\n", "t.csv:3: the decimal mark is ambiguous: '1,5' has a comma, the");
    says("x;y\n1.234,5;2\n", "t.csv:2: '1.234,5' has a point and a comma");
    says("x,y\n1,5,2,5\n", "t.csv:2: more cells than the 2 columns of the header line; numbers wi");
    says("x;y\n1;2\n3", "t.csv:3: the file ends within this line");
    // Between semicolons, and where one comma cannot separate thousands, all are decimal.
    EXPECT_EQ(numbers_of("x;y\n1,500;2,000\n"), "[x][y]\n1.5 2");
    EXPECT_EQ(numbers_of("x\ty\n1,500\t0,250\n"), "[x][y]\n1.5 0.25");
    EXPECT_EQ(numbers_of("x\ty\n1,500\t1500,250\n"), "[x][y]\n1.5 1500.25");
}

TEST(TableReader, AnyHeaderLineIsReadInOnePass) {
    // Quadratic time would be hours.
    for (const char* bytes : {"(", "[", "([", "x ", "( ", "\"\""}) {
        std::string header;
        while (header.size() < (std::size_t{8} << 20)) header += bytes;
        EXPECT_FALSE(sentence_of(header + "\n1\n").empty());
    }
}

TEST(TableReader, TitlesAreToldWithoutReading) {
    EXPECT_EQ(titles_of("# a\n\nfrequency [Hz];S\n"),
              (std::vector<std::string>{"frequency [Hz]", "S"}));
    EXPECT_EQ(titles_of("\xFF\xFE" + utf16("f\tS\n", false)), (std::vector<std::string>{"f", "S"}));
    EXPECT_TRUE(titles_of("").empty());
    EXPECT_TRUE(titles_of("\"open,x\n1,2\n").empty());
}

}  // namespace
}  // namespace ocean::csv
