// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What `ocean info` prints for people.
#pragma once

#include <string>

#include "ocean/ocean.hpp"

namespace ocean::app {

/// Lines of what `sea` is, in the numbers that wave people use; `source` is its name.
std::string info_text(const Sea& sea, const std::string& source, const SeaState& state,
                      const FrameCost& cost);

}  // namespace ocean::app
