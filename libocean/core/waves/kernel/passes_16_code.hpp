// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The passes of N = 32 to 256, for one instruction set.
#pragma once

#include "passes_code.hpp"

namespace ocean::OCEAN_KERNEL {

constexpr SizePasses kPasses16[] = {passes_of_size<16, 2>(), passes_of_size<16, 4>(),
                                    passes_of_size<16, 8>(), passes_of_size<16, 16>()};

}  // namespace ocean::OCEAN_KERNEL
