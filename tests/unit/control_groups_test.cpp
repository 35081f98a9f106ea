// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Quotas of control groups, from files like those of Linux.
#include "base/control_groups.hpp"

#include "temporary_folder.hpp"
#include "testing.hpp"

namespace ocean {
namespace {

void write(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
}

TEST(ControlGroups, TheSmallestQuotaFromTheRootDownCounts) {
    const test::TemporaryFolder folder;
    const std::filesystem::path root = folder.path();
    write(root / "list", "1:name=systemd:/old\n0::/farm/job\n");
    write(root / "cpu.max", "max 100000\n");
    write(root / "farm/cpu.max", "250000 100000\n");
    write(root / "farm/job/cpu.max", "400000 100000\n");
    const auto groups = control_groups(root / "list", root);
    ASSERT_EQ(groups.size(), 3u);
    EXPECT_EQ(groups[2], root / "farm/job");
    EXPECT_EQ(cores_of_cgroups(groups), 3);
    write(root / "farm/job/cpu.max", "10000 100000\n");
    EXPECT_EQ(cores_of_cgroups(groups), 1);
}

TEST(ControlGroups, PageCacheIsFreeAndSharedMemoryIsNot) {
    const test::TemporaryFolder folder;
    const std::filesystem::path root = folder.path();
    write(root / "list", "0::/\n");
    write(root / "memory.max", "1000\n");
    write(root / "memory.current", "900\n");
    write(root / "memory.stat", "anon 200\nfile 700\nshmem 150\n");
    EXPECT_EQ(memory_of_cgroups(control_groups(root / "list", root)), 1000u - (900u - 550u));
}

TEST(ControlGroups, WithoutLimitsSetNone) {
    const test::TemporaryFolder folder;
    const auto groups = control_groups(folder.file("nothing"), folder.path());
    EXPECT_EQ(cores_of_cgroups(groups), std::numeric_limits<int>::max());
    EXPECT_EQ(memory_of_cgroups(groups), std::numeric_limits<std::uint64_t>::max());
}

}  // namespace
}  // namespace ocean
