// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Open Sound Control as bytes, against those that its specification writes out: both ways, and what
// no sender should send.
#include "osc_message.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "mistakes.hpp"
#include "refusal.hpp"

namespace ocean::bridge {
namespace {

using ocean::test::Mistake;
using ocean::test::mistakes;

template <std::size_t size>
std::string bytes(const char (&text)[size]) {
    return {text, size - 1};
}

// [OSC 1.0] "OSC Message Examples".
const std::string kOscillator = bytes("/oscillator/4/frequency\0,f\0\0\x43\xdc\0\0");
const std::string kFoo = bytes(
    "/foo\0\0\0\0,"
    "iisff\0\0\0\0\x03\xe8\xff\xff\xff\xffhello\0\0\0\x3f\x9d\xf3\xb6\x40\xb5\xb2\x2d");

std::string bundle_of(const std::vector<std::string>& elements) {
    std::string bundle = bytes("#bundle\0\0\0\0\0\0\0\0\1");
    for (const std::string& element : elements) {
        bundle += '\0';
        bundle += static_cast<char>(element.size() >> 16);
        bundle += static_cast<char>(element.size() >> 8 & 0xFF);
        bundle += static_cast<char>(element.size() & 0xFF);
        bundle += element;
    }
    return bundle;
}

std::vector<OscMessage> messages_of(const std::string& packet) {
    return parse_osc_packet(packet).messages;
}

std::string packet_refusal(const std::string& packet) {
    return ocean::test::message_of([&] { parse_osc_packet(packet); });
}

TEST(OscMessage, TheSpecificationsExamplesAreReadAndWritten) {
    const auto oscillator = messages_of(kOscillator);
    ASSERT_EQ(oscillator.size(), 1u);
    EXPECT_EQ(oscillator[0].address, "/oscillator/4/frequency");
    ASSERT_EQ(oscillator[0].arguments.size(), 1u);
    EXPECT_EQ(oscillator[0].arguments[0], OscArgument(440.0f));
    EXPECT_EQ(osc_packet(oscillator[0]), kOscillator);
    const auto foo = messages_of(kFoo);
    ASSERT_EQ(foo.size(), 1u);
    const std::vector<OscArgument> arguments = {std::int64_t{1000}, std::int64_t{-1},
                                                std::string("hello"), 1.234f, 5.678f};
    EXPECT_EQ(foo[0].arguments, arguments);
    EXPECT_EQ(osc_packet(foo[0]), kFoo);
}

TEST(OscMessage, EachTypeThatIsTaken) {
    const auto messages =
        messages_of(bytes("/a\0\0,hdSTF\0\0\0\0\0\1\0\0\0\0\xbf\xe0\0\0\0\0\0\0four\0\0\0\0"));
    ASSERT_EQ(messages.size(), 1u);
    const std::vector<OscArgument> expected = {std::int64_t{1} << 32, -0.5, std::string("four"),
                                               true, false};
    EXPECT_EQ(messages[0].arguments, expected);
    // `S` comes back as `s`, and is the same.
    EXPECT_EQ(messages_of(osc_packet(messages[0]))[0].arguments, expected);
}

TEST(OscMessage, NoArgumentsWithAndWithoutTypes) {
    for (const std::string& packet :
         {bytes("/ocean/fetch\0\0\0\0,\0\0\0"), bytes("/ocean/fetch\0\0\0\0")}) {
        const auto messages = messages_of(packet);
        ASSERT_EQ(messages.size(), 1u);
        EXPECT_EQ(messages[0].address, "/ocean/fetch");
        EXPECT_TRUE(messages[0].arguments.empty());
    }
}

TEST(OscMessage, BundlesAreReadInTheirOrderAndWritten) {
    const std::string packet =
        bundle_of({kFoo, bundle_of({kOscillator, bundle_of({})}), kOscillator});
    const auto messages = messages_of(packet);
    ASSERT_EQ(messages.size(), 3u);
    EXPECT_EQ(messages[0].address, "/foo");
    EXPECT_EQ(messages[1].address, "/oscillator/4/frequency");
    EXPECT_EQ(osc_bundles(messages),
              std::vector<std::string>{bundle_of({kFoo, kOscillator, kOscillator})});
    EXPECT_TRUE(osc_bundles({}).empty());
}

/// A packet that is larger than a network's piece is lost when any piece of it is.
TEST(OscMessage, ManyMessagesAreMoreThanOneBundle) {
    const std::vector<OscMessage> many(100, {"/ocean/a/name/of/thirty/bytes", {1.0f}});
    const auto bundles = osc_bundles(many);
    EXPECT_EQ(bundles.size(), 4u);
    std::size_t messages = 0;
    for (const std::string& bundle : bundles) {
        EXPECT_LE(bundle.size(), 1400u);
        messages += messages_of(bundle).size();
    }
    EXPECT_EQ(messages, many.size());
}

TEST(OscMessage, BrokenBytesAreRefused) {
    std::vector<Mistake> packets = mistakes("bridge/mistakes.toml", "osc");
    packets.insert(
        packets.end(),
        {
            {bytes("/a\0\0,") + std::string(17, 'T') + bytes("\0\0"), "too many arguments"},
            {'/' + std::string(258, 'a') + bytes("\0,\0\0\0"), "not a message"},
            {bytes("/a\0\0,s\0\0") + std::string(1025, 'a') + bytes("\0\0\0"), "too long"},
            {bundle_of({}) + bytes("\0\0\0\4"), "do not fit"},
            {bundle_of({}) + bytes("\xff\xff\xff\xfc/a\0\0"), "do not fit"},
            {bundle_of({}) + bytes("\0\0\0\3/a\0\0"), "do not fit"},
            {bundle_of(std::vector<std::string>(257, bytes("abc\0"))), "too many messages"},
            {bundle_of({bundle_of(std::vector<std::string>(300, bytes("/a\0\0")))}),
             "too many messages"},
            {bundle_of(std::vector<std::string>(257, bytes("/a\0\0"))), "too many messages"},
        });
    for (const auto& [packet, says] : packets) {
        EXPECT_NE(packet_refusal(packet).find(says), std::string::npos)
            << testing::PrintToString(packet) << ": " << packet_refusal(packet);
    }
}

/// A packet of 60 kB could hold three thousand bundles in each other.
TEST(OscMessage, BundlesInBundlesHaveAnEnd) {
    std::string packet = kFoo;
    for (int depth = 0; depth < kMaxOscBundleDepth; ++depth) packet = bundle_of({packet});
    EXPECT_EQ(messages_of(packet).size(), 1u);
    EXPECT_EQ(parse_osc_packet(bundle_of({packet})).left_out,
              (std::vector<std::string>{"its bundles are nested too deeply"}));
    // The stack is safe from the deepest that a packet can hold.
    for (int depth = 0; depth < 3000; ++depth) packet = bundle_of({packet});
    EXPECT_TRUE(messages_of(packet).empty());
}

/// Blobs and messages of any type do not affect the sea's own: an element has its own size.
TEST(OscMessage, WhatABundleHasForOthersIsLeftOutAlone) {
    const std::string time = bytes("\x83\xaa\x7e\x80\0\0\0\0");
    std::vector<Mistake> foreign = mistakes("bridge/mistakes.toml", "foreign");
    foreign.insert(
        foreign.end(),
        {
            {bytes("/p\0\0,t\0\0") + time, "the types t; allowed"},
            {bytes("/p\0\0,") + std::string(18, 'f') + '\0' + std::string(72, '\0'), "too many"},
            {'/' + std::string(258, 'a') + bytes("\0,\0\0\0"), "not a message of OSC"},
            {bundle_of({kFoo}) + bytes("\0\0\0\x40/a\0\0"), "do not fit"},
            {bundle_of({kFoo}) + bytes("\xff\xff\xff\xfc"), "do not fit"},
        });
    std::vector<std::string> all;
    for (const auto& [element, says] : foreign) {
        for (const std::string& packet :
             {bundle_of({element, kOscillator}), bundle_of({kOscillator, element}),
              bundle_of({bundle_of({element, kOscillator})}),
              bundle_of({bundle_of({element}), bundle_of({kOscillator})})}) {
            const OscPacket read = parse_osc_packet(packet);
            ASSERT_EQ(read.messages.size(), 1u) << testing::PrintToString(element);
            EXPECT_EQ(osc_packet(read.messages[0]), kOscillator);
            ASSERT_EQ(read.left_out.size(), 1u);
            EXPECT_NE(read.left_out[0].find(says), std::string::npos) << read.left_out[0];
        }
        all.push_back(element);
        all.push_back(kFoo);
    }
    const OscPacket read = parse_osc_packet(bundle_of(all));
    EXPECT_EQ(read.messages.size(), foreign.size());
    EXPECT_EQ(read.left_out.size(), foreign.size());
}

TEST(OscMessage, EveryPieceOfAPacketIsRefusedOrRead) {
    const std::string packet = bundle_of({kFoo, kOscillator});
    for (std::size_t size = 0; size < packet.size(); ++size) {
        // In memory of its own, where a sanitizer sees each byte behind it.
        const std::string piece = packet.substr(0, size);
        EXPECT_TRUE(size == 16 || size == 20 + kFoo.size() || !packet_refusal(piece).empty())
            << size;
    }
}

TEST(OscMessage, AnArgumentIsAValueAsPeopleWriteIt) {
    EXPECT_EQ(osc_text(0.1f), "0.1");
    EXPECT_EQ(osc_text(300000.0f), "300000");
    EXPECT_EQ(osc_text(-1.25), "-1.25");
    EXPECT_EQ(osc_text(512.0f), "512");
    EXPECT_EQ(osc_text(std::int64_t{4294967295}), "4294967295");
    EXPECT_EQ(osc_text(true), "1");
    EXPECT_EQ(osc_text(false), "0");
    EXPECT_EQ(osc_text(std::string("jonswap")), "jonswap");
    EXPECT_EQ(osc_text(std::numeric_limits<float>::infinity()), "inf");
    EXPECT_EQ(osc_text(std::numeric_limits<float>::quiet_NaN()), "nan");
}

TEST(OscMessage, AddressesAreNamesWithSlashes) {
    EXPECT_EQ(osc_name("/ocean/wind_speed"), "wind_speed");
    EXPECT_EQ(osc_name("/ocean/waves/0/wind_speed"), "waves.0.wind_speed");
    EXPECT_EQ(osc_name("/ocean/waves.0.wind_speed"), "waves.0.wind_speed");
    EXPECT_EQ(osc_name("/sea/wind_speed"), std::nullopt);
    EXPECT_EQ(osc_name("/ocean"), std::nullopt);
    EXPECT_EQ(osc_address("app.pause"), "/ocean/app/pause");
}

}  // namespace
}  // namespace ocean::bridge
