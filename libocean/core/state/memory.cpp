// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bytes of modes and maps; see memory.hpp.
#include "ocean/memory.hpp"

#include <algorithm>
#include <complex>

#include "ocean/error.hpp"
#include "ocean/platform.hpp"

namespace ocean {

std::uint64_t modes_bytes(const Grid& grid) {
    const auto n = static_cast<std::uint64_t>(grid.resolution);
    return n * n * (sizeof(std::complex<float>) + 3 * sizeof(float)) *
           static_cast<std::uint64_t>(grid.cascades);
}

std::uint64_t surface_bytes(int resolution, int channels) {
    // The maps themselves, the linear planes they are made of, and the half spectra between the two
    // passes of the transform: at most eleven linear fields exist.
    const auto n = static_cast<std::uint64_t>(resolution);
    const auto maps = static_cast<std::uint64_t>(channels);
    const std::uint64_t linear = std::min<std::uint64_t>(maps + 5, 11);
    return n * n * sizeof(float) * (maps + 2 * linear);
}

void require_memory(std::uint64_t bytes, const std::string& what, const std::string& advice) {
    if (bytes == 0) return;  // what is left is asked of the system
    const std::uint64_t there = available_memory();
    if (bytes <= there) return;
    const auto mebibytes = [](std::uint64_t value) { return std::to_string(value >> 20) + " MiB"; };
    throw Error(ErrorKind::out_of_memory, what + " needs " + mebibytes(bytes) +
                                              " of memory, there are " + mebibytes(there) + "; " +
                                              advice);
}

}  // namespace ocean
