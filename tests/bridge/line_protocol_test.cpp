// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The protocol as text: any bytes, in any pieces, become the same lines; a line becomes one request
// or one refusal; and the page of the protocol has the commands that the program has.
#include "ocean/internal/bridge/line_protocol.hpp"

#include "seafile/corpus.hpp"

namespace ocean::bridge {
namespace {

/// "[text]" or "<fault>" for each line.
std::string lines_of(const std::vector<std::string>& pieces, std::string* replies = nullptr) {
    LineSplitter splitter;
    std::string seen;
    for (const std::string& piece : pieces) {
        std::string_view bytes = piece;
        while (const auto line = splitter.next(bytes, replies)) {
            seen +=
                line->fault.empty() ? "[" + line->text + "]" : "<" + std::string(line->fault) + ">";
        }
    }
    return seen;
}

/// Expects the same of all bytes at once and of each alone.
void expect_lines(const std::string& bytes, const std::string& lines, const std::string& replies) {
    SCOPED_TRACE(testing::PrintToString(bytes));
    std::vector<std::string> each;
    for (const char c : bytes) each.emplace_back(1, c);
    for (const std::vector<std::string>& pieces : {std::vector{bytes}, each}) {
        std::string given;
        EXPECT_EQ(lines_of(pieces, &given), lines);
        EXPECT_EQ(given, replies);
    }
}

TEST(LineSplitter, BytesAreTheLinesOfTheTable) {
    const toml::table table =
        ocean::test::read_table(ocean::test::source_dir() + "/tests/bridge/scripts/lines.toml");
    for (const toml::node& row : *table["lines"].as_array()) {
        const auto text = [&](std::size_t i) { return ocean::test::text_of((*row.as_array())[i]); };
        expect_lines(text(0), text(1), text(2));
    }
    const std::string longest(kMaxLineBytes - 1, 'a');
    expect_lines(std::string(2000, 'a') + "\x15PING\r\n", "[PING]", "");
    expect_lines(std::string(2000, 'a') + "\xFF\xF4PING\n", "[PING]", "");
    expect_lines(longest + "a\bb\r\n", "[" + longest + "b]", "");
    expect_lines("\xFF\xFA" + std::string(2000, 'a') + "\nPING\n", "<TOO-LONG>[PING]", "");
    for (int option = 0; option < 256; ++option) {
        const std::string end(1, static_cast<char>(option));
        std::string given;
        lines_of({"\xFF\xFD" + end + "\xFF\xFB" + end}, &given);
        EXPECT_EQ(given, "\xFF\xFC" + end + "\xFF\xFE" + end);
    }
}

TEST(LineSplitter, ALongLineIsSkippedToItsEnd) {
    EXPECT_EQ(lines_of({std::string(kMaxLineBytes, 'a') + "\n"}),
              "[" + std::string(kMaxLineBytes, 'a') + "]");
    EXPECT_EQ(lines_of({std::string(100 * kMaxLineBytes, 'a') + "\nPING\n"}), "<TOO-LONG>[PING]");
}

std::string read_as(std::string_view line) {
    const auto parsed = parse_request(line);
    if (!parsed) return "nothing";
    if (const auto* refusal = std::get_if<Refusal>(&*parsed)) return std::string(refusal->code);
    const auto& request = std::get<Request>(*parsed);
    std::string text = std::to_string(static_cast<int>(request.verb));
    for (const std::string& argument : request.arguments) text += "|" + argument;
    return text;
}

TEST(LineProtocol, ALineIsOneRequestOrOneRefusal) {
    EXPECT_EQ(read_as("   "), "nothing");
    EXPECT_EQ(read_as("set  wind_speed \t 12 "), "3|wind_speed|12");
    EXPECT_EQ(read_as("SET cascade_divisors [1, 7, 53]"), "3|cascade_divisors|[1, 7, 53]");
    EXPECT_EQ(read_as("SET wind_speed"), "USAGE");
    EXPECT_EQ(read_as("SET"), "USAGE");
    EXPECT_EQ(read_as("GET"), "USAGE");
    EXPECT_EQ(read_as("GET a b"), "USAGE");
    EXPECT_EQ(read_as("SUBSCRIBE"), "4");
    EXPECT_EQ(read_as("Subscribe a b c"), "4|a|b|c");
    EXPECT_EQ(read_as("RECORD START x.take"), "7|START|x.take");
    EXPECT_EQ(read_as("SETWIND 3"), "UNKNOWN-COMMAND");
}

TEST(LineProtocol, WhatIsSentIsOnePrintableLine) {
    EXPECT_EQ(refusal_line({"RANGE", "a\r\nUPD b 1"}), "ERR RANGE a??UPD b 1");
    EXPECT_LE(refusal_line({"RANGE", std::string(5000, 'x')}).size(), kMaxLineBytes);
    const ServerLine line = parse_server_line("UPD grid.cascade_divisors [1, 7]");
    EXPECT_EQ(line.word + "|" + line.name + "|" + line.rest, "UPD|grid.cascade_divisors|[1, 7]");
}

/// The page's table of commands is the program's.
TEST(LineProtocol, ThePageHasTheCommandsOfTheProgram) {
    std::ifstream file(ocean::test::source_dir() + "/libocean/bridge/PROTOCOL.md");
    std::stringstream page;
    page << file.rdbuf();
    std::string expected;
    for (const CommandForm& form : command_forms()) {
        std::string usage(form.word);
        if (!form.arguments.empty()) usage += " " + std::string(form.arguments);
        expected += "| `" + usage + "` | " + std::string(form.help) + " |\n";
    }
    EXPECT_NE(page.str().find("| command | does |\n|---|---|\n" + expected + "\n"),
              std::string::npos)
        << "PROTOCOL.md should have these rows and no other:\n"
        << expected;
}

}  // namespace
}  // namespace ocean::bridge
