// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The passes of N = 2048 to 8192, for one instruction set.
#pragma once

#include "passes_code.hpp"

namespace ocean::OCEAN_KERNEL {

constexpr SizePasses kPasses64[] = {passes_of_size<64, 32>(), passes_of_size<64, 64>(),
                                    passes_of_size<64, 128>()};

}  // namespace ocean::OCEAN_KERNEL
