// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The table of drivers. A new kind of board is one row here and one source file that defines the
// row's Driver. A row whose file is missing does not link; a file whose row is missing, and a
// Driver without its reader or maker, do not compile.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

#include "ocean/internal/bridge/device.hpp"
#include "ocean/internal/bridge/source.hpp"
#include "section_reader.hpp"

namespace ocean::bridge {

/// Reads a board's settings from its [[device]] and makes sources of boards with such settings.
class Driver {
  public:
    template <typename Settings>
    using Read = Settings (*)(DeviceSection&);
    template <typename Settings>
    using MakeOne = std::unique_ptr<Source> (*)(const std::string& id, const Settings&);
    using MakeAll = std::unique_ptr<Source> (*)(std::span<const DeviceRule>);
    using Sources = std::vector<std::unique_ptr<Source>>;

    /// A driver that makes a source for each board.
    template <typename Settings>
    Driver(Read<Settings> read, MakeOne<Settings> make)
        : read_(read), type_(&typeid(Settings)), make_([make](std::span<const DeviceRule> boards) {
              Sources sources;
              for (const DeviceRule& board : boards) {
                  sources.push_back(make(board.id, *board.device.get<Settings>()));
              }
              return sources;
          }) {}
    /// A driver that makes one source for all of its boards.
    template <typename Settings>
    Driver(Read<Settings> read, MakeAll make)
        : read_(read), type_(&typeid(Settings)), make_([make](std::span<const DeviceRule> boards) {
              Sources sources;
              sources.push_back(make(boards));
              return sources;
          }) {}

    /// Reads all keys but `id` and `driver`. Throws Error bad_file.
    DeviceSettings read(DeviceSection& section) const { return read_(section); }
    bool drives(const DeviceSettings& settings) const { return settings.type() == *type_; }
    /// Makes the sources of `boards`, all of which this driver drives; at least one board is
    /// required. Throws Error unsupported if this build lacks a library that the driver needs.
    Sources make(std::span<const DeviceRule> boards) const { return make_(boards); }

  private:
    std::function<DeviceSettings(DeviceSection&)> read_;
    const std::type_info* type_;
    std::function<Sources(std::span<const DeviceRule>)> make_;
};

/// The rows. ROW(word) is the board of `driver = "word"`, defined by the function
/// `Driver DriverTable::word()` in the board's source file.
#define OCEAN_BRIDGE_DRIVERS(ROW) \
    ROW(k8055)                    \
    ROW(midi)                     \
    ROW(firmata)

struct DriverTable {
#define OCEAN_BRIDGE_DECLARE(word) static Driver word();
    OCEAN_BRIDGE_DRIVERS(OCEAN_BRIDGE_DECLARE)
#undef OCEAN_BRIDGE_DECLARE
};

struct NamedDriver {
    std::string_view name;
    Driver driver;
};

/// Returns all drivers in the order of their rows.
std::span<const NamedDriver> drivers();

}  // namespace ocean::bridge
