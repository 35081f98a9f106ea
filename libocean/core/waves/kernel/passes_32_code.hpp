// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The passes of N = 512 and 1024, for one instruction set.
#pragma once

#include "passes_code.hpp"

namespace ocean::OCEAN_KERNEL {

constexpr SizePasses kPasses32[] = {passes_of_size<32, 16>(), passes_of_size<32, 32>()};

}  // namespace ocean::OCEAN_KERNEL
