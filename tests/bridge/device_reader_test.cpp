// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The boards of a control map: each driver has its own keys, and a key of another driver is a
// mistake.
#include <gtest/gtest.h>

#include "ocean/error.hpp"
#include "ocean/internal/bridge/control_map_file.hpp"
#include "ocean/internal/bridge/devices.hpp"
#include "ocean/internal/bridge/firmata_source.hpp"
#include "ocean/internal/bridge/k8055_source.hpp"
#include "ocean/internal/bridge/midi_source.hpp"

namespace ocean::bridge {
namespace {

std::vector<DeviceRule> devices(const std::string& toml) {
    return parse_control_map(toml, "test.toml", ValueTable()).devices;
}

TEST(DeviceReader, EachDriverHasItsKeys) {
    const auto read = devices(R"(
[[device]]
address = 3
driver = "k8055"
id = "board0"
[[device]]
id = "midi0"
driver = "midi"
[[device]]
id = "midi1"
driver = "midi"
port = "nanoKONTROL2"
channel = 16
[[device]]
id = "arduino"
driver = "firmata"
port = "/dev/ttyACM0"
[[device]]
id = "mega"
driver = "firmata"
port = "/dev/ttyUSB0"
baud = 115200
analog = [0, 15]
inputs = [2]
pullups = [3, 4]
outputs = [13]
pwm = [9, 44]
)");
    ASSERT_EQ(read.size(), 5u);
    EXPECT_EQ(read[0].device.get<K8055Device>()->address, 3);
    EXPECT_EQ(read[1].device.get<MidiDevice>()->port, "");
    EXPECT_EQ(read[1].device.get<MidiDevice>()->channel, 0);
    EXPECT_EQ(read[2].device.get<MidiDevice>()->port, "nanoKONTROL2");
    EXPECT_EQ(read[2].device.get<MidiDevice>()->channel, 16);
    EXPECT_EQ(read[3].device.get<FirmataDevice>()->baud, 57600);
    const FirmataDevice& mega = *read[4].device.get<FirmataDevice>();
    EXPECT_EQ(mega.port, "/dev/ttyUSB0");
    EXPECT_EQ(mega.baud, 115200);
    EXPECT_EQ(mega.analog, (std::vector<int>{0, 15}));
    EXPECT_EQ(mega.inputs, (std::vector<int>{2}));
    EXPECT_EQ(mega.pullups, (std::vector<int>{3, 4}));
    EXPECT_EQ(mega.outputs, (std::vector<int>{13}));
    EXPECT_EQ(mega.pwm, (std::vector<int>{9, 44}));
}

struct DeviceMistake {
    std::string keys;  // after the header and the id
    std::string says;
};

class ADevice : public testing::TestWithParam<DeviceMistake> {};

TEST_P(ADevice, ThatIsWrongIsNamedWithItsLine) {
    try {
        devices("[[device]]\nid = \"b\"\n" + GetParam().keys);
        ADD_FAILURE() << "was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::bad_file);
        EXPECT_NE(std::string(error.what()).find(GetParam().says), std::string::npos)
            << error.what();
    }
}

std::string with(const std::string& driver, const std::string& key) {
    const std::string port = driver == "firmata" ? "port = \"/dev/x\"\n" : "# a line\n";
    return "driver = \"" + driver + "\"\n" + port + key + "\n";
}

INSTANTIATE_TEST_SUITE_P(
    Each, ADevice,
    testing::Values(
        DeviceMistake{"", "test.toml:1: driver is missing; allowed: k8055, midi, firmata"},
        DeviceMistake{"driver = \"osc\"", "test.toml:3: driver = \"osc\": allowed: k8055, midi"},
        DeviceMistake{"driver = 5", "test.toml:3: driver = 5: allowed: a text"},
        DeviceMistake{with("k8055", "address = 4"), "test.toml:5: address = 4: allowed: 0 .. 3"},
        DeviceMistake{
            with("k8055", "port = \"x\""),
            "test.toml:5: unknown key 'port' of [[device]]; allowed: id, driver, address"},
        DeviceMistake{with("midi", "address = 1"), "allowed: id, driver, port, channel"},
        DeviceMistake{with("midi", "channel = 0"), "test.toml:5: channel = 0: allowed: 1 .. 16"},
        DeviceMistake{with("midi", "channel = 1.5"), "channel = 1.5: allowed: whole numbers"},
        DeviceMistake{with("midi", "baud = 57600"), "unknown key 'baud'"},
        DeviceMistake{"driver = \"firmata\"", "test.toml:1: port is missing"},
        DeviceMistake{with("firmata", "baud = 31250"),
                      "allowed: 9600, 19200, 38400, 57600, 115200"},
        DeviceMistake{with("firmata", "channel = 1"), "allowed: id, driver, port, baud, analog"},
        DeviceMistake{
            with("firmata", "analog = [16]"),
            "test.toml:5: analog = a list of 1: allowed: a list of whole numbers 0 .. 15"},
        DeviceMistake{with("firmata", "analog = 1"), "analog = 1: allowed: a list"},
        DeviceMistake{with("firmata", "inputs = [2, 2]"), "each once"},
        DeviceMistake{with("firmata", "inputs = [2.5]"), "a list of whole numbers 0 .. 127"},
        DeviceMistake{with("firmata", "pwm = [9]\noutputs = [9]"),
                      "test.toml:1: pin 9 is used twice"},
        DeviceMistake{with("firmata", "pullups = [9]\ninputs = [9]"), "pin 9 is used twice"},
        DeviceMistake{"driver = \"midi\"\n[[device]]\nid = \"b\"\ndriver = \"midi\"",
                      "test.toml:4: id = \"b\" is used twice"}));

/// Settings are compared by type and value: a map that is read again knows if its boards changed.
TEST(DeviceSettings, AreEqualIfTypeAndValueAre) {
    EXPECT_EQ(DeviceSettings(K8055Device{1}), DeviceSettings(K8055Device{1}));
    EXPECT_NE(DeviceSettings(K8055Device{1}), DeviceSettings(K8055Device{2}));
    EXPECT_NE(DeviceSettings(K8055Device{}), DeviceSettings(MidiDevice{}));
    EXPECT_EQ(DeviceSettings(K8055Device{1}).get<MidiDevice>(), nullptr);
}

TEST(MakeSources, RefusesSettingsOfNoDriver) {
    struct Unknown {
        bool operator==(const Unknown&) const = default;
    };
    const std::vector<DeviceRule> rules = {{"x", Unknown{}}};
    EXPECT_THROW(make_sources(rules), Error);
}

}  // namespace
}  // namespace ocean::bridge
