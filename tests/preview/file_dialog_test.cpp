// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a dialog never blocks, its program gets the words of its kind, a cancelled one has no
// path, a failed one says so, and none outlives its window.
#include "window/file_dialog.hpp"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "ocean/error.hpp"
#include "refusal.hpp"
#include "temporary_folder.hpp"

namespace ocean::app {
namespace {

using Purpose = FilePurpose;

/// A folder that is all of PATH, for programs that only this test has.
class FileDialogTest : public testing::Test {
  protected:
    void SetUp() override {
        ::setenv("PATH", folder_.path().c_str(), 1);
        ::unsetenv("XDG_CURRENT_DESKTOP");
    }

    void install(const std::string& name, const std::string& script) const {
        const std::string program = folder_.file(name);
        std::ofstream(program) << "#!/bin/sh\nPATH=/usr/bin:/bin\ncd '" + folder_.path() + "'\n" +
                                      script;
        ::chmod(program.c_str(), 0700);
    }
    std::string content(const std::string& name) const {
        return test::read_bytes(folder_.file(name));
    }
    static FileDialog::Answer answer_of(FileDialog& dialog) {
        for (int i = 0; i < 5000; ++i) {
            if (auto answer = dialog.poll()) return *answer;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        ADD_FAILURE() << "no answer";
        return {};
    }

    const test::TemporaryFolder folder_;
};

TEST_F(FileDialogTest, WithoutAProgramNoneIsAvailable) {
    EXPECT_FALSE(FileDialog::is_available());
    FileDialog dialog;
    EXPECT_THROW(dialog.ask(Purpose::open, "/tmp/"), Error);
    EXPECT_FALSE(dialog.is_open());
    EXPECT_FALSE(dialog.poll());
}

TEST_F(FileDialogTest, APathWithBlanksAndQuotesArrivesWhole) {
    install("zenity",
            "printf '%s\\n' \"$@\" > words\n"
            "printf '%s\\n' \"/seas/a 'b' \\$HOME;c.toml\"\n");
    FileDialog dialog;
    dialog.ask(Purpose::save, "/seas/it's $(touch hit).toml");
    const FileDialog::Answer answer = answer_of(dialog);
    EXPECT_EQ(answer.path, "/seas/a 'b' $HOME;c.toml");
    EXPECT_EQ(answer.purpose, Purpose::save);
    const std::string words = content("words");
    EXPECT_NE(words.find("--file-selection\n"), std::string::npos) << words;
    EXPECT_NE(words.find("--filename=/seas/it's $(touch hit).toml\n"), std::string::npos) << words;
    EXPECT_NE(words.find("--confirm-overwrite\n"), std::string::npos) << words;
    EXPECT_FALSE(std::filesystem::exists(folder_.file("hit")));
}

TEST_F(FileDialogTest, ADialogThatIsOpenBlocksNothing) {
    install("zenity", "while ! test -e answered; do sleep .01; done\necho /seas/a.toml\n");
    FileDialog dialog;
    dialog.ask(Purpose::open, "/");
    EXPECT_TRUE(dialog.is_open());
    EXPECT_FALSE(dialog.poll());
    dialog.ask(Purpose::open, "/");  // a second one does not open
    std::ofstream(folder_.file("answered")) << "";
    EXPECT_EQ(answer_of(dialog).path, "/seas/a.toml");
    EXPECT_FALSE(dialog.is_open());
}

TEST_F(FileDialogTest, ACancelledOneHasNoPathAndAFailedOneIsAnError) {
    install("zenity", "echo ignored\nexit 1\n");
    FileDialog dialog;
    dialog.ask(Purpose::open, "/");
    EXPECT_EQ(answer_of(dialog).path, "");
    install("zenity", "exit 5\n");
    dialog.ask(Purpose::open, "/");
    const std::string said = test::message_of([&] { answer_of(dialog); });
    EXPECT_NE(said.find("zenity failed with exit code 5"), std::string::npos) << said;
    EXPECT_FALSE(dialog.is_open());
}

TEST_F(FileDialogTest, TheDesktopsProgramIsPreferred) {
    install("zenity", "echo zenity\n");
    install("kdialog", "printf '%s\\n' \"$@\" > words\necho kdialog\n");
    FileDialog dialog;
    dialog.ask(Purpose::open, "/seas/");
    EXPECT_EQ(answer_of(dialog).path, "zenity");
    ::setenv("XDG_CURRENT_DESKTOP", "KDE", 1);
    dialog.ask(Purpose::open, "/seas/");
    EXPECT_EQ(answer_of(dialog).path, "kdialog");
    EXPECT_NE(content("words").find("--getopenfilename\n/seas/\n"), std::string::npos);
}

TEST_F(FileDialogTest, ADialogEndsWithItsWindow) {
    install("zenity", "echo $$ > number\nexec sleep 1000\n");
    {
        FileDialog dialog;
        dialog.ask(Purpose::open, "/");
        while (content("number").find('\n') == std::string::npos) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }
    EXPECT_NE(::kill(std::stoi(content("number")), 0), 0);
}

TEST_F(FileDialogTest, FilesOfTheWindowStayTheirs) {
    install("zenity", "ls /proc/$$/fd > files\nwc -l < files\n");
    // Without close-on-exec, as libraries leave some.
    const std::array<int, 3> extra = {::dup(STDERR_FILENO), ::dup(STDERR_FILENO),
                                      ::dup(STDERR_FILENO)};
    FileDialog dialog;
    dialog.ask(Purpose::open, "/");
    // Its three, and two of the shell.
    EXPECT_LE(std::stoi(answer_of(dialog).path), 5);
    for (const int each : extra) ::close(each);
}

}  // namespace
}  // namespace ocean::app
