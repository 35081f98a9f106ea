// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The check, before an allocation, that enough memory is available.
#pragma once

#include <cstdint>
#include <string>

namespace ocean {

/// Throws Error out_of_memory, before anything is allocated, if `bytes` exceeds the available
/// memory. `what` names the data in the message.
void require_memory(std::uint64_t bytes, const std::string& what,
                    const std::string& advice = "choose a smaller resolution");

}  // namespace ocean
