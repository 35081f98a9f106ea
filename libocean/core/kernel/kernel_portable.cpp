// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The kernel for portable: the flags are set in core/CMakeLists.txt.
#include "kernel_code.hpp"
