// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/file_dialog.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"

extern char** environ;  // no header of POSIX declares it

namespace ocean::app {
namespace {

constexpr std::size_t kMaxAnswerBytes = 8192;
constexpr const char* kFilter = "*.toml *.take *.exr *.ply *.obj *.vdb *.usdc *.png";

/// Returns the path of an installed program; "" if it is not installed.
std::string find_program(const std::string& name) {
    const char* const path = std::getenv("PATH");
    for (const std::string& folder : split(path == nullptr ? "" : path, ':')) {
        if (!folder.starts_with('/')) continue;  // the working directory may be anyone's
        std::string program = folder + "/" + name;
        if (::access(program.c_str(), X_OK) == 0) return program;
    }
    return "";
}

/// Returns the program of the user's desktop if it is installed, else any other one.
std::string best_program() {
    const char* const desktop = std::getenv("XDG_CURRENT_DESKTOP");
    const bool is_kde =
        desktop != nullptr && std::string_view(desktop).find("KDE") != std::string_view::npos;
    const std::array<const char*, 4> names = is_kde
                                                 ? std::array{"kdialog", "qarma", "zenity", "yad"}
                                                 : std::array{"zenity", "qarma", "kdialog", "yad"};
    for (const char* const name : names) {
        if (std::string program = find_program(name); !program.empty()) return program;
    }
    return "";
}

std::vector<std::string> arguments(const std::string& program, FilePurpose purpose,
                                   const std::string& suggested) {
    const bool saves = purpose == FilePurpose::save;
    const std::string title = saves ? "Save the sea" : "Open a sea, a take or a sky";
    if (program.ends_with("/kdialog")) {
        return {program,   "--title",
                title,     saves ? "--getsavefilename" : "--getopenfilename",
                suggested, saves ? "*.toml" : kFilter};
    }
    std::vector<std::string> words = {program,
                                      program.ends_with("/yad") ? "--file" : "--file-selection",
                                      "--title=" + title, "--filename=" + suggested};
    if (saves) {
        words.insert(words.end(), {"--save", "--confirm-overwrite"});
    } else {
        words.push_back(std::string("--file-filter=Seas, takes and skies | ") + kFilter);
        words.push_back("--file-filter=All files | *");
    }
    return words;
}

/// Gives a child its output in a pipe, no other file of the window, and no blocked signals.
class SpawnRules {
  public:
    explicit SpawnRules(int output) {
        ::posix_spawn_file_actions_init(&files_);
        ::posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        ::posix_spawn_file_actions_adddup2(&files_, output, STDOUT_FILENO);
        ::posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 34)
        ::posix_spawn_file_actions_addclosefrom_np(&files_, STDERR_FILENO + 1);
#endif
        ::posix_spawnattr_init(&attributes_);
        sigset_t none, defaults;
        ::sigemptyset(&none);
        ::sigemptyset(&defaults);
        ::sigaddset(&defaults, SIGPIPE);
        ::posix_spawnattr_setsigmask(&attributes_, &none);
        ::posix_spawnattr_setsigdefault(&attributes_, &defaults);
        ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }
    ~SpawnRules() {
        ::posix_spawn_file_actions_destroy(&files_);
        ::posix_spawnattr_destroy(&attributes_);
    }
    SpawnRules(const SpawnRules&) = delete;
    SpawnRules& operator=(const SpawnRules&) = delete;

    const posix_spawn_file_actions_t* files() const {
        return &files_;
    }
    const posix_spawnattr_t* attributes() const {
        return &attributes_;
    }

  private:
    posix_spawn_file_actions_t files_{};
    posix_spawnattr_t attributes_{};
};

}  // namespace

bool FileDialog::is_available() {
    return !best_program().empty();
}

FileDialog::~FileDialog() {
    if (output_ >= 0) ::close(output_);
    if (child_ <= 0) return;
    ::kill(child_, SIGTERM);
    int ignored = 0;
    ::waitpid(child_, &ignored, 0);
}

void FileDialog::ask(FilePurpose purpose, const std::string& suggested) {
    if (is_open()) return;
    program_ = best_program();
    if (program_.empty()) {
        throw Error(ErrorKind::unsupported,
                    std::string("no program that asks for a file is installed: ") + programs());
    }
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
        throw Error(ErrorKind::output, std::string("no pipe can be opened: ") + strerror(errno));
    }
    std::vector<std::string> words = arguments(program_, purpose, suggested);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const SpawnRules rules(ends[1]);
    pid_t child = 0;
    const int error = ::posix_spawn(&child, program_.c_str(), rules.files(), rules.attributes(),
                                    argv.data(), environ);
    ::close(ends[1]);
    if (error != 0) {
        ::close(ends[0]);
        throw Error(ErrorKind::unsupported,
                    program_ + " cannot be started: " + std::strerror(error));
    }
    child_ = child;
    output_ = ends[0];
    purpose_ = purpose;
    answer_.clear();
}

void FileDialog::read_answer() {
    std::array<char, 1024> block{};
    for (;;) {
        const ssize_t count = ::read(output_, block.data(), block.size());
        if (count <= 0) return;  // nothing more now, or the end
        if (answer_.size() < kMaxAnswerBytes) {
            answer_.append(block.data(), static_cast<std::size_t>(count));
        }
    }
}

std::optional<FileDialog::Answer> FileDialog::poll() {
    if (!is_open()) return std::nullopt;
    read_answer();
    int status = 0;
    if (::waitpid(child_, &status, WNOHANG) != child_) return std::nullopt;
    read_answer();
    ::close(output_);
    output_ = -1;
    child_ = 0;
    constexpr int kCancelled = 1;
    constexpr int kYadClosed = 252;
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (code == kCancelled || code == kYadClosed) return Answer{purpose_, ""};
    if (code != 0) {
        throw Error(ErrorKind::unsupported,
                    program_ + " failed" +
                        (code > 0 ? format_text(" with exit code %d", code) : std::string()));
    }
    if (answer_.ends_with('\n')) answer_.pop_back();
    return Answer{purpose_, answer_};
}

}  // namespace ocean::app
