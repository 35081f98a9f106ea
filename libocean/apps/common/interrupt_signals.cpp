// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The thread that waits for signals. See interrupt.hpp.
#include <csignal>
#include <thread>
#include <utility>

#include "interrupt.hpp"

namespace ocean::app {
namespace {

/// Ends the waiting thread; other processes do not send it.
constexpr int kLeave = SIGUSR1;

/// Returns true for signals that nohup or job control ignore on purpose: they stay ignored.
bool ignored(int signal_number) {
    struct sigaction action {};
    return ::sigaction(signal_number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

struct InterruptWatch::Signals {
    sigset_t set;
    std::thread thread;
};

InterruptWatch::InterruptWatch(std::function<void()> farewell)
    : farewell_(std::move(farewell)), signals_(std::make_unique<Signals>()) {
    // A file above its size limit and a closed pipe are reported as errors of the write instead.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
    sigset_t& set = signals_->set;
    sigemptyset(&set);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        if (!ignored(number)) sigaddset(&set, number);
    }
    sigaddset(&set, kLeave);
    ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
    signals_->thread = std::thread([this] {
        int received = 0;
        if (sigwait(&signals_->set, &received) == 0 && received != kLeave) end_process();
    });
}

InterruptWatch::~InterruptWatch() {
    ::pthread_kill(signals_->thread.native_handle(), kLeave);
    signals_->thread.join();
}

}  // namespace ocean::app
