// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The specialised client: lines typed with an editor and its history, values live above them.
#pragma once

#include <string>

#include "command.hpp"
#include "ocean/bridge/endpoint.hpp"

namespace ocean::app {

/// Until QUIT, the end of standard input or an interrupt. Throws Error.
void run_terminal_client(const bridge::Endpoint& server, const std::string& token,
                         const Context& context);

}  // namespace ocean::app
