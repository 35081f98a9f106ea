// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The map: which channel turns what, and which value lights which lamp. As a file, TOML:
//   [[map]] from = "board0/a1"  to = "wind_speed"  in = [4, 251]  out = [0, 30]  ...
//   [[out]] from = "app.frame_rate"  to = "board0/dac1"  in = [0, 120]  out = [0, 255]
// libocean/bridge/PROTOCOL.md has all keys.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bridge/value_table.hpp"

namespace ocean::bridge {

enum class Mode { range, toggle, momentary, trigger };
enum class Curve { linear, smoothstep, exp, log, gamma };
enum class Takeover { jump, pickup, scale };
enum class Edge { rise, fall };

/// One knob or button. What is in units of the board has those of `in`.
struct MapRule {
    std::string from;
    std::string to;  // the table's name
    Mode mode = Mode::range;
    std::array<double, 2> in = {0.0, 255.0};
    std::array<double, 2> out = {0.0, 1.0};
    Curve curve = Curve::linear;
    double gamma = 1.0;
    bool invert = false;
    double deadzone = 0.0;    // this much on either side of the middle is the middle
    double hysteresis = 2.0;  // a smaller step of a knob at rest is noise: 1 either way
    double smoothing = 0.0;   // s, of the one-pole filter
    Takeover takeover = Takeover::jump;
    Edge edge = Edge::rise;
    double debounce = 0.02;  // s
};

struct OutRule {
    std::string from;  // the table's name
    std::string to;
    std::array<double, 2> in = {0.0, 1.0};
    std::array<double, 2> out = {0.0, 255.0};
};

struct MapFile {
    std::vector<MapRule> maps;
    std::vector<OutRule> outs;
};

inline constexpr std::size_t kMostRules = 256;

/// Names and ranges are those of the table. Throws Error bad_file "NAME:LINE: key = value: what is
/// wrong; allowed: ...".
MapFile parse_map(std::string_view toml, const std::string& name, const ValueTable& values);
/// The same from a file of at most 1 MiB.
MapFile read_map(const std::string& path, const ValueTable& values);

/// What a board does to which nobody gave a map: a1 is wind_speed, a2 choppiness, d1 app.pause, d2
/// app.record.
extern const std::string_view kDefaultMap;

}  // namespace ocean::bridge
