// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean bake --stage`: the stages between the modes and a map, one file for each frame.
#pragma once

#include <string>

#include "command.hpp"
#include "ocean/bake/plan.hpp"

namespace ocean::app {

/// Writes the stage of each frame of the plan as EXR. The plan must be for one product. Throws
/// Error.
void bake_stage(const BakePlan& plan, const std::string& stage, const Context& context);

}  // namespace ocean::app
