// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bytes of modes and maps; see memory.hpp.
#include "ocean/internal/memory.hpp"

#include <complex>

#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"

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
    // Channels that the backend has no code for are made of planes of their fields.
    const LinearSet planes = fields_of(channels.without(backend.makes), false, host_channels);
    return own + maps_bytes(resolution, planes.size());
}

void require_memory(std::uint64_t bytes, const std::string& what, const std::string& advice) {
    if (bytes == 0) return;  // available_memory() is a system call
    const std::uint64_t there = available_memory();
    if (bytes <= there) return;
    const auto mebibytes = [](std::uint64_t value) { return std::to_string(value >> 20) + " MiB"; };
    throw Error(ErrorKind::out_of_memory, what + " needs " + mebibytes(bytes) + " of memory, " +
                                              mebibytes(there) + " are available; " + advice);
}

}  // namespace ocean
