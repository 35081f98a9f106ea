// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Boards that are files: the dummy board, by which everything works without hardware, and the
// replay of what a board reported.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bridge/source.hpp"

namespace ocean::bridge {

/// What a channel is at a time after the start.
struct ScriptLine {
    double seconds = 0.0;
    std::string channel;
    double value = 0.0;
};

/// Lines "SECONDS CHANNEL VALUE" in order of time; '#' begins a comment. Throws Error bad_file
/// "NAME:LINE: ...".
std::vector<ScriptLine> parse_script(std::string_view text, const std::string& name);
/// The same from a file of at most 16 MiB.
std::vector<ScriptLine> read_script(const std::string& path);

/// The board "board0" with the channels of a Velleman K8055: knobs a1, a2 (0 .. 255), buttons d1 ..
/// d5, counters c1, c2; lamps o1 .. o8 and voltages dac1, dac2. All are 0 and still until the
/// script or put() says otherwise, and put() moves its knobs too.
std::unique_ptr<Source> make_dummy_source(std::vector<ScriptLine> script = {});
/// The channels that the script names, all inputs.
std::unique_ptr<Source> make_replay_source(std::vector<ScriptLine> script);

}  // namespace ocean::bridge
