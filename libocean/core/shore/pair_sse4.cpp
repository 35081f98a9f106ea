// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The loop that adds the waves of a pair for sse4: the flags are set in core/CMakeLists.txt.
#include "shore/pair_code.hpp"
