// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A Velleman K8055 that is not there: umockdev's test bed with the kernel's side of usbfs, for a
// program that reads the board by libusb and knows of no test.
//   umockdev-wrapper mock_k8055 PROGRAM ARGUMENT...
// Commands on standard input, each answered by "ok" on standard output: plug [ADDRESS], unplug,
// rate HERTZ, set A1 A2 DIGITAL COUNTER1 COUNTER2, report HEX, stall, refuse, allow, storm N
// MILLISECONDS. Beside the answers it says "sent SECONDS" when the program has the first report of
// a new state, "out HEX" for each report to the board, "driver off" and "driver on" for the
// kernel's own. SECONDS are those of the monotonic clock.
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>

#include "mock_k8055.hpp"

namespace {

using Clock = MockK8055::Clock;
using Bytes = MockK8055::Bytes;

void say(const std::string& line) {
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    std::cout << line << std::endl;
}

std::string hex(const Bytes& bytes) {
    std::string text;
    std::array<char, 3> digits{};
    for (const std::uint8_t byte : bytes) {
        std::snprintf(digits.data(), digits.size(), "%02x", byte);
        text += digits.data();
    }
    return text;
}

std::string seconds(Clock::time_point time) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.6f",
                  std::chrono::duration<double>(time.time_since_epoch()).count());
    return text.data();
}

Bytes bytes_of(const std::string& digits) {
    Bytes bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
        bytes.push_back(static_cast<std::uint8_t>(std::stoul(digits.substr(i, 2), nullptr, 16)));
    }
    return bytes;
}

void obey(MockK8055& board, std::atomic<int>& rate, const std::string& line) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "plug") {
        int address = 0;
        words >> address;
        board.plug(address);
    } else if (word == "unplug") {
        board.unplug();
    } else if (word == "rate") {
        int hertz = 100;
        words >> hertz;
        rate = hertz;
    } else if (word == "set") {
        unsigned a1 = 0;
        unsigned a2 = 0;
        unsigned digital = 0;
        unsigned c1 = 0;
        unsigned c2 = 0;
        words >> a1 >> a2 >> digital >> c1 >> c2;
        board.set(k8055_report(a1, a2, digital, c1, c2));
    } else if (word == "report") {
        std::string digits;
        words >> digits;
        board.set(bytes_of(digits));
    } else if (word == "stall") {
        board.stall();
    } else if (word == "refuse" || word == "allow") {
        board.refuse(word == "refuse");
    } else if (word == "storm") {
        int times = 0;
        int pause = 0;
        words >> times >> pause;
        for (int i = 0; i < times; ++i) {
            board.unplug();
            std::this_thread::sleep_for(std::chrono::milliseconds(pause));
            board.plug();
            std::this_thread::sleep_for(std::chrono::milliseconds(pause));
        }
    } else {
        return say("error unknown command");
    }
    say("ok");
}

}  // namespace

int main(int argc, char** argv) {
    // umockdev_in_mock_environment() says no in 0.17.
    const char* preloaded = std::getenv("LD_PRELOAD");
    if (argc < 2 || preloaded == nullptr || std::strstr(preloaded, "umockdev") == nullptr) {
        std::fprintf(stderr, "usage: umockdev-wrapper mock_k8055 PROGRAM ARGUMENT...\n");
        return 2;
    }
    MockK8055 board({.out = [](const Bytes& bytes) { say("out " + hex(bytes)); },
                     .sent = [](Clock::time_point time) { say("sent " + seconds(time)); },
                     .kernel_driver = [](bool bound) { say(bound ? "driver on" : "driver off"); },
                     .error = [](const std::string& what) { say("error " + what); }});
    const pid_t program = ::fork();
    if (program == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        const int nothing = ::open("/dev/null", O_RDONLY);
        ::dup2(nothing, STDIN_FILENO);
        ::dup2(STDERR_FILENO, STDOUT_FILENO);
        ::execvp(argv[1], argv + 1);
        std::perror("mock_k8055");
        ::_exit(127);
    }
    say("program " + std::to_string(program));
    std::atomic<int> rate = 100;
    std::atomic<bool> ended = false;
    std::thread clock([&] {
        auto next = Clock::now();
        while (!ended) {
            next = std::max(next, Clock::now() - std::chrono::milliseconds(100)) +
                   std::chrono::microseconds(1'000'000 / rate);
            std::this_thread::sleep_until(next);
            board.tick();
        }
    });
    std::string line;
    while (std::getline(std::cin, line)) obey(board, rate, line);
    ::kill(program, SIGTERM);
    int status = 0;
    ::waitpid(program, &status, 0);
    ended = true;
    clock.join();
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    say("exit " + std::to_string(code));
    return code;
}
