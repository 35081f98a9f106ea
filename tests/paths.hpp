// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the checkout lies that the tests were built from.
#pragma once

#include <string>

namespace ocean::test {

/// Returns the absolute path of the repository's root, without a slash at its end.
std::string source_dir();

/// Returns the absolute path of tests/data.
inline std::string data_dir() {
    return source_dir() + "/tests/data";
}

}  // namespace ocean::test
