// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The protocol OBP/1 as text: bytes to lines, a line to a request, replies to lines. No sockets and
// no state but that of a line which has not ended yet. libocean/bridge/PROTOCOL.md is its page.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ocean::bridge {

inline constexpr int kProtocolVersion = 1;
inline constexpr unsigned short kDefaultPort = 4747;
inline constexpr std::size_t kLongestLine = 1024;  // bytes, without its end

enum class Verb { help, list, get, set, subscribe, unsubscribe, out, record, ping, auth, quit };

/// A command as HELP and the page show it.
struct CommandForm {
    Verb verb;
    std::string_view word;       // "SET"
    std::string_view arguments;  // "NAME VALUE"
    std::string_view help;
    std::size_t least;  // of arguments
    std::size_t most;
};
inline constexpr std::size_t kAnyNumber = 1000;
std::span<const CommandForm> command_forms();

struct Request {
    Verb verb;
    std::vector<std::string> arguments;  // of SET the value as one, blanks and all
};

/// Why a line is no request, or a request is refused.
struct Refusal {
    std::string_view code;  // "UNKNOWN-COMMAND"
    std::string text;
};

/// Verbs are ASCII, in any case. Nothing of a blank line.
std::optional<std::variant<Request, Refusal>> parse_request(std::string_view line);

/// Cuts the bytes of a client into lines, wherever the pieces end. LF, CR LF, CR CR LF, telnet's CR
/// NUL and a CR alone end a line. What a terminal sends to edit its line is obeyed: backspace and
/// DEL erase a character of UTF-8, Ctrl-W a word; Ctrl-U and Ctrl-C drop the line. Telnet's
/// commands [RFC 854] are no text: Interrupt Process, Break, Abort and Suspend drop the line, Erase
/// Character and Erase Line edit it, and an escaped byte 255 is no UTF-8.
class LineSplitter {
  public:
    struct Line {
        std::string text;        // UTF-8 without control characters but tabs, unless `fault`
        std::string_view fault;  // "", "TOO-LONG" or "BAD-UTF8"
    };

    /// Takes bytes off the front up to the end of a line; nothing when they have no end. Appends to
    /// `replies`, if it is given, the bytes that telnet waits for: WON'T for each option that it
    /// asks for (DO TIMING-MARK behind Ctrl-C too), DON'T for each that it offers, an event for Are
    /// You There.
    std::optional<Line> next(std::string_view& bytes, std::string* replies = nullptr);

  private:
    /// What a byte of the stream is, once telnet's commands are taken out of it.
    enum class Byte { none, text, erase_character, erase_line };
    Byte take_telnet(unsigned char byte, std::string* replies);
    Byte take_command(unsigned char byte, std::string* replies);
    void add(char byte);
    void erase_character();
    void erase_word();
    void drop_line();
    Line finish();

    enum class Telnet { text, command, option, sub, sub_command };
    Telnet telnet_ = Telnet::text;
    unsigned char command_ = 0;  // of the option that follows
    std::size_t sub_size_ = 0;   // bytes of the subnegotiation so far
    bool after_return_ = false;
    bool too_long_ = false;
    std::string line_;
};

// Replies and what is pushed, without the end of the line.
std::string greeting_line();
std::string value_line(std::string_view name, std::string_view value);
std::string update_line(std::string_view name, std::string_view value);
std::string event_line(std::string_view text);
/// `text` becomes printable, and no longer than a line may be.
std::string refusal_line(const Refusal& refusal);

/// Whether clients may name a take so, and programs of theirs write it: letters, digits, '_', '-'
/// and
/// '.', 64 at most, no folder. "" leaves the name to whoever writes it.
bool is_take_name(std::string_view name);

/// A line that a server sent, taken apart: "UPD", "waves.0.wind_speed", "12".
struct ServerLine {
    std::string word;
    std::string name;  // what stands behind the word
    std::string rest;
};
ServerLine parse_server_line(std::string_view line);

}  // namespace ocean::bridge
