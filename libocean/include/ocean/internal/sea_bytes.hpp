// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The memory that a sea needs, known before it is allocated.
#pragma once

#include <cstdint>
#include <span>

#include "ocean/backend.hpp"
#include "ocean/channel.hpp"
#include "ocean/domain.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

/// Returns the bytes of the modes.
std::uint64_t modes_bytes(const Grid& grid);
/// Returns the bytes of `maps` maps.
std::uint64_t maps_bytes(int resolution, int maps);
/// Returns the bytes that computing these channels from the modes needs, beside modes and maps.
std::uint64_t work_bytes(const Grid& grid, const Backend& backend, ChannelSet channels,
                         int resolution, std::span<const ChannelInfo> host_channels = {});
/// Returns the bytes of the coast of a sea over a bed, the work space that builds it included.
std::uint64_t coast_bytes(const Parameters& parameters);
/// Returns the bytes of the maps of a sea with hulls.
std::uint64_t hull_sea_bytes(const Parameters& parameters);
/// Returns the bytes that a region of these channels needs beside the region.
std::uint64_t region_work_bytes(const Parameters& parameters, const Domain& domain,
                                ChannelSet channels);

}  // namespace ocean
