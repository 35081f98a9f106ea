// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "device_reader.hpp"

#include <algorithm>
#include <set>

#include "ocean/bridge/source.hpp"
#include "section_reader.hpp"

namespace ocean::bridge {
namespace {

class DeviceReader : private SectionReader {
  public:
    using SectionReader::SectionReader;

    DeviceRule device(const std::vector<DeviceRule>& before) {
        DeviceRule rule;
        const bool has_driver = find_driver(rule);
        while (next()) {
            if (key() == "id") {
                rule.id = id();
            } else if (key() != "driver") {
                std::visit([this](auto& device) { take_key(device); }, rule.device);
            }
        }
        if (rule.id.empty()) throw fail("id is missing");
        if (!has_driver) throw fail("driver is missing; allowed: k8055, midi, firmata");
        if (std::ranges::find(before, rule.id, &DeviceRule::id) != before.end()) {
            throw fail("id = \"" + rule.id + "\" is there twice");
        }
        std::visit([this](const auto& device) { check(device); }, rule.device);
        return rule;
    }

  private:
    /// A board as it is without further keys; all others depend on which it is.
    bool find_driver(DeviceRule& rule) {
        while (next()) {
            if (key() != "driver") continue;
            rule.device = driver();
            rewind();
            return true;
        }
        rewind();
        return false;
    }
    decltype(DeviceRule::device) driver() const {
        if (text() == "k8055") return K8055Device{};
        if (text() == "midi") return MidiDevice{};
        if (text() == "firmata") return FirmataDevice{};
        throw refused("k8055, midi, firmata");
    }

    std::string id() const {
        if (is_channel_name(text() + "/a1")) return text();
        throw refused("small letters, digits and '_', such as board0");
    }

    void take_key(K8055Device& device) const {
        if (key() != "address") throw unknown("id, driver, address");
        device.address = whole(0, kK8055Addresses - 1);
    }

    void take_key(MidiDevice& device) const {
        if (key() == "port") {
            device.port = text();
        } else if (key() == "channel") {
            device.channel = whole(1, 16);
        } else {
            throw unknown("id, driver, port, channel");
        }
    }

    void take_key(FirmataDevice& device) const {
        if (key() == "port") {
            device.port = text();
        } else if (key() == "baud") {
            device.baud = baud();
        } else if (key() == "analog") {
            device.analog = whole_list(0, kFirmataAnalogs - 1);
        } else if (key() == "inputs") {
            device.inputs = pins();
        } else if (key() == "pullups") {
            device.pullups = pins();
        } else if (key() == "outputs") {
            device.outputs = pins();
        } else if (key() == "pwm") {
            device.pwm = pins();
        } else {
            throw unknown("id, driver, port, baud, analog, inputs, pullups, outputs, pwm");
        }
    }
    std::vector<int> pins() const { return whole_list(0, kFirmataPins - 1); }
    int baud() const {
        const int baud = whole(0, 1'000'000);
        if (std::ranges::find(kFirmataBauds, baud) != kFirmataBauds.end()) return baud;
        std::string allowed;
        for (const int each : kFirmataBauds) {
            allowed += (allowed.empty() ? "" : ", ") + std::to_string(each);
        }
        throw refused(allowed);
    }

    void check(const K8055Device&) const {}
    void check(const MidiDevice&) const {}
    void check(const FirmataDevice& device) const {
        if (device.port.empty()) throw fail("port is missing; allowed: such as /dev/ttyACM0");
        std::set<int> seen;
        for (const auto* pins : {&device.inputs, &device.pullups, &device.outputs, &device.pwm}) {
            for (const int pin : *pins) {
                if (seen.insert(pin).second) continue;
                throw fail("pin " + std::to_string(pin) +
                           " is there twice; allowed: one of inputs, pullups, outputs and pwm");
            }
        }
    }
};

}  // namespace

DeviceRule read_device(const TomlSection& section, const std::string& file,
                       const std::vector<DeviceRule>& before) {
    return DeviceReader(section, file).device(before);
}

}  // namespace ocean::bridge
