// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a sea takes of the machine's memory, said before it is allocated.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "ocean/backend.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

/// Bytes of the modes,
std::uint64_t modes_bytes(const Grid& grid);
/// of so many maps,
std::uint64_t maps_bytes(int resolution, int maps);
/// and of what makes maps of these channels out of the modes.
std::uint64_t work_bytes(const Grid& grid, const Backend& backend, ChannelSet channels,
                         int resolution, std::span<const ChannelInfo> further = {});
/// Throws Error out_of_memory, before anything is allocated, when `bytes` is more than there is.
void require_memory(std::uint64_t bytes, const std::string& what,
                    const std::string& advice = "choose a smaller resolution");

}  // namespace ocean
