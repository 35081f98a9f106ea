// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a file is recognised by its content, and one of another kind is refused with the reason.
#include "window/opened_file.hpp"

#include <sys/stat.h>

#include "ocean/channel.hpp"
#include "ocean/io/exr.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrainfile.hpp"
#include "refusal.hpp"
#include "temporary_folder.hpp"

namespace ocean::app {
namespace {

class OpenedFileTest : public testing::Test {
  protected:
    std::string file(const std::string& name, const std::string& content) const {
        std::ofstream(folder_.file(name), std::ios::binary) << content;
        return folder_.file(name);
    }

    const test::TemporaryFolder folder_;
};

TEST_F(OpenedFileTest, ASeaFileIsASea) {
    const OpenedFile opened = read_opened_file(
        file("any.name", "libocean = 1\n[[waves]]\nwind_speed = 7.5\n"), *make_subject(Sea{}));
    EXPECT_FALSE(opened.take_changes);
    EXPECT_EQ(sea_of(*opened.scene).parameters.waves.front().wind_speed, 7.5);
}

TEST_F(OpenedFileTest, ATerrainFileIsATerrain) {
    const OpenedFile opened = read_opened_file(
        file("hills.toml", "libocean = 1\n[terrain]\nkind = \"tile\"\nbeta = 2.25\n"),
        *make_subject(Sea{}));
    ASSERT_EQ(opened.scene->kind(), kTerrainKind);
    EXPECT_EQ(find_terrain(*opened.scene)->beta, 2.25);
}

TEST_F(OpenedFileTest, ATerrainHasNoTake) {
    const std::string path = file("storm.txt", "1.5 wind_speed 12\n");
    EXPECT_EQ(test::message_of([&] { read_opened_file(path, *make_subject(TerrainModel{})); }),
              path + ": is a take, and a terrain has none; open its sea first");
}

TEST_F(OpenedFileTest, ATakeIsForTheShownSea) {
    Sea shown;
    shown.parameters.waves.resize(1);
    shown.parameters.seed = 7;
    const OpenedFile opened = read_opened_file(
        file("storm.txt", "# gusts\n1.5 wind_speed 12\n3 wind_speed 4\n"), *make_subject(shown));
    EXPECT_EQ(opened.take_changes, 2u);
    const Sea& sea = sea_of(*opened.scene);
    EXPECT_EQ(sea.take.events.size(), 2u);
    EXPECT_EQ(sea.parameters.seed, 7u);
}

TEST_F(OpenedFileTest, AWrongFileSaysWhy) {
    const auto says = [&](const std::string& path, const std::string& words) {
        const std::string message =
            test::message_of([&] { read_opened_file(path, *make_subject(Sea{})); });
        EXPECT_TRUE(test::says(message, {words, path}));
    };
    says(folder_.path(), "is a folder");
    says(folder_.file("none"), "no such file");
    says(file("photo.jpg", std::string("\xff\xd8\xff\xe0\0\x10JFIF", 10)), "is none of these");
    says(file("broken.toml", "libocean = 1\n[grid]\nresolution = 100\n"), "allowed");
    says(file("steep.toml", "libocean = 1\n[terrain]\nbeta = 99\n"), "allowed");
    says(file("both.toml", "libocean = 1\n[terrain]\n[grid]\n"),
         "is a sea file, not a terrain file");
    says(file("bad.take", "1 wind_sped 3\n"), "did you mean waves.0.wind_speed?");
    says(file("late.take", "2 wind_speed 3\n1 wind_speed 3\n"), "late.take:2");
    says(file("cut.exr", "\x76\x2f\x31\x01"), "cut.exr");
    says(file("photo.png", "\x89PNG\r\n\x1a\n"), "photo.png");
    says(file("empty.toml", ""), "libocean");
    ::mkfifo(folder_.file("pipe").c_str(), 0600);
    says(folder_.file("pipe"), "is a pipe");
}

}  // namespace
}  // namespace ocean::app
