// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "line_input.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#ifdef OCEAN_HAVE_LIBEDIT
#include <editline/readline.h>
#endif

namespace ocean::app {
namespace {

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

}  // namespace

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

}  // namespace ocean::app
