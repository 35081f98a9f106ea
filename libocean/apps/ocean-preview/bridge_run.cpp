// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "bridge_run.hpp"

#include <chrono>

#include "bridge_link.hpp"
#include "ocean/error.hpp"

namespace ocean::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kStep{20};
constexpr std::chrono::seconds kMaxJoinTime{3};

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

void run_with_bridge(const bridge::LineClientOptions& options, double seconds, LiveSea& sea,
                     Console& console, const std::function<void(double milliseconds)>& changed) {
    BridgeLink link(options, {.record = [](bool, const std::string&) {}});
    const Clock::time_point start = Clock::now();
    while (!link.joined() && Clock::now() - start < kMaxJoinTime) {
        link.wait_and_apply(sea, kStep);
    }
    const auto note_log = [&] {
        for (const std::string& line : link.extract_log()) console.note("bridge: " + line);
    };
    note_log();
    if (!link.joined()) {
        throw Error(ErrorKind::output, "no bridge answers at " + options.server.text());
    }
    sea.settle();
    changed(milliseconds_since(start));
    const Clock::time_point joined = Clock::now();
    while (std::chrono::duration<double>(Clock::now() - joined).count() < seconds) {
        const bool moved = link.wait_and_apply(sea, kStep);
        note_log();
        if (!moved) continue;
        const Clock::time_point heard = Clock::now();
        sea.settle();
        changed(milliseconds_since(heard));
    }
}

}  // namespace ocean::app
