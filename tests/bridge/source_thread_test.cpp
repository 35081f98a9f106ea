// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The life of a source with a thread: it may be stopped at any time, its channels are those of
// connected boards, and a worker that fails loses its boards and no more.
#include "source_thread.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "listening.hpp"

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;
using test::Ear;

/// Runs what a test gives it.
class ToyWorker {
  public:
    ToyWorker(BoardHost& host, std::function<void(BoardHost&)> work)
        : host_(host), work_(std::move(work)) {}
    void run() { work_(host_); }
    void wake() { ++wakes; }
    void put(const std::string& channel, double value) {
        host_.report({Clock::now(), channel, value});
    }

    std::atomic<int> wakes = 0;

  private:
    BoardHost& host_;
    std::function<void(BoardHost&)> work_;
};
using Toy = ThreadedSource<ToyWorker>;

const std::vector<Channel> kChannels = {{"toy/a1"}};

void wait_for_the_end(BoardHost& host) {
    while (!host.is_stopped()) host.wait_until(Clock::now() + 1h);
}

TEST(ThreadedSource, StopsBeforeItsStartAndTwice) {
    Ear ear;
    Toy never("toy", wait_for_the_end);
    never.stop();
    never.put("toy/a1", 1);
    never.stop();
    Toy source("toy", wait_for_the_end);
    source.put("toy/a1", 1);
    source.start(ear.listener());
    source.put("toy/a1", 2);
    source.stop();
    source.put("toy/a1", 3);
    source.stop();
    EXPECT_EQ(ear.values(), (std::vector<std::string>{"toy/a1 = 2"}));
}

TEST(ThreadedSource, EndsWithItsOwner) {
    Ear ear;
    Toy source("toy", wait_for_the_end);
    source.start(ear.listener());
}

TEST(ThreadedSource, HasTheChannelsOfConnectedBoards) {
    Ear ear;
    BoardHost* shared = nullptr;
    Toy source("toy", [&](BoardHost& host) {
        shared = &host;
        host.connected("toy", "a toy", kChannels);
        host.wait_until(Clock::now() + 1h);
        host.lost("toy", "broken");
        wait_for_the_end(host);
    });
    EXPECT_TRUE(source.channels().empty());
    source.start(ear.listener());
    ASSERT_TRUE(ear.hears_event("toy CONNECTED: a toy"));
    EXPECT_EQ(source.channels().size(), 1u);
    shared->wake();
    ASSERT_TRUE(ear.hears_event("toy LOST: broken"));
    EXPECT_TRUE(source.channels().empty());
}

TEST(ThreadedSource, ReportsABusyBoardOnce) {
    Ear ear;
    Toy source("toy", [](BoardHost& host) {
        for (int i = 0; i < 3; ++i) host.busy("toy", "in use");
        host.busy("toy", "no access");
        host.no_longer_busy("toy");
        host.busy("toy", "no access");
        host.connected("toy", "", kChannels);
        host.busy("toy", "no access");
        wait_for_the_end(host);
    });
    source.start(ear.listener());
    ASSERT_TRUE(ear.hears_events(5));
    EXPECT_EQ(ear.events(), (std::vector<std::string>{"toy BUSY: in use", "toy BUSY: no access",
                                                      "toy BUSY: no access", "toy CONNECTED",
                                                      "toy BUSY: no access"}));
}

TEST(ThreadedSource, AWorkerThatFailsLosesItsBoards) {
    Ear ear;
    Toy connected("toy", [](BoardHost& host) {
        host.connected("toy1", "", kChannels);
        throw std::runtime_error("out of order");
    });
    Toy alone("toy2", [](BoardHost&) { throw std::runtime_error("out of order"); });
    connected.start(ear.listener());
    ASSERT_TRUE(ear.hears_event("toy1 LOST: out of order"));
    EXPECT_TRUE(connected.channels().empty());
    alone.start(ear.listener());
    EXPECT_TRUE(ear.hears_event("toy2 BUSY: out of order"));
}

TEST(ThreadedSource, AWakeIsNotLostBeforeItsWait) {
    BoardHost host("toy");
    host.wake();
    host.wait_until(Clock::now() + 1h);
    const auto begin = Clock::now();
    host.wait_until(begin + 20ms);  // the wake is used up
    EXPECT_GE(Clock::now() - begin, 20ms);
}

}  // namespace
}  // namespace ocean::bridge
