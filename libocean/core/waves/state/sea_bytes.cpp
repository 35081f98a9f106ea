// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bytes of modes and maps; see sea_bytes.hpp.
#include "ocean/internal/sea_bytes.hpp"

#include <complex>

#include "ocean/internal/grid.hpp"

namespace ocean {

std::uint64_t modes_bytes(const Grid& grid) {
    const auto n = static_cast<std::uint64_t>(grid.resolution);
    return n * n * (sizeof(std::complex<float>) + 3 * sizeof(float)) *
           static_cast<std::uint64_t>(grid.cascades);
}

std::uint64_t maps_bytes(int resolution, int maps) {
    return Lattice{resolution, 1.0}.size() * sizeof(float) * static_cast<std::uint64_t>(maps);
}

std::uint64_t work_bytes(const Grid& grid, const Backend& backend, ChannelSet channels,
                         int resolution, std::span<const ChannelInfo> host_channels) {
    const std::uint64_t own =
        backend.work_bytes == nullptr
            ? 0
            : backend.work_bytes(grid, fields_of(channels, false, host_channels), resolution);
    // Channels without code in the backend are computed from planes of their fields.
    const LinearSet planes = fields_of(channels.without(backend.makes), false, host_channels);
    return own + maps_bytes(resolution, planes.size());
}

}  // namespace ocean
