// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The K8055's source, the real libusb, and a board in umockdev's test bed: whatever happens to a
// board on a bus. Runs under umockdev-wrapper.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

#include "descriptors.hpp"
#include "mock_k8055.hpp"
#include "ocean/internal/bridge/k8055_source.hpp"
#include "refusal.hpp"

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;
using test::open_descriptors;

/// Far beyond what anything takes on a busy machine: a test that runs into it has failed.
constexpr auto kPatience = 120s;

/// Collects the observations of both sides in order.
class Seen {
  public:
    void report(const Report& report) {
        add([&] {
            values[report.channel] = report.value;
            if (report.channel == "board0/c1") counted.push_back(report.value);
        });
    }
    void event(const std::string& text) {
        add([&] { events.push_back(text); });
    }
    void out(const MockK8055::Bytes& bytes) {
        add([&] { outs.push_back(bytes); });
    }
    void sent() {
        add([&] { ++states_sent; });
    }
    void reported() {
        add([&] { ++reports_sent; });
    }
    void refused() {
        add([&] { ++refusals; });
    }
    void kernel_driver(bool is_bound) {
        add([&] { bound.push_back(is_bound); });
    }

    /// False if it does not come true.
    template <typename Condition>
    bool wait(const Condition& condition, std::chrono::milliseconds longest = kPatience) {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, longest, [&] { return condition(); });
    }
    template <typename Function>
    auto look(const Function& function) {
        const std::lock_guard lock(mutex_);
        return function();
    }
    std::size_t events_with(const std::string& word) const {
        return static_cast<std::size_t>(std::ranges::count_if(
            events, [&](const std::string& text) { return text.find(word) != std::string::npos; }));
    }

    std::map<std::string, double> values;
    std::vector<double> counted;
    std::vector<std::string> events;
    std::vector<MockK8055::Bytes> outs;
    std::vector<bool> bound;
    std::size_t states_sent = 0;
    std::size_t reports_sent = 0;
    std::size_t refusals = 0;

  private:
    template <typename Change>
    void add(const Change& change) {
        const std::lock_guard lock(mutex_);
        change();
        changed_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
};

/// A board on the bus, and a source that looks for it.
class Usb : public testing::Test {
  protected:
    ~Usb() override {
        source_->stop();
        ticking_ = false;
        if (clock_.joinable()) clock_.join();
    }

    void start() {
        source_->start({[this](const Report& report) { seen_.report(report); },
                        [this](const BoardEvent& event) { seen_.event(event_text(event)); }});
        clock_ = std::thread([this] {
            while (ticking_) {
                std::this_thread::sleep_for(1ms);  // the time between the board's reports
                ++ticks_;
                if (!silent_) board_.tick();
            }
        });
    }
    bool wait_for(const std::string& word, std::size_t times = 1) {
        return seen_.wait([&] { return seen_.events_with(word) >= times; });
    }
    MockK8055::Bytes last_out() {
        return seen_.look(
            [&] { return seen_.outs.empty() ? MockK8055::Bytes{} : seen_.outs.back(); });
    }
    bool wait_for_out(const MockK8055::Bytes& bytes) {
        return seen_.wait([&] { return !seen_.outs.empty() && seen_.outs.back() == bytes; });
    }

    Seen seen_;
    MockK8055 board_{{.out = [this](const auto& bytes) { seen_.out(bytes); },
                      .sent = [this](auto) { seen_.sent(); },
                      .reported = [this] { seen_.reported(); },
                      .kernel_driver = [this](bool is_bound) { seen_.kernel_driver(is_bound); },
                      .refused = [this] { seen_.refused(); },
                      .error = [](const std::string& what) { ADD_FAILURE() << what; }}};
    std::unique_ptr<Source> source_ =
        make_k8055_source({{"board0", {0}}, {"board1", {1}}, {"left", {3}}});
    std::atomic<bool> ticking_ = true;
    std::atomic<bool> silent_ = false;
    std::atomic<int> ticks_ = 0;
    std::thread clock_;
};

TEST_F(Usb, ABoardThatIsThereIsTakenFromTheKernelAndTellsWhereItIs) {
    board_.set(k8055_report(10, 20, 0b10001, 300, 65535));
    board_.plug();
    start();
    ASSERT_TRUE(wait_for("board0 CONNECTED: K8055 on bus 1, device 2"));
    ASSERT_TRUE(seen_.wait([&] { return seen_.values.size() == 9; }));
    EXPECT_EQ(seen_.values["board0/a1"], 10);
    EXPECT_EQ(seen_.values["board0/a2"], 20);
    EXPECT_EQ(seen_.values["board0/d1"], 1);
    EXPECT_EQ(seen_.values["board0/d2"], 0);
    EXPECT_EQ(seen_.values["board0/d5"], 1);
    EXPECT_EQ(seen_.values["board0/c1"], 300);
    EXPECT_EQ(seen_.values["board0/c2"], 65535);
    EXPECT_EQ(source_->channels().size(), 19);
    EXPECT_EQ(seen_.look([&] { return seen_.bound; }), std::vector<bool>{false});
    source_->stop();
    EXPECT_EQ(seen_.bound, (std::vector<bool>{false, true}));  // as it was found
    EXPECT_EQ(seen_.events.size(), 1);
}

TEST_F(Usb, EveryReportOfAThousandASecondArrivesOnceAndInOrder) {
    board_.plug();
    start();
    ASSERT_TRUE(seen_.wait([&] { return seen_.values.size() == 9; }));
    constexpr std::size_t kReports = 3000;
    for (unsigned i = 1; i <= kReports; ++i) {
        const std::size_t before = seen_.look([&] { return seen_.states_sent; });
        board_.set(k8055_report(0, 0, 0, i, 0));
        ASSERT_TRUE(seen_.wait([&] { return seen_.states_sent > before; }));
    }
    ASSERT_TRUE(seen_.wait([&] { return seen_.counted.size() == kReports + 1; }));
    for (std::size_t i = 0; i <= kReports; ++i) ASSERT_EQ(seen_.counted[i], i);
}

TEST_F(Usb, AStateThatStaysIsReportedOnce) {
    board_.plug();
    start();
    ASSERT_TRUE(seen_.wait([&] { return seen_.values.size() == 9; }));
    const std::size_t before = seen_.look([&] { return seen_.reports_sent; });
    ASSERT_TRUE(seen_.wait([&] { return seen_.reports_sent >= before + 100; }));
    // A report of the hundred would come before this one.
    board_.set(k8055_report(99, 0, 0, 0, 0));
    ASSERT_TRUE(seen_.wait([&] { return seen_.values["board0/a1"] == 99; }));
    EXPECT_EQ(seen_.look([&] { return seen_.counted.size(); }), 1);
}

TEST_F(Usb, OutputsAreWhatTheyWereToldAlsoWhereTheBoardComesLater) {
    start();
    source_->put("board0/dac1", 12);
    source_->put("board0/o1", 1);
    board_.plug();
    ASSERT_TRUE(wait_for("CONNECTED"));
    ASSERT_TRUE(wait_for_out({5, 1, 12, 0, 0, 0, 0, 0}));
    source_->put("board0/o8", 1);
    source_->put("board0/dac2", 255);
    ASSERT_TRUE(wait_for_out({5, 0x81, 12, 255, 0, 0, 0, 0}));
    board_.unplug();
    ASSERT_TRUE(wait_for("board0 LOST: unplugged"));
    EXPECT_TRUE(source_->channels().empty());
    const std::size_t before = seen_.look([&] { return seen_.outs.size(); });
    board_.plug();
    ASSERT_TRUE(wait_for("CONNECTED", 2));
    ASSERT_TRUE(seen_.wait([&] { return seen_.outs.size() == before + 1; }));
    EXPECT_EQ(last_out(), (MockK8055::Bytes{5, 0x81, 12, 255, 0, 0, 0, 0}));
    board_.unplug();
    ASSERT_TRUE(wait_for("board0 LOST", 2));
    source_->put("board0/o1", 0);
    board_.plug();
    ASSERT_TRUE(wait_for_out({5, 0x80, 12, 255, 0, 0, 0, 0}));
    EXPECT_EQ(seen_.look([&] { return seen_.outs.size(); }), before + 2);
    source_->stop();
    EXPECT_EQ(last_out(), (MockK8055::Bytes{5, 0, 0, 0, 0, 0, 0, 0}));  // nothing stays lit
}

TEST_F(Usb, ManyChangesAreFewReportsAndTheLastOneCounts) {
    board_.plug();
    start();
    ASSERT_TRUE(wait_for("CONNECTED"));
    for (int i = 0; i <= 255; ++i) source_->put("board0/dac1", i);
    ASSERT_TRUE(wait_for_out({5, 0, 255, 0, 0, 0, 0, 0}));
    EXPECT_LE(seen_.look([&] { return seen_.outs.size(); }), 258);
}

TEST_F(Usb, WhatNoOutputTakesIsRefused) {
    start();
    for (const auto& [channel, value] :
         std::vector<std::pair<std::string, double>>{{"board0/dac1", 256},
                                                     {"board0/dac1", -1},
                                                     {"board0/o1", 2},
                                                     {"board0/a1", 1},
                                                     {"board0/dac1", NAN},
                                                     {"board0/dac3", 1},
                                                     {"other/dac1", 1}}) {
        ocean::test::expect_refusal(
            ErrorKind::invalid_value, channel,
            [this, &channel = channel, value = value] { source_->put(channel, value); });
    }
}

TEST_F(Usb, ABoardIsNamedByItsJumpersAndOthersAreLeftAlone) {
    start();
    board_.plug(2);
    // A source that leaves a board alone says nothing, so that there is no state to wait for.
    std::this_thread::sleep_for(100ms);
    EXPECT_TRUE(seen_.look([&] { return seen_.bound.empty() && seen_.events.empty(); }));
    board_.unplug();
    board_.plug(3);
    ASSERT_TRUE(wait_for("left CONNECTED"));
    ASSERT_TRUE(seen_.wait([&] { return seen_.values.contains("left/c2"); }));
    EXPECT_TRUE(seen_.look([&] { return seen_.bound.size() == 1 && seen_.events.size() == 1; }));
    EXPECT_EQ(source_->channels().front().name, "left/a1");
}

TEST_F(Usb, ABoardOfAnotherProgramIsSaidOnceAndTakenWhenItIsFree) {
    board_.refuse(true);
    board_.plug();
    start();
    ASSERT_TRUE(wait_for("board0 BUSY: another program has it"));
    ASSERT_TRUE(seen_.wait([&] { return seen_.refusals >= 2; }));
    board_.refuse(false);
    EXPECT_TRUE(wait_for("board0 CONNECTED"));
    EXPECT_EQ(seen_.look([&] { return seen_.events.size(); }), 2);
}

TEST_F(Usb, ATransferThatFailsLosesTheBoardUntilItIsOpenedAnew) {
    board_.plug();
    start();
    ASSERT_TRUE(seen_.wait([&] { return seen_.values.size() == 9; }));
    // The clock's thread may have taken the one that flew.
    const auto end = Clock::now() + kPatience;
    while (!seen_.wait([&] { return seen_.events.size() >= 2; }, 5ms) && Clock::now() < end) {
        board_.stall();
    }
    EXPECT_EQ(seen_.look([&] { return seen_.events.at(1); }),
              "board0 LOST: it refuses the transfer");
    EXPECT_TRUE(wait_for("CONNECTED", 2));
}

TEST_F(Usb, AReportOfAnotherLengthIsLeftOut) {
    board_.plug();
    start();
    ASSERT_TRUE(seen_.wait([&] { return seen_.values.size() == 9; }));
    const std::size_t before = seen_.look([&] { return seen_.states_sent; });
    board_.set({0, 1, 77});
    ASSERT_TRUE(seen_.wait([&] { return seen_.states_sent > before; }));
    board_.set(k8055_report(99, 0, 0, 0, 0));
    ASSERT_TRUE(seen_.wait([&] { return seen_.values["board0/a1"] == 99; }));
    EXPECT_EQ(seen_.look([&] { return seen_.events.size(); }), 1);
}

TEST_F(Usb, TheEndIsPrompt) {
    board_.plug();
    start();
    ASSERT_TRUE(wait_for("CONNECTED"));
    // No report wakes it up; by itself it would look in two seconds. The board's clock is the
    // measure, which a busy machine holds up as well.
    ASSERT_TRUE(wait_for_out({5, 0, 0, 0, 0, 0, 0, 0}));
    silent_ = true;
    for (const int asleep = ticks_ + 50; ticks_ < asleep;) std::this_thread::sleep_for(1ms);
    const int before = ticks_;
    source_->stop();
    EXPECT_LT(ticks_ - before, 1000);
    source_->put("board0/o1", 1);  // of a source that has stopped: nothing
    source_->stop();
}

class UsbReplug : public Usb {};

TEST_F(UsbReplug, LeavesNothingBehindAndLosesNothing) {
    constexpr unsigned kCycles = 200;
    board_.plug();
    start();
    ASSERT_TRUE(wait_for("CONNECTED"));
    const std::size_t before = open_descriptors();
    for (unsigned i = 1; i <= kCycles; ++i) {
        board_.unplug();
        ASSERT_TRUE(wait_for("LOST", i));
        board_.set(k8055_report(0, 0, 0, i, 0));
        board_.plug();
        ASSERT_TRUE(wait_for("CONNECTED", i + 1));
        ASSERT_TRUE(seen_.wait([&] { return seen_.values["board0/c1"] == i; }));
    }
    board_.close_unplugged();
    // umockdev closes a socket of its own in a while.
    const auto end = Clock::now() + kPatience;
    while (open_descriptors() > before && Clock::now() < end) std::this_thread::sleep_for(1ms);
    EXPECT_LE(open_descriptors(), before);
    EXPECT_EQ(seen_.look([&] { return seen_.events.size(); }), 2 * kCycles + 1);
}

TEST_F(UsbReplug, AStormEndsWithABoardThatWorks) {
    board_.plug();
    start();
    for (int i = 0; i < 30; ++i) {  // the pauses are the storm
        board_.unplug(std::chrono::milliseconds(i % 3));
        std::this_thread::sleep_for(std::chrono::milliseconds(i % 7));
        board_.plug();
        std::this_thread::sleep_for(std::chrono::milliseconds(i % 5));
    }
    board_.set(k8055_report(200, 0, 0, 0, 0));
    EXPECT_TRUE(seen_.wait([&] { return seen_.values["board0/a1"] == 200; }));
}

}  // namespace
}  // namespace ocean::bridge
