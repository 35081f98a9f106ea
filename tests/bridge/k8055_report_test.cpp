// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bytes of a K8055, written out as its protocol has them.
#include "k8055_report.hpp"

#include <gtest/gtest.h>

#include "ocean/internal/bridge/k8055_source.hpp"

namespace ocean::bridge {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(K8055Report, HasKnobsButtonsAndCounters) {
    // Digital inputs 1 .. 5 are the bits 4, 5, 0, 6, 7; counters are sent low byte first.
    EXPECT_EQ(decode_k8055_report(Bytes{0x00, 1, 0, 255, 0, 0, 0, 0}),
              (K8055Inputs{0, 255, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(decode_k8055_report(Bytes{0x10, 1, 128, 3, 0x34, 0x12, 0xff, 0xff}),
              (K8055Inputs{128, 3, 1, 0, 0, 0, 0, 0x1234, 65535}));
    EXPECT_EQ(decode_k8055_report(Bytes{0x20, 4, 0, 0, 0xff, 0x7f, 0x00, 0x80}),
              (K8055Inputs{0, 0, 0, 1, 0, 0, 0, 32767, 32768}));
    EXPECT_EQ(decode_k8055_report(Bytes{0x01, 1, 0, 0, 0, 0, 0, 0}),
              (K8055Inputs{0, 0, 0, 0, 1, 0, 0, 0, 0}));
    EXPECT_EQ(decode_k8055_report(Bytes{0xc0, 1, 0, 0, 0, 0, 0, 0}),
              (K8055Inputs{0, 0, 0, 0, 0, 1, 1, 0, 0}));
    // Bits that mean nothing mean nothing.
    EXPECT_EQ(decode_k8055_report(Bytes{0x0e, 1, 0, 0, 0, 0, 0, 0}), K8055Inputs{});
}

TEST(K8055Report, OfAnotherLengthIsNone) {
    EXPECT_FALSE(decode_k8055_report(Bytes{}));
    EXPECT_FALSE(decode_k8055_report(Bytes(7, 0)));
    EXPECT_FALSE(decode_k8055_report(Bytes(9, 0)));
}

TEST(K8055Report, TellsAllOutputsAtOnce) {
    using Report = std::array<std::uint8_t, kK8055Bytes>;
    EXPECT_EQ(encode_k8055_outputs({}), (Report{5, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(encode_k8055_outputs({1, 0, 1, 0, 0, 1, 0, 1, 12, 34}),
              (Report{5, 0xa5, 12, 34, 0, 0, 0, 0}));
    EXPECT_EQ(encode_k8055_outputs({0, 1, 0, 1, 1, 0, 1, 0, 255, 1}),
              (Report{5, 0x5a, 255, 1, 0, 0, 0, 0}));
}

TEST(K8055Report, HasTheChannelsInTheirOrder) {
    const std::vector<Channel> channels = k8055_channels("left");
    ASSERT_EQ(channels.size(), K8055Inputs{}.size() + K8055Outputs{}.size());
    const std::vector<std::string> inputs = {"a1", "a2", "d1", "d2", "d3", "d4", "d5", "c1", "c2"};
    for (std::size_t i = 0; i < channels.size(); ++i) {
        EXPECT_EQ(channels[i].output, i >= inputs.size());
        EXPECT_TRUE(is_channel_name(channels[i].name));
    }
    for (std::size_t i = 0; i < inputs.size(); ++i)
        EXPECT_EQ(channels[i].name, "left/" + inputs[i]);
    EXPECT_EQ(channels[inputs.size()].name, "left/o1");
    EXPECT_EQ(channels.back().name, "left/dac2");
}

}  // namespace
}  // namespace ocean::bridge
