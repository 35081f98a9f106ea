// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The map: which boards there are, which channel turns what, and which value lights which lamp. As
// a file, TOML:
//   [[device]] id = "board0"  driver = "k8055"  address = 0
//   [[map]] from = "board0/a1"  to = "wind_speed"  in = [4, 251]  out = [0, 30]  ...
//   [[out]] from = "app.frame_rate"  to = "board0/dac1"  in = [0, 120]  out = [0, 255]
// libocean/bridge/PROTOCOL.md has all keys.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ocean/bridge/value_table.hpp"

namespace ocean::bridge {

enum class Mode { range, toggle, momentary, trigger, increment, relative };
enum class Curve { linear, smoothstep, exp, log, gamma };
enum class Takeover { jump, pickup, scale };
enum class Edge { rise, fall };
/// How a MIDI controller of 7 bits says by how much an endless knob was turned.
enum class RelativeCode { twos_complement, binary_offset, signed_bit };

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
    RelativeCode code = RelativeCode::twos_complement;
    double step = 1.0;  // of the value, for a count of increment or a step of relative
    bool wrap = false;  // out[1] is out[0] again, as 360 degrees are 0
};

struct OutRule {
    std::string from;  // the table's name
    std::string to;
    std::array<double, 2> in = {0.0, 1.0};
    std::array<double, 2> out = {0.0, 255.0};
};

/// A Velleman K8055, K8055N or VM110 by the address that its jumpers say.
struct K8055Device {
    int address = 0;
    bool operator==(const K8055Device&) const = default;
};
inline constexpr int kK8055Addresses = 4;

/// A MIDI controller.
struct MidiDevice {
    std::string port;  // a part of the name of its port, in any case; "" = the first that there is
    int channel = 0;   // 1 .. 16, 0 = all
    bool operator==(const MidiDevice&) const = default;
};

/// An Arduino with StandardFirmata.
struct FirmataDevice {
    std::string port;  // "/dev/ttyACM0"
    int baud = 57600;
    std::vector<int> analog;   // inputs A0 ..
    std::vector<int> inputs;   // pins, as are all that follow
    std::vector<int> pullups;  // inputs with the chip's own resistor: 1 while nothing is wired
    std::vector<int> outputs;
    std::vector<int> pwm;
    bool operator==(const FirmataDevice&) const = default;
};
inline constexpr int kFirmataAnalogs = 16;
inline constexpr int kFirmataPins = 128;
inline constexpr std::array kFirmataBauds = {9600, 19200, 38400, 57600, 115200, 230400};

/// A board by the name that its channels begin with.
struct DeviceRule {
    std::string id;
    std::variant<K8055Device, MidiDevice, FirmataDevice> device;
    bool operator==(const DeviceRule&) const = default;
};

struct MapFile {
    std::vector<DeviceRule> devices;
    std::vector<MapRule> maps;
    std::vector<OutRule> outs;
};

inline constexpr std::size_t kMostRules = 256;

/// Names and ranges are those of the table. Throws Error bad_file "NAME:LINE: key = value: what is
/// wrong; allowed: ...".
MapFile parse_map(std::string_view toml, const std::string& name, const ValueTable& values);
/// Of a file of at most 1 MiB.
std::string read_map_text(const std::string& path);

/// What a board does to which nobody gave a map: a1 is wind_speed, a2 choppiness, d1 app.pause, d2
/// app.record.
extern const std::string_view kDefaultMap;

}  // namespace ocean::bridge
