// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See command.hpp.
#include "command.hpp"

#include <algorithm>
#include <string_view>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::app {

std::string OneOf::fault_of(const std::string& value) const {
    if (std::ranges::find(words, value) != words.end()) return "";
    const std::vector<std::string_view> known(words.begin(), words.end());
    return "'" + text::printable(value) + "' is none of " + joined(words, ", ") +
           did_you_mean(value, known);
}

}  // namespace ocean::app
