// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "source_thread.hpp"

#include <exception>

namespace ocean::bridge {

void BoardHost::wait_until(Clock::time_point time) {
    std::unique_lock lock(mutex_);
    changed_.wait_until(lock, time, [this] { return woken_ || stopped_; });
    woken_ = false;
}

void BoardHost::wake() {
    {
        const std::lock_guard lock(mutex_);
        woken_ = true;
    }
    changed_.notify_all();
}

void BoardHost::report(Report report) const {
    if (running_) listener_.report(std::move(report));
}

void BoardHost::offer(const std::string& board, std::vector<Channel> channels) {
    const std::lock_guard lock(mutex_);
    channels_[board] = std::move(channels);
    complaints_.erase(board);
}

void BoardHost::connected(const std::string& board, std::string text,
                          std::vector<Channel> channels) {
    offer(board, std::move(channels));
    send({BoardEvent::Kind::connected, board, std::move(text)});
}

void BoardHost::lost(const std::string& board, std::string text) {
    {
        const std::lock_guard lock(mutex_);
        channels_.erase(board);
    }
    send({BoardEvent::Kind::lost, board, std::move(text)});
}

void BoardHost::busy(const std::string& board, const std::string& reason) {
    {
        const std::lock_guard lock(mutex_);
        if (std::exchange(complaints_[board], reason) == reason) return;
    }
    send({BoardEvent::Kind::busy, board, reason});
}

void BoardHost::no_longer_busy(const std::string& board) {
    const std::lock_guard lock(mutex_);
    complaints_.erase(board);
}

void BoardHost::begin(Source::Listener listener) {
    listener_ = std::move(listener);
    running_ = !stopped_;
}

void BoardHost::end() {
    {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
        running_ = false;
    }
    changed_.notify_all();
}

void BoardHost::run(const std::function<void()>& run) {
    try {
        run();
    } catch (const std::exception& error) {
        fail(error.what());
    }
}

void BoardHost::fail(const std::string& reason) {
    std::vector<std::string> boards;
    {
        const std::lock_guard lock(mutex_);
        for (const auto& [board, channels] : channels_) boards.push_back(board);
    }
    for (const std::string& board : boards) lost(board, reason);
    if (boards.empty()) busy(name_, reason);
}

std::vector<Channel> BoardHost::channels() const {
    std::vector<Channel> all;
    const std::lock_guard lock(mutex_);
    for (const auto& [board, channels] : channels_) {
        all.insert(all.end(), channels.begin(), channels.end());
    }
    return all;
}

void BoardHost::send(BoardEvent event) const {
    if (running_) listener_.event(std::move(event));
}

}  // namespace ocean::bridge
