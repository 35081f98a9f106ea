// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Records of spectra against a table of the corpus, whose keys corpus/README.md lists.
#pragma once

#include <vector>

#include "ocean/parameters.hpp"
#include "toml_input.hpp"

namespace ocean::test {

/// Expects the records that the table of a file says, or those of one of its cases. Prints them if
/// OCEAN_CORPUS_PRINT is set.
void expect_records(const std::vector<SpectrumRecord>& records, const toml::table& file,
                    const toml::table* of_case = nullptr);

}  // namespace ocean::test
