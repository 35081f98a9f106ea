// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What is wrong and what is then said, from a file of rows.
#pragma once

#include <string>
#include <vector>

#include "seafile/corpus.hpp"

namespace ocean::test {

struct Mistake {
    std::string text;
    std::string says;
};

/// Returns the rows of a list in a file of the folder tests.
inline std::vector<Mistake> mistakes(const std::string& file, const std::string& list) {
    const toml::table table = read_table(source_dir() + "/tests/" + file);
    std::vector<Mistake> found;
    for (const toml::node& row : *table[list].as_array()) {
        const toml::array& words = *row.as_array();
        found.push_back({text_of(words[0]), text_of(words[1])});
    }
    return found;
}

}  // namespace ocean::test
