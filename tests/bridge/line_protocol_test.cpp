// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The protocol as text: any bytes, in any pieces, become the same lines; a line becomes one request
// or one refusal; and the page of the protocol has the commands that the program has.
#include "ocean/bridge/line_protocol.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "paths.hpp"

namespace ocean::bridge {
namespace {

/// "[text]" or "<fault>" for each line.
std::string lines_of(const std::vector<std::string>& pieces) {
    LineSplitter splitter;
    std::string seen;
    for (const std::string& piece : pieces) {
        std::string_view bytes = piece;
        while (const auto line = splitter.next(bytes)) {
            seen +=
                line->fault.empty() ? "[" + line->text + "]" : "<" + std::string(line->fault) + ">";
        }
    }
    return seen;
}

std::string each_byte_alone(const std::string& bytes) {
    std::vector<std::string> pieces;
    for (const char c : bytes) pieces.emplace_back(1, c);
    return lines_of(pieces);
}

TEST(LineSplitter, EndsOfLinesAreThoseOfEveryProgram) {
    using namespace std::string_literals;
    EXPECT_EQ(lines_of({"GET a\nGET b\r\nGET c\r\0rest"s}), "[GET a][GET b][GET c]");
    EXPECT_EQ(lines_of({"half", " a line\n\n"}), "[half a line][]");
}

TEST(LineSplitter, TelnetsCommandsAreNoText) {
    const std::string bytes = "\xFF\xFD\x06PI\xFF\xFA\x18\x01xterm\xFF\xF0NG\xFF\xF1\r\n";
    EXPECT_EQ(lines_of({bytes}), "[PING]");
    EXPECT_EQ(each_byte_alone(bytes), "[PING]");
}

TEST(LineSplitter, ALongLineIsSkippedToItsEnd) {
    EXPECT_EQ(lines_of({std::string(kLongestLine, 'a') + "\n"}),
              "[" + std::string(kLongestLine, 'a') + "]");
    EXPECT_EQ(lines_of({std::string(100 * kLongestLine, 'a') + "\nPING\n"}), "<TOO-LONG>[PING]");
}

TEST(LineSplitter, WhatIsNotUtf8TextIsNamed) {
    using namespace std::string_literals;
    for (const std::string& bad :
         {"\xC3("s, "\xED\xA0\x80"s, "a\0b"s, "a\rb"s, "\x7F"s, "\x1B[2J"s}) {
        EXPECT_EQ(lines_of({bad + "\nPING\n"}), "<BAD-UTF8>[PING]");
        EXPECT_EQ(each_byte_alone(bad + "\nPING\n"), "<BAD-UTF8>[PING]");
    }
    EXPECT_EQ(each_byte_alone("SET a \xF0\x9F\x8C\x8A\n"), "[SET a \xF0\x9F\x8C\x8A]");
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
    EXPECT_LE(refusal_line({"RANGE", std::string(5000, 'x')}).size(), kLongestLine);
    const ServerLine line = parse_server_line("UPD grid.cascade_divisors [1, 7]");
    EXPECT_EQ(line.word + "|" + line.name + "|" + line.rest, "UPD|grid.cascade_divisors|[1, 7]");
}

/// The page's table of commands is the program's.
TEST(LineProtocol, ThePageHasTheCommandsOfTheProgram) {
    std::ifstream file(test::source_dir() + "/libocean/bridge/PROTOCOL.md");
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
