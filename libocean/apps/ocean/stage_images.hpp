// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean bake --stage`: what lies between the modes and a map, a file a frame.
#pragma once

#include <string>

#include "command.hpp"
#include "ocean/bake/plan.hpp"

namespace ocean::app {

/// Writes the stage of each frame of the plan, which was made for one product, as EXR. Throws
/// Error.
void bake_stage(const BakePlan& plan, const std::string& stage, const Context& context);

}  // namespace ocean::app
