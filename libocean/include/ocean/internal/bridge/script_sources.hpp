// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Boards that are files: the dummy board, which stands in for hardware, and the replay of a
// recorded board.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

/// The value of a channel at a time after the start.
struct ScriptLine {
    double seconds = 0.0;
    std::string channel;
    double value = 0.0;
};

/// Parses lines "SECONDS CHANNEL VALUE" in order of time; '#' begins a comment. Throws Error
/// bad_file "NAME:LINE: ...".
std::vector<ScriptLine> parse_script(std::string_view text, const std::string& name);
/// Reads a script from a file of at most 16 MiB. Throws Error bad_file.
std::vector<ScriptLine> read_script(const std::string& path);

/// Makes the board "board0" with the channels of a Velleman K8055 (k8055_source.hpp). All inputs
/// are 0 until the script or put() moves them: put() sets inputs of this board, too. Throws Error
/// bad_file for a script with another channel or a value out of its range.
std::unique_ptr<Source> make_dummy_source(std::vector<ScriptLine> script = {});
/// Makes a board whose inputs are the channels that the script names. It has no outputs.
std::unique_ptr<Source> make_replay_source(std::vector<ScriptLine> script);

}  // namespace ocean::bridge
