// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The file of a control map: the boards, the channels that set values, and the values that drive
// outputs. TOML:
//   [[device]] id = "board0"  driver = "k8055"  address = 0
//   [[map]] from = "board0/a1"  to = "wind_speed"  in = [4, 251]  out = [0, 30]  ...
//   [[out]] from = "app.frame_rate"  to = "board0/dac1"  in = [0, 120]  out = [0, 255]
// libocean/bridge/PROTOCOL.md documents all keys.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/bridge/device.hpp"
#include "ocean/internal/bridge/value_table.hpp"

namespace ocean::bridge {

enum class Mode { range, toggle, momentary, trigger, increment, relative };
enum class Curve { linear, smoothstep, exp, log, gamma };
enum class Takeover { jump, pickup, scale };
enum class Edge { rise, fall };
/// The encoding by which a MIDI controller of 7 bits reports the steps of an endless knob.
enum class RelativeCode { twos_complement, binary_offset, signed_bit };

/// A [[map]]: one knob, button or counter. `in`, deadzone and hysteresis are in units of the board.
struct ControlRule {
    std::string from;
    std::string to;  // name in the value table
    Mode mode = Mode::range;
    std::array<double, 2> in = {0.0, 255.0};
    std::array<double, 2> out = {0.0, 1.0};
    Curve curve = Curve::linear;
    double gamma = 1.0;
    bool invert = false;
    double deadzone = 0.0;    // on either side of the middle of `in`, this far counts as the middle
    double hysteresis = 2.0;  // a smaller step of a knob at rest is noise
    double smoothing = 0.0;   // time constant of the one-pole filter [s]
    Takeover takeover = Takeover::jump;
    Edge edge = Edge::rise;
    double debounce = 0.02;  // [s]
    RelativeCode code = RelativeCode::twos_complement;
    double step = 1.0;  // of the value, per count of increment or step of relative
    bool wrap = false;  // out[1] is out[0] again, as 360 degrees are 0
};

/// An [[out]]: a value that drives an output.
struct OutRule {
    std::string from;  // name in the value table
    std::string to;
    std::array<double, 2> in = {0.0, 1.0};
    std::array<double, 2> out = {0.0, 255.0};
};

struct ControlMapFile {
    std::vector<DeviceRule> devices;
    std::vector<ControlRule> maps;
    std::vector<OutRule> outs;
};

inline constexpr std::size_t kMaxRules = 256;

/// Parses a control map. `values` gives the names and their ranges. Throws Error bad_file
/// "NAME:LINE: key = value: reason; allowed: ...".
ControlMapFile parse_control_map(std::string_view toml, const std::string& name,
                                 const ValueTable& values);
/// Reads the text of a file of at most 1 MiB. Throws Error bad_file.
std::string read_map_text(const std::string& path);

/// The control map of a bridge without --map: a1 is wind_speed, a2 choppiness, d1 app.pause, d2
/// app.record.
extern const std::string_view kDefaultMap;

}  // namespace ocean::bridge
