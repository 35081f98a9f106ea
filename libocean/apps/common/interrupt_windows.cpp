// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C on Windows, which starts a thread of its own for it: that thread does what the waiting one
// of interrupt_signals.cpp does. See interrupt.hpp.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <atomic>
#include <utility>

#include "interrupt.hpp"

namespace ocean::app {
namespace {

std::atomic<InterruptWatch*> watching{nullptr};

}  // namespace

struct InterruptWatch::Signals {
    static BOOL WINAPI receive(DWORD) {
        InterruptWatch* const watch = watching;
        if (watch == nullptr) return FALSE;
        watch->end_process();
    }
};

InterruptWatch::InterruptWatch(std::function<void()> farewell) : farewell_(std::move(farewell)) {
    watching = this;
    SetConsoleCtrlHandler(Signals::receive, TRUE);
}

InterruptWatch::~InterruptWatch() {
    SetConsoleCtrlHandler(Signals::receive, FALSE);
    watching = nullptr;
}

}  // namespace ocean::app
