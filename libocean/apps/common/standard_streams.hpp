// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The standard streams, where systems and those who start a program differ.
#pragma once

namespace ocean::app {

/// Call it before any file is opened. Opens those standard streams that the program was started
/// without, as daemons and some farms start it: the first files would get their numbers, and what
/// is printed. They are empty, and take what nobody reads. On Windows makes standard input and
/// output carry bytes as they are: it would translate line ends.
void prepare_standard_streams();

/// Returns whether somebody looks at standard error.
bool standard_error_is_terminal();

}  // namespace ocean::app
