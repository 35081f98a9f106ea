// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A Velleman K8055 that is not there: umockdev's test bed with the kernel's side of usbfs, for the
// real libusb. The process runs under umockdev-wrapper.
#pragma once

#include <umockdev.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <vector>

class MockK8055 {
  public:
    using Clock = std::chrono::steady_clock;
    using Bytes = std::vector<std::uint8_t>;

    /// Observations of the program, called from any thread.
    struct Witness {
        std::function<void(const Bytes&)> out = [](const Bytes&) {};
        std::function<void(Clock::time_point)> sent = [](Clock::time_point) {};  // a new state
        std::function<void()> reported = [] {};                                  // any state
        std::function<void(bool)> kernel_driver = [](bool) {};                   // is bound
        std::function<void()> refused = [] {};                                   // a claim
        std::function<void(const std::string&)> error = [](const std::string&) {};
    };

    explicit MockK8055(Witness witness);
    ~MockK8055();
    MockK8055(const MockK8055&) = delete;
    MockK8055& operator=(const MockK8055&) = delete;

    void plug(int address = 0);
    /// Transfers end first, and after `news` the system tells of it: 30 ms and more in a real one.
    void unplug(std::chrono::milliseconds news = std::chrono::milliseconds(10));
    /// Closes the sockets by which umockdev answered for nodes that were unplugged. A program that
    /// is opening one at that moment is aborted by umockdev: call it when there is none.
    void close_unplugged();
    /// Sets the report from the next tick on.
    void set(const Bytes& report);
    /// Its own clock, every 10 ms in a real one: a report that is waited for is sent.
    void tick();
    /// The next report fails.
    void stall();
    /// Sets if the board refuses the program's claim.
    void refuse(bool refused);

  private:
    struct Transfer;

    std::string description(int address) const;
    void make_pipe();
    void show_ready(bool ready) const;
    void finish(Transfer& transfer, int status) const;
    static gboolean on_ioctl(UMockdevIoctlBase* node, UMockdevIoctlClient* client, gpointer self);
    /// Returns false of a node that was unplugged, also if the board has another one since.
    bool is_there(const UMockdevIoctlBase* node) const;
    long answer(const UMockdevIoctlBase* node, gulong request, UMockdevIoctlData* argument);
    long switch_driver(int code);
    long submit(const UMockdevIoctlBase* node, UMockdevIoctlData* argument);
    long reap(const UMockdevIoctlBase* node, UMockdevIoctlData* argument);
    long discard(gulong address);

    const Witness witness_;
    UMockdevTestbed* bed_;
    std::vector<UMockdevIoctlBase*> handlers_;  // one for each node, the last one's last
    std::string root_;
    std::string node_;
    std::vector<std::string> unplugged_;  // nodes whose sockets are still there
    int number_ = 1;
    int pipe_ = -1;

    std::mutex mutex_;
    std::list<Transfer> transfers_;
    Bytes report_ = {0, 1, 0, 0, 0, 0, 0, 0};
    bool is_new_ = true;
    bool plugged_ = false;
    bool kernel_driver_ = true;
    bool claimed_ = false;
    bool refused_ = false;
};

/// The report of that state; DIGITAL has bit 0 for input 1.
MockK8055::Bytes k8055_report(unsigned a1, unsigned a2, unsigned digital, unsigned c1, unsigned c2);
