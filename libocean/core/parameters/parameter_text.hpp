// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Parameters as text: shared by the access functions and the table's print-outs.
#pragma once

#include <string>
#include <string_view>

#include "ocean/parameter_table.hpp"

namespace ocean {

/// Text to the type that the table gives, without range checks (assign makes them).
ParameterValue parse_value(const ParameterRef& ref, std::string_view text);
/// As to_text, but texts in quotes: for messages.
std::string quoted_text(const ParameterValue& value);

}  // namespace ocean
