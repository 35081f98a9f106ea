// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "terminal_client.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#ifdef OCEAN_HAVE_LIBEDIT
#include <editline/readline.h>
#endif

#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bridge/line_client.hpp"
#include "ocean/internal/bridge/line_protocol.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::app {
namespace {

/// Lines of standard input: with an editor if standard input is a terminal and the build has
/// libedit, else unchanged.
class LineInput {
  public:
    LineInput();
    ~LineInput();
    LineInput(const LineInput&) = delete;
    LineInput& operator=(const LineInput&) = delete;

    /// Blocks until input arrives or the time is over. Returns the complete lines.
    std::vector<std::string> wait(int milliseconds);
    bool ended() const { return ended_; }
    /// Removes the line being typed from the terminal, so that other text can be written.
    void hide();
    /// Shows the line being typed again.
    void show();
    /// Restores the terminal's settings.
    void restore();

  private:
    void read_plain();

    bool editing_ = false;
    bool ended_ = false;
    std::string partial_;
    std::vector<std::string> lines_;
};

constexpr std::size_t kMaxLineBytes = 4096;

#ifdef OCEAN_HAVE_LIBEDIT
constexpr const char* kPrompt = "> ";
// libedit calls back without an argument, so the one terminal has global variables.
std::vector<std::string>* typed = nullptr;
bool* typed_ended = nullptr;

void on_line(char* line) {
    if (line == nullptr) {
        *typed_ended = true;
        rl_callback_handler_remove();
        return;
    }
    if (*line != '\0') add_history(line);
    typed->emplace_back(line);
    std::free(line);
}
#endif

LineInput::LineInput() {
#ifdef OCEAN_HAVE_LIBEDIT
    editing_ = ::isatty(STDIN_FILENO) != 0 && ::isatty(STDOUT_FILENO) != 0;
    if (!editing_) return;
    typed = &lines_;
    typed_ended = &ended_;
    rl_callback_handler_install(kPrompt, on_line);
#endif
}

LineInput::~LineInput() {
    restore();
}

void LineInput::restore() {
#ifdef OCEAN_HAVE_LIBEDIT
    if (std::exchange(editing_, false)) rl_callback_handler_remove();
#endif
}

std::vector<std::string> LineInput::wait(int milliseconds) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (ended_) {
        ::poll(nullptr, 0, milliseconds);
        return {};
    }
    if (::poll(&input, 1, milliseconds) <= 0) return {};
#ifdef OCEAN_HAVE_LIBEDIT
    if (editing_) {
        rl_callback_read_char();
        return std::exchange(lines_, {});
    }
#endif
    read_plain();
    return std::exchange(lines_, {});
}

void LineInput::read_plain() {
    std::array<char, 4096> block{};
    const auto count = ::read(STDIN_FILENO, block.data(), block.size());
    if (count < 0 && errno == EINTR) return;
    if (count <= 0) {
        ended_ = true;
        if (!partial_.empty()) lines_.push_back(std::exchange(partial_, ""));
        return;
    }
    for (const char c : std::string_view(block.data(), static_cast<std::size_t>(count))) {
        if (c == '\n') {
            lines_.push_back(std::exchange(partial_, ""));
        } else if (partial_.size() < kMaxLineBytes) {
            partial_ += c;
        }
    }
}

void LineInput::hide() {
    if (editing_) std::fputs("\r\033[K", stdout);
}

void LineInput::show() {
#ifdef OCEAN_HAVE_LIBEDIT
    if (editing_) rl_forced_update_display();
#endif
    std::fflush(stdout);
}

using Kind = bridge::ClientEvent::Kind;

std::string shown(const bridge::ClientEvent& event) {
    switch (event.kind) {
        case Kind::value:
            return event.name + " = " + event.text;
        case Kind::writer:
            return event.name + " is set by " + event.text;
        case Kind::lost:
            return "(no bridge: " + event.text + ")";
        case Kind::refused:
            return "ERR " + event.text;
        case Kind::connected:
        case Kind::notice:
        case Kind::reply:
            break;
    }
    return event.text;
}

bool asks_to_quit(const std::string& line) {
    const auto parsed = bridge::parse_request(line);
    const auto* request = parsed ? std::get_if<bridge::Request>(&*parsed) : nullptr;
    return request != nullptr && request->verb == bridge::Verb::quit;
}

}  // namespace

void run_terminal_client(const bridge::Endpoint& server, const std::string& token,
                         const Context& context) {
    constexpr int kPollInterval = 20;  // [ms]

    LineInput input;
    const InterruptWatch::LastAct last(context.interrupts, [&input] { input.restore(); });
    bridge::LineClient client({.server = server, .token = token, .subscribe = false});
    std::vector<std::string> unsent;  // lines typed before the connection
    std::string failure;              // the reason for no connection
    bool was_connected = false;
    bool leaving = false;
    for (;;) {
        for (std::string& line : input.wait(kPollInterval)) unsent.push_back(std::move(line));
        if (client.connected()) {
            for (const std::string& line : unsent) {
                client.send(line);
                leaving = leaving || asks_to_quit(line);
            }
            unsent.clear();
            if (input.ended() && !leaving) {
                leaving = true;
                client.send("QUIT");
            }
        }
        const auto events = client.events();
        if (!events.empty()) input.hide();
        for (const bridge::ClientEvent& event : events) {
            context.console.data(text::printable(shown(event), 1000) + "\n");
            was_connected = was_connected || event.kind == Kind::connected;
            if (event.kind != Kind::lost) continue;
            if (leaving) return input.restore();
            failure = event.text;
        }
        // Input of a pipe does not wait for a bridge.
        if (input.ended() && !was_connected && !failure.empty()) {
            throw Error(ErrorKind::output, server.text() + ": " + failure);
        }
        if (!events.empty()) input.show();
    }
}

}  // namespace ocean::app
