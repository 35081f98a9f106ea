// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: the list has ten files, the newest first and each once; hostile content is harmless, and
// so is a list that cannot be read.
#include "window/recent_files.hpp"

#include <cstdlib>

#include "ocean/error.hpp"
#include "temporary_folder.hpp"
#include "testing.hpp"

namespace ocean::app {
namespace {

namespace fs = std::filesystem;

class RecentFilesTest : public testing::Test {
  protected:
    void write(const std::string& text) const { std::ofstream(list_, std::ios::binary) << text; }

    const test::TemporaryFolder folder_;
    const std::string list_ = folder_.file("state/recent");
};

TEST_F(RecentFilesTest, KeepsTenFilesTheNewestFirst) {
    const RecentFiles recent(list_);
    EXPECT_TRUE(recent.read().empty());
    for (int n = 0; n < 12; ++n) recent.add("/seas/" + std::to_string(n) + ".toml");
    recent.add("/seas/5.toml");
    const std::vector<std::string> files = RecentFiles(list_).read();
    ASSERT_EQ(files.size(), 10u);
    EXPECT_EQ(files[0], "/seas/5.toml");
    EXPECT_EQ(files[1], "/seas/11.toml");
    EXPECT_EQ(files.back(), "/seas/2.toml");
    EXPECT_EQ(std::ranges::count(files, "/seas/5.toml"), 1);
}

TEST_F(RecentFilesTest, ARelativePathIsMadeAbsolute) {
    const RecentFiles recent(list_);
    recent.add("sea.toml");
    EXPECT_EQ(recent.read().front(), (fs::current_path() / "sea.toml").string());
}

TEST_F(RecentFilesTest, HostileLinesAreLeftOut) {
    fs::create_directories(folder_.file("state"));
    std::string zero("/with\0zero", 10);
    write("relative.toml\n\n/a\tb\n/bell\a\n" + zero + "\n/\xff\xfe\n/" + std::string(5000, 'x') +
          "\n/good.toml\n/good.toml\n../up\n/last");
    const std::vector<std::string> expected = {"/good.toml", "/last"};
    EXPECT_EQ(RecentFiles(list_).read(), expected);
    write(std::string(1 << 20, 'x'));
    EXPECT_TRUE(RecentFiles(list_).read().empty());
    RecentFiles(list_).add("/new.toml");
    EXPECT_EQ(RecentFiles(list_).read(), std::vector<std::string>{"/new.toml"});
}

TEST_F(RecentFilesTest, APathThatALineCannotHoldIsNotListed) {
    const RecentFiles recent(list_);
    recent.add("/two\nlines.toml");
    EXPECT_TRUE(recent.read().empty());
}

TEST_F(RecentFilesTest, AListThatCannotBeWrittenIsAnError) {
    write("");
    std::ofstream(folder_.file("state")) << "a file where the folder should be";
    EXPECT_THROW(RecentFiles(list_).add("/sea.toml"), Error);
    EXPECT_TRUE(RecentFiles(list_).read().empty());
    EXPECT_NO_THROW(RecentFiles("").add("/sea.toml"));
}

TEST_F(RecentFilesTest, TheListStandsInTheUsersState) {
    ::setenv("HOME", "/users/one", 1);
    ::unsetenv("XDG_STATE_HOME");
    EXPECT_EQ(RecentFiles::default_path(), "/users/one/.local/state/libocean/recent");
    ::setenv("XDG_STATE_HOME", "/state", 1);
    EXPECT_EQ(RecentFiles::default_path(), "/state/libocean/recent");
    ::setenv("XDG_STATE_HOME", "state", 1);  // not absolute: ignored
    EXPECT_EQ(RecentFiles::default_path(), "/users/one/.local/state/libocean/recent");
    ::unsetenv("XDG_STATE_HOME");
    ::unsetenv("HOME");
    EXPECT_EQ(RecentFiles::default_path(), "");
}

}  // namespace
}  // namespace ocean::app
