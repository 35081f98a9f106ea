// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files that windows opened last, in a text of the user's state: a path a line, the newest
// first.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ocean::app {

class RecentFiles {
  public:
    static constexpr std::size_t kMaxFiles = 10;

    /// path: of the list; "" keeps none.
    explicit RecentFiles(std::string path = default_path()) : path_(std::move(path)) {}

    /// Returns the state_file `recent`.
    static std::string default_path();

    /// Returns at most kMaxFiles paths. Lines that are no absolute path, or too long, or not
    /// UTF-8, are left out, and so is all of a list that is too large.
    std::vector<std::string> read() const;
    /// Puts a file first. Throws Error output if the list cannot be written.
    void add(const std::string& file) const;

  private:
    std::string path_;
};

}  // namespace ocean::app
