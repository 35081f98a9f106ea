// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean-bridge --learn`: the boards without a network, and the map's lines for what a hand moves.
#pragma once

#include "command.hpp"
#include "serve.hpp"

namespace ocean::app {

/// Writes [[device]] and [[map]] to standard output, hints and the boards' events to standard
/// error, until the process is interrupted. Throws Error.
void learn(const ServeWords& words, const Context& context);

}  // namespace ocean::app
