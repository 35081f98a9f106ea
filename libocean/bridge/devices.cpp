// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/devices.hpp"

#include <utility>

#include "ocean/bridge/firmata_source.hpp"
#include "ocean/bridge/k8055_source.hpp"
#include "ocean/bridge/midi_source.hpp"

namespace ocean::bridge {

std::vector<DeviceRule> usual_devices() {
    std::vector<DeviceRule> devices;
#ifdef OCEAN_HAVE_LIBUSB
    for (int address = 0; address < kK8055Addresses; ++address) {
        devices.push_back({"board" + std::to_string(address), K8055Device{address}});
    }
#endif
    return devices;
}

std::vector<DeviceRule> devices_to_learn() {
    std::vector<DeviceRule> devices = usual_devices();
#ifdef OCEAN_HAVE_RTMIDI
    devices.push_back({"midi0", MidiDevice{}});
#endif
    return devices;
}

std::vector<std::unique_ptr<Source>> make_sources(std::span<const DeviceRule> devices) {
    std::vector<std::unique_ptr<Source>> sources;
    std::vector<K8055Board> k8055_boards;  // one thread of libusb serves them all
    for (const DeviceRule& rule : devices) {
        if (const auto* k8055 = std::get_if<K8055Device>(&rule.device)) {
            k8055_boards.push_back({rule.id, *k8055});
        } else if (const auto* midi = std::get_if<MidiDevice>(&rule.device)) {
            sources.push_back(make_midi_source(rule.id, *midi));
        } else {
            sources.push_back(make_firmata_source(rule.id, std::get<FirmataDevice>(rule.device)));
        }
    }
    if (!k8055_boards.empty()) sources.push_back(make_k8055_source(std::move(k8055_boards)));
    return sources;
}

}  // namespace ocean::bridge
