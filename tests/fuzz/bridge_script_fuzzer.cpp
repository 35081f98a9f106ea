// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as the script of a board: lines in order of time with channels and finite values, or
// one Error whose message is safe to print.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/internal/bridge/script_sources.hpp"
#include "require.hpp"

using ocean::fuzz::check_message;
using ocean::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean;
    try {
        double before = 0.0;
        const auto script =
            bridge::parse_script({reinterpret_cast<const char*>(data), size}, "fuzz.txt");
        for (const bridge::ScriptLine& line : script) {
            require(line.seconds >= before && std::isfinite(line.value));
            require(bridge::is_channel_name(line.channel));
            before = line.seconds;
        }
        bridge::make_replay_source(script);
        bridge::make_dummy_source(script);
    } catch (const Error& error) {
        check_message(error.what());
    }
    return 0;
}
