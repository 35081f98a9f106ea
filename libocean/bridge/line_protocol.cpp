// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/line_protocol.hpp"

#include <algorithm>
#include <array>

#include "ocean/checked_text.hpp"
#include "ocean/line_reader.hpp"
#include "ocean/text.hpp"
#include "ocean/version.hpp"

namespace ocean::bridge {
namespace {

constexpr std::array kCommands = {
    CommandForm{Verb::help, "HELP", "", "these commands", 0, 0},
    CommandForm{Verb::list, "LIST", "", "every name and its value", 0, 0},
    CommandForm{Verb::get, "GET", "NAME", "the value of a name", 1, 1},
    CommandForm{Verb::set, "SET", "NAME VALUE", "another value", 2, 2},
    CommandForm{Verb::subscribe, "SUBSCRIBE", "[NAME ...]",
                "the values now, and each change from now on; without names of all", 0, kAnyNumber},
    CommandForm{Verb::unsubscribe, "UNSUBSCRIBE", "[NAME ...]", "no more of them", 0, kAnyNumber},
    CommandForm{Verb::out, "OUT", "CHANNEL VALUE", "an output of a board takes the value", 2, 2},
    CommandForm{Verb::record, "RECORD", "START|STOP [FILE]", "a take is recorded", 1, 2},
    CommandForm{Verb::ping, "PING", "", "OK, if the line lives", 0, 0},
    CommandForm{Verb::auth, "AUTH", "TOKEN", "opens a guarded bridge", 1, 1},
    CommandForm{Verb::quit, "QUIT", "", "ends the connection", 0, 0},
};

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

bool same_word(std::string_view given, std::string_view upper) {
    return std::ranges::equal(given, upper, [](char a, char b) {
        return (a >= 'a' && a <= 'z' ? static_cast<char>(a - 'a' + 'A') : a) == b;
    });
}

bool is_clean(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = utf8_character(text);
        const auto first = static_cast<unsigned char>(text.front());
        if (length == 0 || (first < 0x20 && first != '\t') || first == 0x7F) return false;
        text.remove_prefix(length);
    }
    return true;
}

std::string joined(std::string_view word, std::string_view name, std::string_view value) {
    std::string line(word);
    line += ' ';
    line += name;
    line += ' ';
    return line += value;
}

}  // namespace

std::span<const CommandForm> command_forms() {
    return kCommands;
}

std::optional<std::variant<Request, Refusal>> parse_request(std::string_view line) {
    const std::string_view word = take_word(line);
    if (word.empty()) return std::nullopt;
    const auto form = std::ranges::find_if(
        kCommands, [&](const CommandForm& known) { return same_word(word, known.word); });
    if (form == kCommands.end()) {
        return Refusal{"UNKNOWN-COMMAND", "'" + text::printable(word) + "'; HELP lists them"};
    }
    Request request{form->verb, {}};
    if (form->verb == Verb::set) {
        request.arguments.emplace_back(take_word(line));
        request.arguments.emplace_back(trimmed(line));
        if (request.arguments.back().empty()) request.arguments.clear();
    } else {
        for (std::string_view next = take_word(line); !next.empty(); next = take_word(line)) {
            request.arguments.emplace_back(next);
        }
    }
    const std::size_t count = request.arguments.size();
    if (count < form->least || count > form->most) {
        const std::string usage = std::string(form->word) + ' ' + std::string(form->arguments);
        return Refusal{"USAGE", std::string(trimmed(usage))};
    }
    return request;
}

bool LineSplitter::is_text(unsigned char byte) {
    constexpr unsigned char kCommand = 0xFF;
    constexpr unsigned char kSubBegins = 0xFA;
    constexpr unsigned char kSubEnds = 0xF0;
    switch (telnet_) {
        case Telnet::text:
            if (byte != kCommand) return true;
            telnet_ = Telnet::command;
            break;
        case Telnet::command:
            // WILL, WON'T, DO and DON'T have an option behind them.
            telnet_ = byte == kSubBegins                     ? Telnet::sub
                      : byte > kSubBegins && byte < kCommand ? Telnet::option
                                                             : Telnet::text;
            break;
        case Telnet::option:
            telnet_ = Telnet::text;
            break;
        case Telnet::sub:
            if (byte == kCommand) telnet_ = Telnet::sub_command;
            break;
        case Telnet::sub_command:
            telnet_ = byte == kSubEnds ? Telnet::text : Telnet::sub;
            break;
    }
    return false;
}

std::optional<LineSplitter::Line> LineSplitter::finish() {
    Line line{std::move(line_), ""};
    line_.clear();
    if (too_long_) {
        line = {"", "TOO-LONG"};
    } else if (!is_clean(line.text)) {
        line.fault = "BAD-UTF8";
    }
    too_long_ = false;
    return line;
}

std::optional<LineSplitter::Line> LineSplitter::next(std::string_view& bytes) {
    while (!bytes.empty()) {
        const char byte = bytes.front();
        bytes.remove_prefix(1);
        if (!is_text(static_cast<unsigned char>(byte))) continue;
        if (byte == '\n' || (after_return_ && byte == '\0')) {
            after_return_ = false;
            return finish();
        }
        if (after_return_) line_ += '\r';  // one that ended nothing
        after_return_ = byte == '\r';
        if (!after_return_) line_ += byte;
        if (line_.size() > kLongestLine) {
            too_long_ = true;
            line_.clear();
        }
    }
    return std::nullopt;
}

std::string greeting_line() {
    return "OBP " + std::to_string(kProtocolVersion) + " " OCEAN_VERSION;
}

std::string value_line(std::string_view name, std::string_view value) {
    return joined("VAL", name, value);
}

std::string update_line(std::string_view name, std::string_view value) {
    return joined("UPD", name, value);
}

std::string event_line(std::string_view text) {
    return "EVT " + text::printable(text, kLongestLine / 2);
}

std::string refusal_line(const Refusal& refusal) {
    return joined("ERR", refusal.code, text::printable(refusal.text, kLongestLine / 2));
}

bool is_take_name(std::string_view name) {
    constexpr std::size_t kLongestName = 64;
    return name.size() <= kLongestName && !name.starts_with('.') &&
           std::ranges::all_of(name, [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                      c == '_' || c == '-' || c == '.';
           });
}

ServerLine parse_server_line(std::string_view line) {
    ServerLine parts;
    parts.word = take_word(line);
    parts.name = take_word(line);
    parts.rest = trimmed(line);
    return parts;
}

}  // namespace ocean::bridge
