// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See interrupt.hpp.
#include "interrupt.hpp"

#include <cstdlib>
#include <utility>

#include "ocean/internal/io/output_file.hpp"

namespace ocean::app {

// The lock is never released: a destructor of LastAct blocks until the process ends.
void InterruptWatch::end_process() {
    std::unique_lock lock(mutex_);
    ending_ = true;
    changed_.wait(lock, [this] { return holds_ == 0; });
    if (last_act_) last_act_();
    farewell_();
    std::_Exit(kInterruptedExit);
}

InterruptWatch::Hold::Hold(InterruptWatch& watch) : watch_(watch) {
    std::unique_lock lock(watch.mutex_);
    watch.changed_.wait(lock, [&] { return !watch.ending_; });
    ++watch.holds_;
}

InterruptWatch::Hold::~Hold() {
    const std::lock_guard lock(watch_.mutex_);
    --watch_.holds_;
    watch_.changed_.notify_all();
}

InterruptWatch::LastAct::LastAct(InterruptWatch& watch, std::function<void()> act) : watch_(watch) {
    const std::lock_guard lock(watch.mutex_);
    watch.last_act_ = std::move(act);
}

InterruptWatch::LastAct::~LastAct() {
    const std::lock_guard lock(watch_.mutex_);
    watch_.last_act_ = nullptr;
}

void write_output(InterruptWatch& interrupts, const std::string& path, std::string_view bytes) {
    const InterruptWatch::Hold whole = interrupts.hold();
    io::write_output(path, bytes);
}

}  // namespace ocean::app
