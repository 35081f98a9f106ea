// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "serve.hpp"

#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

#include "command.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/internal/bridge/devices.hpp"
#include "ocean/internal/bridge/hub.hpp"
#include "ocean/internal/bridge/line_server.hpp"
#include "ocean/internal/bridge/script_sources.hpp"

namespace ocean::app {
namespace {

/// Writes the log in a thread of its own: a reader of standard error that stalls must not stall the
/// clients. Lines beyond a limit are left out and counted.
class Log {
  public:
    explicit Log(Console& console) : console_(console), thread_([this] { write(); }) {}
    ~Log() { finish(); }

    void add(std::string line) {
        const std::lock_guard lock(mutex_);
        if (lines_.size() < kMaxLines) {
            lines_.push_back(std::move(line));
        } else {
            ++left_out_;
        }
        changed_.notify_one();
    }

    /// Writes all lines, but waits only kShutdownGrace for a reader that stalls. Returns false if
    /// the reader still blocks the console.
    bool finish() {
        std::unique_lock lock(mutex_);
        if (!thread_.joinable()) return true;
        finished_ = true;
        changed_.notify_one();
        const bool written = done_.wait_for(lock, kShutdownGrace, [this] { return ended_; });
        lock.unlock();
        if (written) {
            thread_.join();
        } else {
            thread_.detach();  // the process ends
        }
        return written;
    }

  private:
    static constexpr std::size_t kMaxLines = 10000;
    static constexpr auto kShutdownGrace = std::chrono::seconds(3);

    void write() {
        std::unique_lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [this] { return finished_ || !lines_.empty(); });
            std::deque<std::string> lines = std::exchange(lines_, {});
            const std::size_t left_out = std::exchange(left_out_, 0);
            if (lines.empty()) break;
            lock.unlock();
            for (const std::string& line : lines) console_.report("log", line, {{"text", line}});
            if (left_out > 0) {
                console_.warning(std::to_string(left_out) + " lines of the log are left out");
            }
            lock.lock();
        }
        ended_ = true;
        done_.notify_all();
    }

    Console& console_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::condition_variable done_;
    std::deque<std::string> lines_;
    std::size_t left_out_ = 0;
    bool finished_ = false;
    bool ended_ = false;
    std::thread thread_;
};

bridge::OscOptions osc_of(const ServeWords& words) {
    constexpr unsigned short kBridge = 9100;
    constexpr unsigned short kTablet = 9000;
    bridge::OscOptions options{.allow = words.osc_allow};
    if (!words.osc.empty()) {
        const bool is_port = words.osc.find_first_not_of("0123456789") == std::string::npos;
        options.listen = bridge::parse_endpoint(is_port ? "127.0.0.1:" + words.osc : words.osc,
                                                "--osc", kBridge);
    }
    for (const std::string& to : words.osc_to) {
        options.to.push_back(bridge::parse_endpoint(to, "--osc-to", kTablet));
    }
    return options;
}

}  // namespace

std::vector<std::unique_ptr<bridge::Source>> file_sources(const ServeWords& words) {
    std::vector<std::unique_ptr<bridge::Source>> sources;
    if (words.dummy) {
        if (words.dummy->ends_with(".toml")) {
            refuse("--dummy " + *words.dummy +
                   ": this would be its script; write the SEA before "
                   "--dummy");
        }
        std::vector<bridge::ScriptLine> script;
        if (!words.dummy->empty()) script = bridge::read_script(*words.dummy);
        sources.push_back(bridge::make_dummy_source(std::move(script)));
    }
    if (!words.replay.empty()) {
        sources.push_back(bridge::make_replay_source(bridge::read_script(words.replay)));
    }
    return sources;
}

Sea sea_of(const ServeWords& words) {
    if (!words.sea.source.empty()) return open_sea(words.sea);
    if (words.sea.assignments.empty()) return {};
    refuse("--set requires a SEA");
}

void serve(const ServeWords& words, const std::string& token, const Context& context) {
    bridge::HubOptions hub_options;
    hub_options.sea = sea_of(words);
    if (!words.dummy && words.replay.empty()) hub_options.devices = bridge::default_devices();
    hub_options.map = words.map;
    if (words.map.empty()) hub_options.map_text = bridge::kDefaultMap;
    bridge::Hub hub(std::move(hub_options), file_sources(words));

    Log log(context.console);
    bridge::ServerOptions options;
    options.listen = bridge::parse_endpoint(words.listen, "--listen");
    options.token = token;
    options.clients = static_cast<std::size_t>(words.clients);
    options.osc = osc_of(words);
    options.log_reports = context.options.verbose;
    options.log = [&log](std::string line) { log.add(std::move(line)); };
    // The server serves clients at once; a signal waits until its last act is known.
    std::optional<InterruptWatch::Hold> starting(std::in_place, context.interrupts);
    bridge::LineServer server(std::move(options), hub);
    const InterruptWatch::LastAct last(context.interrupts, [&] {
        server.stop();
        // A reader that does not read the log blocks every further message.
        if (!log.finish()) std::_Exit(kInterruptedExit);
    });
    starting.reset();
    // All work, and the end, happens in other threads.
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable never;
    never.wait(lock, [] { return false; });
}

}  // namespace ocean::app
