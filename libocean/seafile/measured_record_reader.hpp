// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads [waves.measured_record] of a sea file: see measured_record.hpp.
#pragma once

#include <string>

#include "ocean/parameters.hpp"
#include "toml_input.hpp"

namespace ocean {

/// Returns the record of a table, which satisfies record_fault. `path` is the table's name in
/// messages, "waves.0.measured_record". Throws Error "NAME:LINE: PATH.key = VALUE: ...".
SpectrumRecord read_measured_record(const toml::table& table, const std::string& name,
                                    const std::string& path);

}  // namespace ocean
