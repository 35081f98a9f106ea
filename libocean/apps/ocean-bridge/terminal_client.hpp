// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The terminal client: lines are typed with an editor and its history, live values appear above.
#pragma once

#include <string>

#include "command.hpp"
#include "ocean/internal/bridge/endpoint.hpp"

namespace ocean::app {

/// Runs until QUIT, the end of standard input or an interrupt. Throws Error output if standard
/// input is a pipe and no bridge answers.
void run_terminal_client(const bridge::Endpoint& server, const std::string& token,
                         const Context& context);

}  // namespace ocean::app
