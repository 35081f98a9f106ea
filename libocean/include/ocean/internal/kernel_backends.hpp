// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The kernel of the backend `cpu` for each instruction set, as backends of their own: for tools
// that compare them.
#pragma once

#include <span>

#include "ocean/backend.hpp"

namespace ocean {

/// Returns a backend for each instruction set that this machine runs and OCEAN_SIMD allows, "avx2"
/// or another word of OCEAN_SIMD, the one that `cpu` uses first.
std::span<const Backend> kernel_backends();

}  // namespace ocean
