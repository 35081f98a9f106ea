// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See assignment.hpp.
#include "assignment.hpp"

#include "ocean/error.hpp"

namespace ocean::app {

Assignment parse_assignment(const std::string& text, std::string_view example) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw Error(ErrorKind::invalid_value,
                    "--set " + text + ": allowed is NAME=VALUE, such as " + std::string(example));
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace ocean::app
