// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Windows has no fork, and without it no limits for what reads a hostile file: that work is
// refused. See ocean/internal/child_process.hpp.
#include "ocean/error.hpp"
#include "ocean/internal/child_process.hpp"

namespace ocean::sandbox {

namespace {

[[noreturn]] void refuse() {
    throw Error(ErrorKind::bad_file,
                "files of this format are read in a process with limits, which this program does "
                "not have on Windows: convert the file on another system");
}

}  // namespace

void run_in_child(const ChildLimits&, const std::function<void(const Sink&)>&,
                  const std::function<void(const Source&)>&) {
    refuse();
}

void run_program(const ChildLimits&, const std::vector<std::string>&,
                 const std::function<void(const Source&)>&) {
    refuse();
}

}  // namespace ocean::sandbox
