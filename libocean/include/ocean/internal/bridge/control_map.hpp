// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Turns reports of controls into values: the meaning of a knob's position, and the moment at which
// it counts. A pure state machine: reports bring their own time, so a test needs no clock.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/bridge/control_map_file.hpp"
#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

/// Maps 0 .. 1 to 0 .. 1, rising, with the ends fixed. exp and log bend by two decades.
double curved(Curve curve, double gamma, double x);

/// Returns the steps that one byte of an endless knob encodes, -64 .. 64, or 0 for a value that is
/// not a byte of 7 bits. Two's complement: 1 is +1, 127 is -1. Binary offset: 65 is +1, 63 is -1.
/// Signed bit (bit 6 is the sign, the rest the size): 1 is +1, 65 is -1.
int relative_steps(RelativeCode code, double byte);

/// A value that a control requests. The channel is its writer.
struct Setting {
    std::size_t entry = 0;  // of the table
    double value = 0.0;
    std::string writer;
};

/// A value that an output of a board shall have.
struct OutputValue {
    std::string channel;
    double value = 0.0;
};

class ControlMap {
  public:
    /// `file` must have been parsed with this table.
    ControlMap(ControlMapFile file, const ValueTable& values);
    ~ControlMap();
    ControlMap(ControlMap&&) noexcept;
    ControlMap& operator=(ControlMap&&) noexcept;

    /// Returns the values that a report requests. The first report of a channel gives its position
    /// and requests nothing, so that a board which connects does not change the sea; a button that
    /// was just pressed counts.
    std::vector<Setting> report(const Report& report, const ValueTable& values);
    /// Returns the values that change with time alone: smoothed values on their way, and buttons
    /// whose contacts have come to rest.
    std::vector<Setting> advance(Clock::time_point now, const ValueTable& values);
    /// Returns when to call advance(), or nothing while no value is on its way.
    std::optional<Clock::time_point> next() const;

    /// Returns the outputs whose values have changed since the last call.
    std::vector<OutputValue> changed_outputs(const ValueTable& values);

    /// Forgets the positions of the board's controls, which its next reports give, and the values
    /// of its outputs, which changed_outputs() then returns again.
    void board_connected(std::string_view board);
    /// Returns the values of buttons that the lost board can no longer hold down.
    std::vector<Setting> board_lost(std::string_view board);

  private:
    class Knob;
    class Button;
    class Counter;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::bridge
