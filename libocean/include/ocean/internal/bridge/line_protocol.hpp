// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The line protocol OBP/1 as text: bytes to lines, a line to a request, answers to lines. No
// sockets; the only state is a line that has not ended yet. libocean/bridge/PROTOCOL.md documents
// the protocol.
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
inline constexpr std::size_t kMaxLineBytes = 1024;  // without the line's end

enum class Verb { help, list, get, set, subscribe, unsubscribe, out, record, ping, auth, quit };

/// A command as HELP and PROTOCOL.md show it.
struct CommandForm {
    Verb verb;
    std::string_view word;       // "SET"
    std::string_view arguments;  // "NAME VALUE"
    std::string_view help;
    std::size_t min_arguments;
    std::size_t max_arguments;
};
inline constexpr std::size_t kAnyNumber = 1000;
std::span<const CommandForm> command_forms();

struct Request {
    Verb verb;
    std::vector<std::string> arguments;  // SET has its value as one argument, blanks included
};

/// The reason why a line is not a request, or why a request is refused.
struct Refusal {
    std::string_view code;  // "UNKNOWN-COMMAND"
    std::string text;
};

/// Parses a line; verbs are ASCII in any case. Returns nothing for a blank line.
std::optional<std::variant<Request, Refusal>> parse_request(std::string_view line);

/// Cuts the bytes of a client into lines, in pieces of any size. LF, CR LF, CR CR LF, telnet's CR
/// NUL and a CR alone end a line. The splitter obeys the keys by which a terminal edits its line:
/// backspace and DEL erase a character of UTF-8, Ctrl-W a word; Ctrl-U and Ctrl-C drop the line.
/// Telnet's commands [RFC 854] are not text: Interrupt Process, Break, Abort and Suspend drop the
/// line, Erase Character and Erase Line edit it, and an escaped byte 255 makes it invalid UTF-8.
class LineSplitter {
  public:
    struct Line {
        std::string text;        // UTF-8 without control characters but tabs, unless `fault`
        std::string_view fault;  // "", "TOO-LONG" or "BAD-UTF8"
    };

    /// Removes bytes from the front of `bytes` up to the end of a line and returns that line, or
    /// nothing if the line has not ended. Appends to `replies`, if given, the bytes that telnet
    /// waits for: WON'T for each option it requests (DO TIMING-MARK behind Ctrl-C too), DON'T for
    /// each it offers, an event for Are You There.
    std::optional<Line> next(std::string_view& bytes, std::string* replies = nullptr);

  private:
    /// The role of a byte in the stream, after telnet's commands are removed.
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
    unsigned char command_ = 0;  // to which the next option belongs
    std::size_t sub_size_ = 0;   // bytes of the subnegotiation so far
    bool after_return_ = false;
    bool too_long_ = false;
    std::string line_;
};

// Answers and pushed lines, without the end of the line.
std::string greeting_line();
std::string value_line(std::string_view name, std::string_view value);
std::string update_line(std::string_view name, std::string_view value);
std::string event_line(std::string_view text);
/// Makes the text printable and cuts it to fit into a line.
std::string refusal_line(const Refusal& refusal);

/// Returns true for a name that a client may give to a take: letters, digits, '_', '-' and '.', at
/// most 64 bytes, no folder, no dot at the front. The empty name leaves the choice to the writer.
bool is_take_name(std::string_view name);

/// A line of a server in its parts: "UPD", "waves.0.wind_speed", "12".
struct ServerLine {
    std::string word;
    std::string name;  // the second word
    std::string rest;
};
ServerLine parse_server_line(std::string_view line);

}  // namespace ocean::bridge
