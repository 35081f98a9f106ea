// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/line_protocol.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/line_reader.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/version.hpp"

namespace ocean::bridge {
namespace {

constexpr std::array kCommands = {
    CommandForm{Verb::help, "HELP", "", "lists the commands", 0, 0},
    CommandForm{Verb::list, "LIST", "", "lists every name and its value", 0, 0},
    CommandForm{Verb::get, "GET", "NAME", "shows the value of a name", 1, 1},
    CommandForm{Verb::set, "SET", "NAME VALUE", "sets a value", 2, 2},
    CommandForm{Verb::subscribe, "SUBSCRIBE", "[NAME ...]",
                "sends the values now and each later change; without names, of all values", 0,
                kAnyNumber},
    CommandForm{Verb::unsubscribe, "UNSUBSCRIBE", "[NAME ...]",
                "ends subscriptions; without names, all of them", 0, kAnyNumber},
    CommandForm{Verb::out, "OUT", "CHANNEL VALUE", "sets an output of a board", 2, 2},
    CommandForm{Verb::record, "RECORD", "START|STOP [FILE]",
                "starts or stops the recording of a take", 1, 2},
    CommandForm{Verb::ping, "PING", "", "answers OK", 0, 0},
    CommandForm{Verb::auth, "AUTH", "TOKEN", "opens a guarded bridge", 1, 1},
    CommandForm{Verb::quit, "QUIT", "", "ends the connection", 0, 0},
};

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

// [RFC 854] p. 14, and [RFC 1184] section 2.5 for Suspend and Abort.
constexpr unsigned char kSuspend = 237;
constexpr unsigned char kAbort = 238;
constexpr unsigned char kBreak = 243;
constexpr unsigned char kInterrupt = 244;
constexpr unsigned char kAreYouThere = 246;
constexpr unsigned char kEraseCharacter = 247;
constexpr unsigned char kEraseLine = 248;
constexpr unsigned char kSubBegins = 250;
constexpr unsigned char kWill = 251;
constexpr unsigned char kWont = 252;
constexpr unsigned char kDo = 253;
constexpr unsigned char kDont = 254;
constexpr unsigned char kIac = 255;

std::string answer_line(std::string_view word, std::string_view name, std::string_view value) {
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
    const std::string_view word = next_word(line);
    if (word.empty()) return std::nullopt;
    const auto form = std::ranges::find_if(
        kCommands, [&](const CommandForm& known) { return same_word(word, known.word); });
    if (form == kCommands.end()) {
        return Refusal{"UNKNOWN-COMMAND", "'" + text::printable(word) + "'" +
                                              did_you_mean(word, kCommands, &CommandForm::word) +
                                              "; HELP lists them"};
    }
    Request request{form->verb, {}};
    if (form->verb == Verb::set) {
        request.arguments.emplace_back(next_word(line));
        request.arguments.emplace_back(trimmed(line));
        if (request.arguments.back().empty()) request.arguments.clear();
    } else {
        for (std::string_view next = next_word(line); !next.empty(); next = next_word(line)) {
            request.arguments.emplace_back(next);
        }
    }
    const std::size_t count = request.arguments.size();
    if (count < form->min_arguments || count > form->max_arguments) {
        const std::string usage = std::string(form->word) + ' ' + std::string(form->arguments);
        return Refusal{"USAGE", std::string(trimmed(usage))};
    }
    return request;
}

LineSplitter::Byte LineSplitter::take_telnet(unsigned char byte, std::string* replies) {
    switch (telnet_) {
        case Telnet::text:
            if (byte != kIac) return Byte::text;
            telnet_ = Telnet::command;
            break;
        case Telnet::command:
            return take_command(byte, replies);
        case Telnet::option:
            telnet_ = Telnet::text;
            // WON'T and DON'T get no answer, or two programs would refuse each other for ever.
            if (replies != nullptr && (command_ == kDo || command_ == kWill)) {
                *replies += static_cast<char>(kIac);
                *replies += static_cast<char>(command_ == kDo ? kWont : kDont);
                *replies += static_cast<char>(byte);
            }
            break;
        case Telnet::sub:
            if (byte == kIac) {
                telnet_ = Telnet::sub_command;
            } else if (++sub_size_ > kMaxLineBytes) {
                // Its end is missing; the lines that follow must not be part of it.
                telnet_ = Telnet::text;
                too_long_ = true;
            }
            break;
        case Telnet::sub_command:
            if (byte == kIac) {
                telnet_ = Telnet::sub;  // an escaped 255 in the option's data
            } else {
                return take_command(byte, replies);  // SE, or a command that breaks it off
            }
            break;
    }
    return Byte::none;
}

LineSplitter::Byte LineSplitter::take_command(unsigned char byte, std::string* replies) {
    telnet_ = Telnet::text;
    switch (byte) {
        case kIac:
            return Byte::text;
        case kSubBegins:
            telnet_ = Telnet::sub;
            sub_size_ = 0;
            break;
        case kWill:
        case kWont:
        case kDo:
        case kDont:
            telnet_ = Telnet::option;
            command_ = byte;
            break;
        case kAreYouThere:
            if (replies != nullptr) *replies += event_line("HERE") + "\r\n";
            break;
        case kEraseCharacter:
            return Byte::erase_character;
        case kInterrupt:
        case kBreak:
        case kAbort:
        case kSuspend:
        case kEraseLine:
            return Byte::erase_line;
        default:
            break;  // No Operation, Data Mark, Go Ahead, Abort Output and commands without a
                    // meaning here
    }
    return Byte::none;
}

void LineSplitter::add(char byte) {
    line_ += byte;
    if (line_.size() <= kMaxLineBytes) return;
    too_long_ = true;
    line_.clear();
}

void LineSplitter::erase_character() {
    while (!line_.empty()) {
        const bool is_first = (static_cast<unsigned char>(line_.back()) & 0xC0) != 0x80;
        line_.pop_back();
        if (is_first) return;
    }
}

void LineSplitter::erase_word() {
    const std::size_t last = line_.find_last_not_of(" \t");
    const std::size_t blank = last == std::string::npos ? last : line_.find_last_of(" \t", last);
    line_.erase(blank == std::string::npos ? 0 : blank + 1);
}

void LineSplitter::drop_line() {
    line_.clear();
    too_long_ = false;
}

LineSplitter::Line LineSplitter::finish() {
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

std::optional<LineSplitter::Line> LineSplitter::next(std::string_view& bytes,
                                                     std::string* replies) {
    constexpr char kBackspace = '\b';
    constexpr char kDelete = '\x7F';
    constexpr char kControlC = '\x03';
    constexpr char kControlU = '\x15';
    constexpr char kControlW = '\x17';
    while (!bytes.empty()) {
        const char byte = bytes.front();
        bytes.remove_prefix(1);
        const Byte kind = take_telnet(static_cast<unsigned char>(byte), replies);
        if (kind == Byte::none) continue;
        const bool after_return = std::exchange(after_return_, false);
        if (kind == Byte::erase_character) {
            erase_character();
        } else if (kind == Byte::erase_line) {
            drop_line();
        } else if (byte == '\r') {
            after_return_ = true;
            if (!after_return) return finish();
        } else if (byte == '\n') {
            if (!after_return) return finish();
        } else if (byte == '\0' && after_return) {
            continue;
        } else if (byte == kBackspace || byte == kDelete) {
            erase_character();
        } else if (byte == kControlW) {
            erase_word();
        } else if (byte == kControlU || byte == kControlC) {
            drop_line();
        } else {
            add(byte);
        }
    }
    return std::nullopt;
}

std::string greeting_line() {
    return "OBP " + std::to_string(kProtocolVersion) + " " OCEAN_VERSION;
}

std::string value_line(std::string_view name, std::string_view value) {
    return answer_line("VAL", name, value);
}

std::string update_line(std::string_view name, std::string_view value) {
    return answer_line("UPD", name, value);
}

std::string event_line(std::string_view text) {
    return "EVT " + text::printable(text, kMaxLineBytes / 2);
}

std::string refusal_line(const Refusal& refusal) {
    return answer_line("ERR", refusal.code, text::printable(refusal.text, kMaxLineBytes / 2));
}

bool is_take_name(std::string_view name) {
    constexpr std::size_t kMaxNameBytes = 64;
    return name.size() <= kMaxNameBytes && !name.starts_with('.') &&
           std::ranges::all_of(name, [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                      c == '_' || c == '-' || c == '.';
           });
}

ServerLine parse_server_line(std::string_view line) {
    ServerLine parts;
    parts.word = next_word(line);
    parts.name = next_word(line);
    parts.rest = trimmed(line);
    return parts;
}

}  // namespace ocean::bridge
