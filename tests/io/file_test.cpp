// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a target is the old file or the complete new one; no failure leaves a temporary; errors
// name the path and the system's reason, including that of a full disk.
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>

#include "ocean/internal/io/output_file.hpp"
#include "refusal.hpp"
#include "sample_surface.hpp"

namespace ocean {
namespace {

using test::read_bytes;
using test::TemporaryFolder;

std::string output_error(const std::function<void()>& action) {
    const std::string message = test::message_of(ErrorKind::output, action);
    EXPECT_NE(message, "") << "no error was thrown";
    return message;
}

TEST(AtomicFile, ReplacesTheFileCompletely) {
    const TemporaryFolder folder;
    io::write_file_atomically(folder.file("a"), "first");
    io::write_file_atomically(folder.file("a"), "second");
    EXPECT_EQ(read_bytes(folder.file("a")), "second");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, KeepsTheOldFileUntilCommitAndAfterAnException) {
    const TemporaryFolder folder;
    io::write_file_atomically(folder.file("a"), "old");
    {
        io::OutputFile file(folder.file("a"));
        file.write("new");
        EXPECT_EQ(read_bytes(folder.file("a")), "old");
        EXPECT_EQ(folder.entries(), 2u);
    }
    EXPECT_EQ(read_bytes(folder.file("a")), "old");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, NamesFitTheFileSystem) {
    EXPECT_EQ(io::name_of_file("sea", ".exr"), "sea.exr");
    EXPECT_EQ(io::name_of_file(std::string(251, 'a'), ".exr"), std::string(251, 'a') + ".exr");
    const std::string cut = io::name_of_file(std::string(252, 'a'), ".exr");
    EXPECT_EQ(cut.size(), 255u);
    EXPECT_TRUE(cut.ends_with(".exr"));
    EXPECT_NE(cut, io::name_of_file(std::string(253, 'a'), ".exr"));
    // No character is cut: 234 bytes of two each, for there is no place for half of one.
    std::string umlauts;
    for (int i = 0; i < 126; ++i) umlauts += "\xc3\xbc";
    const std::string whole = io::name_of_file("x" + umlauts, ".exr");
    EXPECT_EQ(whole.find('~'), 233u);
    EXPECT_EQ(whole.size(), 254u);
}

TEST(AtomicFile, WritesThroughASymbolicLink) {
    const TemporaryFolder folder;
    io::write_file_atomically(folder.file("real"), "old");
    std::filesystem::create_symlink("real", folder.file("link"));
    io::write_file_atomically(folder.file("link"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
    EXPECT_EQ(read_bytes(folder.file("real")), "new");
}

TEST(AtomicFile, NamesPathAndReason) {
    const TemporaryFolder folder;
    const std::string missing = folder.file("no/such/folder/a");
    const std::string message = output_error([&] { io::write_file_atomically(missing, "x"); });
    EXPECT_TRUE(test::says(message, missing));
    EXPECT_TRUE(test::says(message, "No such file or directory"));
    EXPECT_TRUE(test::says(output_error([&] { io::write_file_atomically(folder.path(), "x"); }),
                           "directory"));
    EXPECT_EQ(folder.entries(), 0u);
}

// A device keeps its buffer until the flush: small and large writes fail in different places.
TEST(AtomicFile, FullDiskIsAnErrorAlsoAtTheFlush) {
    for (const std::size_t size : {std::size_t{5}, std::size_t{5} << 20}) {
        const std::string message =
            output_error([&] { io::write_file_atomically("/dev/full", std::string(size, 'x')); });
        EXPECT_TRUE(test::says(message, "'/dev/full': No space left on device"));
    }
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

// In a child with a limit on the size of files: a disk that fills up half-way.
TEST(AtomicFile, DiskThatFillsUpLeavesTheOldFileAlone) {
    const TemporaryFolder folder;
    io::write_file_atomically(folder.file("a"), "old");
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{65536, 65536};
        setrlimit(RLIMIT_FSIZE, &limit);
        try {
            io::write_file_atomically(folder.file("a"), std::string(1000000, 'x'));
        } catch (const Error& error) {
            _exit(std::string(error.what()).find("File too large") != std::string::npos ? 7 : 8);
        }
        _exit(9);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 7);
    EXPECT_EQ(read_bytes(folder.file("a")), "old");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, CleanerRemovesTemporariesOfEndedProcessesOnly) {
    const TemporaryFolder folder;
    const pid_t child = fork();
    if (child == 0) {
        io::OutputFile file(folder.file("killed"));
        file.write("half");
        std::raise(SIGKILL);
    }
    waitpid(child, nullptr, 0);
    ASSERT_EQ(folder.entries(), 1u);
    io::OutputFile living(folder.file("living"));
    io::write_file_atomically(folder.file(".mine.tmp"), "not ours");
    const std::vector<std::string> others = {folder.file("kill"), folder.file("killed.ocean-")};
    EXPECT_EQ(io::remove_abandoned_temporaries(folder.path(), others), 0);
    const std::vector<std::string> own = {folder.file("absent"), folder.file("killed")};
    EXPECT_EQ(io::remove_abandoned_temporaries(folder.path(), own), 1);
    EXPECT_EQ(folder.entries(), 2u);
    living.write("whole");
    living.commit();
    EXPECT_EQ(read_bytes(folder.file("living")), "whole");
    EXPECT_EQ(io::remove_abandoned_temporaries(folder.path()), 0);
}

}  // namespace
}  // namespace ocean
