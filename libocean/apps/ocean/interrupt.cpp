// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C; see interrupt.hpp.
#include "interrupt.hpp"

#include <cstdlib>
#include <utility>

namespace ocean::app {
namespace {

/// Ends the waiting thread; nobody sends it from outside.
constexpr int kLeave = SIGUSR1;
constexpr int kInterruptedExit = 130;

/// nohup and job control ignore signals on purpose: those stay ignored.
bool ignored(int signal_number) {
    struct sigaction action {};
    return ::sigaction(signal_number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

InterruptWatch::InterruptWatch(std::function<void()> farewell) {
    // A file over its limit is an error of the write, with a message.
    std::signal(SIGXFSZ, SIG_IGN);
    sigemptyset(&signals_);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        if (!ignored(number)) sigaddset(&signals_, number);
    }
    sigaddset(&signals_, kLeave);
    ::pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    thread_ = std::thread([this, farewell = std::move(farewell)] {
        int received = 0;
        if (sigwait(&signals_, &received) != 0 || received == kLeave) return;
        const std::lock_guard lock(mutex_);
        farewell();
        std::_Exit(kInterruptedExit);
    });
}

InterruptWatch::~InterruptWatch() {
    ::pthread_kill(thread_.native_handle(), kLeave);
    thread_.join();
}

}  // namespace ocean::app
