// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a map: one Error whose message is safe to print, or a map by which every report of
// any channel makes values that the table takes.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/internal/bridge/control_map.hpp"
#include "ocean/internal/text.hpp"
#include "require.hpp"

namespace {

using namespace ocean;
using namespace ocean::bridge;
using ocean::fuzz::check_message;
using ocean::fuzz::require;

void set_all(const std::vector<Setting>& settings, ValueTable& values) {
    for (const Setting& setting : settings) {
        require(std::isfinite(setting.value));
        try {
            values.set(setting.entry, setting.value, setting.writer);
        } catch (const Error&) {
            // A rule between parameters, or no whole number.
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const ValueTable start;
    ValueTable values = start;
    ControlMapFile file;
    try {
        file = parse_control_map({reinterpret_cast<const char*>(data), size}, "fuzz.toml", values);
    } catch (const Error& error) {
        check_message(error.what());
        return 0;
    }
    ControlMap map(file, values);
    Clock::time_point now{std::chrono::hours(1)};
    for (const double raw :
         {0.0, 255.0, 128.0, 128.0, 1e9, -1e9, 3.5, 65.0, 127.0, 0.0, 1.0, std::nan(""), 0.0}) {
        for (const ControlRule& rule : file.maps) {
            set_all(map.report({now, rule.from, raw}, values), values);
        }
        for (int i = 0; i < 3; ++i) {
            now += std::chrono::milliseconds(17);
            set_all(map.advance(now, values), values);
        }
        for (const OutputValue& output : map.changed_outputs(values)) {
            require(std::isfinite(output.value));
        }
    }
    return 0;
}
