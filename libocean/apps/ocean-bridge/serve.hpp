// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean-bridge` as a server.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "ocean/internal/bridge/source.hpp"
#include "ocean/sea.hpp"
#include "subject_argument.hpp"

namespace ocean::app {

struct ServeWords {
    SubjectArgument sea;
    std::string map;
    std::optional<std::string> dummy;  // "" for no script
    std::string replay;
    std::optional<std::string> learn;  // "" for the default names
    std::string listen = "127.0.0.1:4747";
    std::string token_file;
    int clients = 64;
    std::string osc;  // "" for no OSC
    std::vector<std::string> osc_allow;
    std::vector<std::string> osc_to;
};

/// Returns the boards that are files: --dummy and --replay. Throws Error bad_file.
std::vector<std::unique_ptr<bridge::Source>> file_sources(const ServeWords& words);
/// Returns the sea that the command line names, or the default sea. Throws Error.
Sea sea_of(const ServeWords& words);

/// Serves boards and clients until the process is interrupted; never returns. Throws Error.
void serve(const ServeWords& words, const std::string& token, const Context& context);

}  // namespace ocean::app
