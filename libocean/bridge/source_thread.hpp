// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A source whose boards are served by a thread of its own. The start, the end, the channels of
// connected boards and the events are written here once; a driver writes a worker that talks to its
// boards.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

/// The state that a worker shares with the callers of its source. All functions may be called from
/// any thread. Reports and events are dropped before start() and after stop().
class BoardHost {
  public:
    /// `name` stands for the source in the event of a failure that no connected board has.
    explicit BoardHost(std::string name) : name_(std::move(name)) {}

    bool is_stopped() const { return stopped_; }
    /// Blocks until `time`, wake() or the end of the source.
    void wait_until(Clock::time_point time);
    /// Ends the current wait_until(), or the next one if none is running.
    void wake();

    void report(Report report) const;
    /// Makes the channels available without an event, for boards that are always connected.
    void offer(const std::string& board, std::vector<Channel> channels);
    /// Makes the channels available, then sends the event.
    void connected(const std::string& board, std::string text, std::vector<Channel> channels);
    /// Withdraws the channels, then sends the event.
    void lost(const std::string& board, std::string text = "");
    /// Sends the event unless it has the same reason as the one before. connected() and
    /// no_longer_busy() forget the reason.
    void busy(const std::string& board, const std::string& reason);
    void no_longer_busy(const std::string& board);

    // For the source.
    void begin(Source::Listener listener);
    void end();
    /// Calls `run` until it returns. If it throws, sends the message as the loss of each connected
    /// board, or as busy() of the name if none is connected.
    void run(const std::function<void()>& run);
    std::vector<Channel> channels() const;

  private:
    void send(BoardEvent event) const;
    void fail(const std::string& reason);

    const std::string name_;
    Source::Listener listener_;
    std::atomic<bool> running_ = false;  // true between start() and stop()
    std::atomic<bool> stopped_ = false;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    bool woken_ = false;
    std::map<std::string, std::vector<Channel>> channels_;  // of connected boards
    std::map<std::string, std::string> complaints_;         // last reason of busy()
};

/// A source that owns a worker and its thread. A Worker has
///   Worker(BoardHost&, ...)   keeps the reference
///   void begin()              optional; reports known positions before start() returns
///   void run()                serves the boards in the source's thread until host.is_stopped()
///   void wake()               ends a wait of run() other than host.wait_until(); any thread
///   void put(channel, value)  as Source::put
/// The worker is destroyed after its thread has ended.
template <typename Worker>
class ThreadedSource final : public Source {
  public:
    template <typename... Arguments>
    explicit ThreadedSource(std::string name, Arguments&&... arguments)
        : host_(std::move(name)), worker_(host_, std::forward<Arguments>(arguments)...) {}
    ~ThreadedSource() override { stop(); }
    ThreadedSource(const ThreadedSource&) = delete;
    ThreadedSource& operator=(const ThreadedSource&) = delete;

    std::vector<Channel> channels() const override { return host_.channels(); }
    void start(Listener listener) override {
        host_.begin(std::move(listener));
        if constexpr (requires { worker_.begin(); }) worker_.begin();
        thread_ = std::thread([this] { host_.run([this] { worker_.run(); }); });
    }
    void stop() override {
        host_.end();
        worker_.wake();
        if (thread_.joinable()) thread_.join();
    }
    void put(const std::string& channel, double value) override { worker_.put(channel, value); }

  private:
    BoardHost host_;
    Worker worker_;
    std::thread thread_;
};

}  // namespace ocean::bridge
