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

/// What has come in, cut into lines: LF, CR LF and telnet's CR NUL end one; telnet's commands (IAC)
/// are left out, also where they stand in two pieces.
class LineSplitter {
  public:
    struct Line {
        std::string text;        // UTF-8 without control characters but tabs, unless `fault`
        std::string_view fault;  // "", "TOO-LONG" or "BAD-UTF8"
    };

    /// Takes bytes off the front up to the end of a line; nothing when they have no end.
    std::optional<Line> next(std::string_view& bytes);

  private:
    /// The byte, unless it is telnet's.
    bool is_text(unsigned char byte);
    std::optional<Line> finish();

    enum class Telnet { text, command, option, sub, sub_command };
    Telnet telnet_ = Telnet::text;
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
