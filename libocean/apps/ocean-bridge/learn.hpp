// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean-bridge --learn`: prints the map's lines for each control that is moved. No network.
#pragma once

#include "command.hpp"
#include "serve.hpp"

namespace ocean::app {

/// Writes [[device]] and [[map]] to standard output, hints and the boards' events to standard
/// error, until the process is interrupted. Throws Error for options that are wrong, and for a map
/// or a sea that cannot be read.
void learn(const ServeWords& words, const Context& context);

}  // namespace ocean::app
