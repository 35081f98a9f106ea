// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The protocol as text: any bytes, in any pieces, become the same lines; a line becomes one request
// or one refusal; and the page of the protocol has the commands that the program has.
#include "ocean/internal/bridge/line_protocol.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>
#include <utility>

#include "paths.hpp"

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

std::string each_byte_alone(const std::string& bytes) {
    std::vector<std::string> pieces;
    for (const char c : bytes) pieces.emplace_back(1, c);
    return lines_of(pieces);
}

TEST(LineSplitter, EndsOfLinesAreThoseOfEveryProgram) {
    using namespace std::string_literals;
    EXPECT_EQ(lines_of({"GET a\nGET b\r\nGET c\r\0rest"s}), "[GET a][GET b][GET c]");
    EXPECT_EQ(lines_of({"half", " a line\n\n"}), "[half a line][]");
    for (const std::string& bytes :
         {"a\r\r\nb\r\n"s, "a\rb\r"s, "a\r\r\0b\r\0"s, "a\r\r\r\nb\n"s, "a\r\xFF\xF1\nb\n"s}) {
        EXPECT_EQ(lines_of({bytes}), "[a][b]") << testing::PrintToString(bytes);
        EXPECT_EQ(each_byte_alone(bytes), "[a][b]") << testing::PrintToString(bytes);
    }
    EXPECT_EQ(lines_of({"a\r"}), "[a]") << "a CR alone is not to wait for what follows";
    EXPECT_EQ(lines_of({"a\r\n\r\nb\n\n"}), "[a][][b][]");
}

TEST(LineSplitter, ALineIsEditedAsInATerminal) {
    const std::string wave = "\xF0\x9F\x8C\x8A";
    const std::vector<std::pair<std::string, std::string>> lines = {
        {"PINX\bG", "[PING]"},
        {"PINX\x7FG", "[PING]"},
        {"PINX\xFF\xF7G", "[PING]"},  // telnet's Erase Character
        {"\b\x7FPING", "[PING]"},     // nothing is there to erase
        {"PI" + wave + "\bNG", "[PING]"},
        {"PI\xC3\xA4\xE2\x82\xAC\b\bNG", "[PING]"},
        {"PING\b\b\b\b\b", "[]"},
        {"\xC3(\b\bPING", "[PING]"},  // what was no text is gone
        {"GET a b  \x17", "[GET a ]"},
        {"GET a\x17\x17\x17PING", "[PING]"},
        {"FLY\x15PING", "[PING]"},
        {"FLY\x03PING", "[PING]"},
        {"FLY\xFF\xF8PING", "[PING]"},  // telnet's Erase Line
        {std::string(2000, 'a') + "\x15PING", "[PING]"},
        {std::string(kMaxLineBytes, 'a') + "\bb", "[" + std::string(kMaxLineBytes - 1, 'a') + "b]"},
    };
    for (const auto& [bytes, line] : lines) {
        EXPECT_EQ(lines_of({bytes + "\r\n"}), line) << testing::PrintToString(bytes);
        EXPECT_EQ(each_byte_alone(bytes + "\r\n"), line) << testing::PrintToString(bytes);
    }
}

TEST(LineSplitter, TelnetsCommandsAreNoText) {
    const std::string bytes = "\xFF\xFD\x06PI\xFF\xFA\x18\x01xterm\xFF\xF0NG\xFF\xF1\r\n";
    EXPECT_EQ(lines_of({bytes}), "[PING]");
    EXPECT_EQ(each_byte_alone(bytes), "[PING]");
    // A subnegotiation with an escaped 255, one that DO breaks off, and one that never ends.
    EXPECT_EQ(lines_of({"PI\xFF\xFA\x18\xFF\xFF\xF0\xFF\xF0NG\n"}), "[PING]");
    EXPECT_EQ(lines_of({"PI\xFF\xFA\x18\xFF\xFD\x01NG\n"}), "[PING]");
    EXPECT_EQ(lines_of({"\xFF\xFA" + std::string(2000, 'a') + "\nPING\n"}), "<TOO-LONG>[PING]");
    // An escaped 255 is a byte of the line, and no UTF-8.
    EXPECT_EQ(lines_of({"PI\xFF\xFFNG\nPING\n"}), "<BAD-UTF8>[PING]");
}

/// [RFC 854]: a request is refused, a refusal is not answered. [RFC 860]: until DO TIMING-MARK is
/// answered, a telnet that was interrupted shows nothing.
TEST(LineSplitter, TelnetIsAnsweredWhatItWaitsFor) {
    const std::vector<std::array<std::string, 3>> cases = {
        {"FLY\xFF\xF4\xFF\xFD\x06PING\r\n", "[PING]", "\xFF\xFC\x06"},  // Ctrl-C
        {"FLY\xFF\xF3PING\n", "[PING]", ""},                            // Break
        {"FLY\xFF\xEEPING\n", "[PING]", ""},                            // Abort
        {"FLY\xFF\xEDPING\n", "[PING]", ""},                            // Suspend
        {std::string(2000, 'a') + "\xFF\xF4PING\n", "[PING]", ""},
        {"PI\xFF\xF5NG\n", "[PING]", ""},  // Abort Output
        {"PI\xFF\xF2NG\n", "[PING]", ""},  // Data Mark
        {"PI\xFF\xF6NG\n", "[PING]", "EVT HERE\r\n"},
        {"PI\xFF\xFD\xFFNG\n", "[PING]", "\xFF\xFC\xFF"},  // option 255
        {"\xFF\xFB\x1F\xFF\xFA\x1F\x01\x02\x03\x04\xFF\xF0PING\n", "[PING]", "\xFF\xFE\x1F"},
        {"\xFF\xFC\x06\xFF\xFE\x06PING\n", "[PING]", ""},
    };
    for (const auto& [bytes, lines, replies] : cases) {
        std::string given;
        EXPECT_EQ(lines_of({bytes}, &given), lines) << testing::PrintToString(bytes);
        EXPECT_EQ(given, replies) << testing::PrintToString(bytes);
    }
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

TEST(LineSplitter, WhatIsNotUtf8TextIsNamed) {
    using namespace std::string_literals;
    for (const std::string& bad : {"\xC3("s, "\xED\xA0\x80"s, "a\0b"s, "\xC3(\b"s, "\x1B[2J"s}) {
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
