// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a command reads it does not write over: the user's sea, its spectra, a table of points.
#pragma once

#include <string>
#include <vector>

#include "sea_argument.hpp"

namespace ocean::app {

class InputFiles {
  public:
    /// The file of the SEA argument and those that it names (named_files).
    InputFiles(const SeaArgument& argument, const std::vector<std::string>& named);
    /// "" and what is no file are let in: they cannot be written over.
    void add(const std::string& path);

    /// Throws Error invalid_value if `output` is one of them under whatever name, as a link too.
    void spare(const std::string& output) const;

  private:
    std::vector<std::string> paths_;
};

}  // namespace ocean::app
