// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The input files of a command, which it must not overwrite: the user's sea or terrain, its
// spectra, a table of points.
#pragma once

#include <string>
#include <vector>

namespace ocean::app {

class InputFiles {
  public:
    /// Adds the file of the argument SEA or TERRAIN and the files that it names (named_files).
    InputFiles(const std::string& source, const std::vector<std::string>& named);
    /// Adds a file; ignores "" and paths that are not files, which cannot be overwritten.
    void add(const std::string& path);

    /// Throws Error invalid_value if `output` is one of them under any name, including links.
    void spare(const std::string& output) const;

  private:
    std::vector<std::string> paths_;
};

}  // namespace ocean::app
