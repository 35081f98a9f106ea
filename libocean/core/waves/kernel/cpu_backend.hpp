// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `cpu` backend: a kernel for each resolution of maps, and the modes packed for it.
#pragma once

#include "ocean/backend.hpp"
#include "waves/kernel/map_kernel.hpp"

namespace ocean {

/// The channels that the kernel makes: multiples of one field, and the channels that it has code
/// for.
inline constexpr ChannelSet kCpuChannels = [] {
    ChannelSet channels = kKernelFormulas;
    for (int c = 0; c < kChannelCount; ++c) {
        if (kChannels[static_cast<std::size_t>(c)].is_multiple()) {
            channels = channels | static_cast<Channel>(c);
        }
    }
    return channels;
}();

MapFunction start_cpu();

}  // namespace ocean
