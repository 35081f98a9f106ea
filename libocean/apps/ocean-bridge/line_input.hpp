// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines that somebody types: with libedit where there is a terminal and the library, else as they
// come.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ocean::app {

class LineInput {
  public:
    LineInput();
    ~LineInput();
    LineInput(const LineInput&) = delete;
    LineInput& operator=(const LineInput&) = delete;

    /// The lines that are complete, after waiting for some at most so long.
    std::vector<std::string> wait(int milliseconds);
    bool ended() const { return ended_; }
    /// Takes the line being typed off the terminal, and puts it back, so that others may write.
    void hide();
    void show();
    /// The terminal as it was.
    void restore();

  private:
    void read_plain();

    bool editing_ = false;
    bool ended_ = false;
    std::string partial_;
    std::vector<std::string> lines_;
};

}  // namespace ocean::app
