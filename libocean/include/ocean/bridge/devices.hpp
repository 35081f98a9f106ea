// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The map's boards as sources.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ocean/bridge/map_file.hpp"
#include "ocean/bridge/source.hpp"

namespace ocean::bridge {

/// What a bridge looks for that nobody told of boards: a K8055 at each of its addresses, board0 ..
/// board3. None in a build without libusb.
std::vector<DeviceRule> usual_devices();

/// Those, and the first MIDI controller, midi0, for a bridge that learns a map. A build without the
/// library of a board leaves that out.
std::vector<DeviceRule> devices_to_learn();

/// One source or several; none of them has looked for its board yet. Throws Error unsupported for a
/// driver that this build is without.
std::vector<std::unique_ptr<Source>> make_sources(std::span<const DeviceRule> devices);

}  // namespace ocean::bridge
