// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The loop of the gullies for sse4: the flags are set in core/CMakeLists.txt.
#include "terrain/gullies_code.hpp"
