// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a sea takes of the machine's memory, said before it is allocated.
#pragma once

#include <cstdint>
#include <string>

#include "ocean/parameters.hpp"

namespace ocean {

/// Bytes for the modes, and for a surface of `channels` maps, work space included.
std::uint64_t modes_bytes(const Grid& grid);
std::uint64_t surface_bytes(int resolution, int channels);
/// Throws Error out_of_memory, before anything is allocated, when `bytes` is more than there is.
void require_memory(std::uint64_t bytes, const std::string& what,
                    const std::string& advice = "choose a smaller resolution");

}  // namespace ocean
