// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The boards of a control map as sources.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "ocean/internal/bridge/device.hpp"
#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

/// Returns the boards that a bridge looks for without a [[device]]: a K8055 at each of its
/// addresses, board0 .. board3. Empty in a build without libusb.
std::vector<DeviceRule> default_devices();

/// Returns the boards that a bridge without a map learns from: default_devices() and the first MIDI
/// controller, midi0. A board whose library this build lacks is left out.
std::vector<DeviceRule> devices_to_learn();

/// Makes the sources of all boards, which begin to look for their boards at start(). One source may
/// serve several boards. Throws Error unsupported for a board whose library this build lacks.
std::vector<std::unique_ptr<Source>> make_sources(std::span<const DeviceRule> devices);

}  // namespace ocean::bridge
