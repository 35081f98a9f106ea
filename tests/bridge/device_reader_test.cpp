// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The boards of a control map: each driver has its own keys, and a key of another driver is a
// mistake.
#include "mistakes.hpp"
#include "ocean/internal/bridge/control_map_file.hpp"
#include "ocean/internal/bridge/devices.hpp"
#include "ocean/internal/bridge/firmata_source.hpp"
#include "ocean/internal/bridge/k8055_source.hpp"
#include "ocean/internal/bridge/midi_source.hpp"
#include "refusal.hpp"

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

class ADevice : public testing::TestWithParam<ocean::test::Mistake> {};

TEST_P(ADevice, ThatIsWrongIsNamedWithItsLine) {
    ocean::test::expect_refusal(ErrorKind::bad_file, GetParam().says,
                                [] { devices("[[device]]\nid = \"b\"\n" + GetParam().text); });
}

INSTANTIATE_TEST_SUITE_P(Each, ADevice,
                         testing::ValuesIn(ocean::test::mistakes("bridge/mistakes.toml",
                                                                 "devices")));

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
