// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Work in a forked child: see ocean/internal/child_process.hpp.
#include "ocean/internal/child_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <utility>

#include "ocean/error.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define OCEAN_ADDRESS_SPACE_IS_SHADOWED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define OCEAN_ADDRESS_SPACE_IS_SHADOWED 1
#endif
#endif

namespace ocean::sandbox {
namespace {

class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }
    void close() {
        if (number_ >= 0) ::close(std::exchange(number_, -1));
    }

  private:
    int number_;
};

/// Blocks signals until the child has the default handlers of a new program.
class BlockedSignals {
  public:
    BlockedSignals() {
        sigset_t all;
        sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~BlockedSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    BlockedSignals(const BlockedSignals&) = delete;
    BlockedSignals& operator=(const BlockedSignals&) = delete;

  private:
    sigset_t before_{};
};

void default_signals() {
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    for (int number = 1; number < NSIG; ++number) ::sigaction(number, &action, nullptr);
    sigset_t none;
    sigemptyset(&none);
    ::pthread_sigmask(SIG_SETMASK, &none, nullptr);
}

/// Returns the memory of this process [bytes], or 0 if the system does not report it.
std::uint64_t address_space_in_use() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

template <typename Resource>
void limit(Resource resource, std::uint64_t amount) {
    struct rlimit bounds {};
    if (::getrlimit(resource, &bounds) != 0) return;
    const rlim_t limit = std::min(static_cast<rlim_t>(amount), bounds.rlim_max);
    bounds = {limit, limit};
    ::setrlimit(resource, &bounds);
}

void limit_child(const ChildLimits& limits, std::uint64_t inherited) {
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, limits.cpu_seconds);
#ifndef OCEAN_ADDRESS_SPACE_IS_SHADOWED
    limit(RLIMIT_AS, inherited + limits.memory_bytes);
#else
    static_cast<void>(inherited);
#endif
}

void silence() {
    const int nothing = ::open("/dev/null", O_RDWR);
    for (int stream = 0; stream <= 2; ++stream) ::dup2(nothing, stream);
}

/// Gives a child the handlers and limits of all children. Returns its end of the pipe, which lies
/// above the standard streams: the program may have been started without them.
int begin_child(const int (&ends)[2], const ChildLimits& limits, std::uint64_t inherited) {
    default_signals();
    ::close(ends[0]);  // a pipe without a reader ends its writer
    const int out = ::fcntl(ends[1], F_DUPFD, 3);
    silence();
    limit_child(limits, inherited);
    return out;
}

void write_all(int pipe, const void* bytes, std::size_t count) {
    const char* next = static_cast<const char*>(bytes);
    while (count > 0) {
        const ssize_t written = ::write(pipe, next, count);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) ::_exit(1);
        next += written;
        count -= static_cast<std::size_t>(written);
    }
}

/// Runs `produce` and ends the child. Never returns, because no other code of the program may run
/// in the child.
[[noreturn]] void be_child(int out, const std::function<void(const Sink&)>& produce) noexcept {
    try {
        std::string waiting;
        const auto flush = [&] {
            write_all(out, waiting.data(), waiting.size());
            waiting.clear();
        };
        produce([&](const void* bytes, std::size_t count) {
            constexpr std::size_t kBlock = std::size_t{1} << 16;
            if (count < kBlock) waiting.append(static_cast<const char*>(bytes), count);
            if (waiting.size() >= kBlock || count >= kBlock) flush();
            if (count >= kBlock) write_all(out, bytes, count);
        });
        flush();
    } catch (...) {
        ::_exit(1);
    }
    ::_exit(0);
}

/// Becomes another program, without environment, folder and descriptors of this one.
[[noreturn]] void be_program(int out, char* const* arguments) noexcept {
    ::dup2(out, STDOUT_FILENO);
#ifdef SYS_close_range
    ::syscall(SYS_close_range, 3U, ~0U, 0U);
#endif
    char* const no_environment[] = {nullptr};
    if (::chdir("/") == 0) ::execve(arguments[0], arguments, no_environment);
    ::_exit(1);
}

class Child {
  public:
    explicit Child(pid_t pid) : pid_(pid) {}
    ~Child() { end(); }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Returns the child's wait status, or 0 if the system has reaped it already (SIGCHLD ignored).
    int wait() {
        int status = 0;
        const pid_t pid = std::exchange(pid_, -1);
        while (pid > 0 && ::waitpid(pid, &status, 0) < 0) {
            if (errno != EINTR) return 0;
        }
        return status;
    }
    void end() {
        if (pid_ > 0) ::kill(pid_, SIGKILL);
        wait();
    }

  private:
    pid_t pid_;
};

/// Returns false at the end of the pipe.
bool read_all(int pipe, void* bytes, std::size_t count) {
    char* next = static_cast<char*>(bytes);
    while (count > 0) {
        const ssize_t got = ::read(pipe, next, count);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        next += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

[[noreturn]] void fail_by(int status, const ChildLimits& limits) {
    if (WIFEXITED(status)) throw ChildFailure("it stopped early");
    const int signal_number = WTERMSIG(status);
    switch (signal_number) {
        case SIGINT:
        case SIGTERM:
        case SIGHUP:
            throw Error(ErrorKind::interrupted, "interrupted");
        case SIGXCPU:
        case SIGKILL:
            throw ChildFailure("it took more than " + std::to_string(limits.cpu_seconds) +
                               " seconds, or too much memory");
        default:
            throw ChildFailure("it crashed (signal " + std::to_string(signal_number) + ")");
    }
}

/// Calls `be` in a child with its end of a pipe, and `consume` here on what comes out of it.
/// `inherited` is memory that does not count [bytes].
void run(const ChildLimits& limits, std::uint64_t inherited, const std::function<void(int)>& be,
         const std::function<void(const Source&)>& consume) {
    int ends[2] = {-1, -1};
    if (::pipe(ends) != 0) {
        throw Error(ErrorKind::output, std::string("cannot make a pipe: ") + std::strerror(errno));
    }
    Descriptor from(ends[0]);
    Descriptor to(ends[1]);
    for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
    pid_t pid = -1;
    {
        const BlockedSignals blocked;
        pid = ::fork();
        if (pid == 0) {
            be(begin_child(ends, limits, inherited));
            ::_exit(1);
        }
    }
    if (pid < 0) {
        throw Error(ErrorKind::output, std::string("cannot fork: ") + std::strerror(errno));
    }
    Child child(pid);
    to.close();
    bool ended = false;
    try {
        consume([&](void* bytes, std::size_t count) {
            const bool whole = read_all(from.number(), bytes, count);
            ended |= !whole;
            return whole;
        });
    } catch (const WireError&) {
        if (!ended) throw ChildFailure("it gave nonsense");
        fail_by(child.wait(), limits);
    }
    from.close();  // otherwise a child that still writes would block for ever
    if (const int status = child.wait(); status != 0) fail_by(status, limits);
}

}  // namespace

void run_in_child(const ChildLimits& limits, const std::function<void(const Sink&)>& produce,
                  const std::function<void(const Source&)>& consume) {
    run(
        limits, address_space_in_use(), [&](int out) { be_child(out, produce); }, consume);
}

void run_program(const ChildLimits& limits, const std::vector<std::string>& arguments,
                 const std::function<void(const Source&)>& consume) {
    // Before the fork: a child of a program with threads may not allocate.
    std::vector<char*> words;
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    run(
        limits, 0, [&](int out) { be_program(out, words.data()); }, consume);
}

}  // namespace ocean::sandbox
