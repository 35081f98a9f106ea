// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The check of a mesher's input channels.
#pragma once

#include <initializer_list>
#include <string>

#include "ocean/error.hpp"
#include "ocean/surface.hpp"

namespace ocean::io {

inline void require_channels(const Surface& surface, std::initializer_list<Channel> channels) {
    for (const Channel channel : channels) {
        if (!surface.has(channel)) {
            throw Error(ErrorKind::invalid_value, "a mesh needs channel " +
                                                      std::to_string(static_cast<int>(channel)) +
                                                      ", which the surface was evaluated without");
        }
    }
}

}  // namespace ocean::io
