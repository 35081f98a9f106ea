// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The standard streams, where Windows differs from other systems.
#pragma once

namespace ocean::app {

/// Makes standard input and output carry bytes as they are: Windows would translate line ends.
void use_binary_streams();

/// Returns whether somebody looks at standard error.
bool standard_error_is_terminal();

}  // namespace ocean::app
