// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The text of `ocean info`.
#pragma once

#include <string>

#include "ocean/ocean.hpp"

namespace ocean::app {

/// Returns a description of the sea in the quantities of oceanography; `source` is its name.
std::string info_text(const Sea& sea, const std::string& source, const SeaState& state,
                      const FrameCost& cost);

}  // namespace ocean::app
