// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The loop that reads the signals for sse4: the flags are set in core/CMakeLists.txt.
#include "shore/signal_code.hpp"
