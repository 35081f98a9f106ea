// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines of standard input: with an editor if standard input is a terminal and the build has
// libedit, else unchanged.
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

}  // namespace ocean::app
