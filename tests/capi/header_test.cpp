// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// libocean.h alone, as C++ reads it: it must compile without another include and link as C.
#include "libocean.h"

const char* version_seen_by_cpp();
const char* version_seen_by_cpp() {
    return ocean_version();
}
static_assert(sizeof(ocean_output::channel) == 16, "four channels");
static_assert(sizeof(ocean_spray_particle) == 56, "no padding: an array is read as columns");
