// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From reports to values: what a knob's position means, and when it counts. Pure but for what each
// knob remembers; time is that of the reports, so a test needs no clock.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bridge/map_file.hpp"
#include "ocean/bridge/source.hpp"

namespace ocean::bridge {

/// 0 .. 1 to 0 .. 1 with the ends where they were, rising. exp and log bend by two decades.
double curved(Curve curve, double gamma, double x);

/// Returns the steps that a byte of an endless knob says, -64 .. 64, in any of the codes; 0 of what
/// is no byte of 7 bits. Two's complement: 1 is +1, 127 is -1. Binary offset: 65 is +1, 63 is -1.
/// Signed bit, where bit 6 is the sign and the rest the size: 1 is +1, 65 is -1.
int relative_steps(RelativeCode code, double byte);

/// A value that a knob or a button asks for; the channel is its writer.
struct Setting {
    std::size_t entry = 0;  // of the table
    double value = 0.0;
    std::string writer;
};

/// What an output is to be.
struct Lamp {
    std::string channel;
    double value = 0.0;
};

class Mapping {
  public:
    /// Of a map that was parsed for this table.
    Mapping(MapFile file, const ValueTable& values);
    ~Mapping();
    Mapping(Mapping&&) noexcept;
    Mapping& operator=(Mapping&&) noexcept;

    /// The first report of a channel says where it is and sets nothing, so that joining a board
    /// does not change the sea; but a button that was just pressed counts.
    std::vector<Setting> report(const Report& report, const ValueTable& values);
    /// What time alone brings: smoothed values on their way, buttons that have come to rest.
    std::vector<Setting> advance(Clock::time_point now, const ValueTable& values);
    /// When to advance next; nothing while all is still.
    std::optional<Clock::time_point> next() const;

    /// The outputs that are another since the last call.
    std::vector<Lamp> lamps(const ValueTable& values);

    /// A board that came back: its knobs are where they are, which the next reports say; its lamps
    /// are told again.
    void board_connected(std::string_view board);
    /// Whoever held its buttons down holds them no more.
    std::vector<Setting> board_lost(std::string_view board);

  private:
    class Knob;
    class Button;
    class Counter;
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ocean::bridge
