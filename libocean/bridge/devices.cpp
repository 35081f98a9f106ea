// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/devices.hpp"

#include <algorithm>
#include <iterator>

#include "drivers.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bridge/k8055_source.hpp"
#include "ocean/internal/bridge/midi_source.hpp"

namespace ocean::bridge {

std::vector<DeviceRule> default_devices() {
    std::vector<DeviceRule> devices;
#ifdef OCEAN_HAVE_LIBUSB
    for (int address = 0; address < kK8055Addresses; ++address) {
        devices.push_back({"board" + std::to_string(address), K8055Device{address}});
    }
#endif
    return devices;
}

std::vector<DeviceRule> devices_to_learn() {
    std::vector<DeviceRule> devices = default_devices();
#ifdef OCEAN_HAVE_RTMIDI
    devices.push_back({"midi0", MidiDevice{}});
#endif
    return devices;
}

std::vector<std::unique_ptr<Source>> make_sources(std::span<const DeviceRule> devices) {
    std::vector<std::unique_ptr<Source>> sources;
    std::size_t driven = 0;
    for (const NamedDriver& row : drivers()) {
        std::vector<DeviceRule> boards;
        std::ranges::copy_if(devices, std::back_inserter(boards), [&](const DeviceRule& rule) {
            return row.driver.drives(rule.device);
        });
        if (boards.empty()) continue;
        driven += boards.size();
        for (auto& source : row.driver.make(boards)) sources.push_back(std::move(source));
    }
    if (driven == devices.size()) return sources;
    throw Error(ErrorKind::unsupported, "a board has settings of no driver of this build");
}

std::span<const NamedDriver> drivers() {
#define OCEAN_BRIDGE_ROW(word) NamedDriver{#word, DriverTable::word()},
    static const NamedDriver kDrivers[] = {OCEAN_BRIDGE_DRIVERS(OCEAN_BRIDGE_ROW)};
#undef OCEAN_BRIDGE_ROW
    return kDrivers;
}

}  // namespace ocean::bridge
