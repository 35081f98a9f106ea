// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Packed files unpack whole or are refused: damage is never a shorter spectrum. The packed bytes
// were made by `printf 'waves\n' | gzip -n9 | xxd -i`.
#include "gzip.hpp"

#include "helpers.hpp"

namespace ocean::test {
namespace {

constexpr unsigned char kWaves[] = {0x1f, 0x8b, 0x08, 0x00, 0x00, 0x00, 0x00, 0x00, 0x02,
                                    0x03, 0x2b, 0x4f, 0x2c, 0x4b, 0x2d, 0xe6, 0x02, 0x00,
                                    0x87, 0xf7, 0x38, 0xe7, 0x06, 0x00, 0x00, 0x00};

std::string packed() {
    return {reinterpret_cast<const char*>(kWaves), sizeof kWaves};
}

Refusal refused(const std::string& bytes, std::size_t limit = 1000) {
    return refusal_of([&] { gunzip(bytes, "b.gz", limit); });
}

TEST(Gzip, UnpacksAllMembersAndIgnoresPadding) {
    EXPECT_TRUE(is_gzip(packed()));
    EXPECT_FALSE(is_gzip("#YY MM"));
    EXPECT_EQ(gunzip(packed(), "b.gz", 1000), "waves\n");
    EXPECT_EQ(gunzip(packed() + packed(), "b.gz", 1000), "waves\nwaves\n");
    EXPECT_EQ(gunzip(packed() + std::string(512, '\0'), "b.gz", 1000), "waves\n");
}

TEST(Gzip, EveryCutIsSaidToBeCutOff) {
    for (std::size_t length = 2; length < sizeof kWaves; ++length) {
        const Refusal refusal = refused(packed().substr(0, length));
        EXPECT_TRUE(refusal.says("b.gz: gzip: the file is cut off")) << length << refusal.message;
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
    }
}

TEST(Gzip, DamageIsFound) {
    for (std::size_t i = 10; i < sizeof kWaves; ++i) {
        if (i == 17) continue;  // unused bits after the end of the block
        std::string bytes = packed();
        bytes[i] = static_cast<char>(bytes[i] ^ 0x10);
        EXPECT_TRUE(refused(bytes).refused) << i;
    }
    EXPECT_TRUE(refused(packed() + "text").says("damaged"));
}

TEST(Gzip, BombsStopAtTheLimit) {
    EXPECT_TRUE(refused(packed(), 5).says("more than"));
    EXPECT_FALSE(refused(packed(), 6).refused);
}

}  // namespace
}  // namespace ocean::test
