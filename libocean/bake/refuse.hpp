// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ocean/error.hpp"

namespace ocean {

/// Throws Error for an option with a value that is not allowed.
[[noreturn]] inline void refuse(const std::string& message) {
    throw Error(ErrorKind::invalid_value, message);
}

}  // namespace ocean
