// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/midi_source.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "drivers.hpp"
#include "midi_messages.hpp"
#include "midi_ports.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "source_thread.hpp"

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;

// Indices in midi_channels() at which the two kinds of outputs begin.
constexpr std::size_t kLeds = 2 * kMidiNumbers + 1 + kMidiPairs;
constexpr std::size_t kLamps = kLeds + kMidiNumbers;

/// Returns the channel without its board: "cc7" for controller 7.
std::string channel_of(const MidiReport& report) {
    constexpr std::array<std::string_view, 6> kLetters = {"cc", "n", "pb", "pair", "nrpn", "rpn"};
    return std::string(kLetters[static_cast<std::size_t>(report.kind)]) +
           std::to_string(report.number);
}

/// Returns true for ports that are not controllers: the kernel's own loop, and bridges.
bool is_software(const std::string& port) {
    return port.starts_with("Midi Through") || port.starts_with("ocean-bridge");
}

class MidiWorker {
  public:
    MidiWorker(BoardHost& host, std::string id, MidiDevice device, std::unique_ptr<MidiPorts> ports,
               Clock::duration poll_interval)
        : host_(host),
          id_(std::move(id)),
          device_(std::move(device)),
          poll_interval_(poll_interval),
          channels_(midi_channels(id_)),
          ports_(std::move(ports)) {}

    void run() {
        Clock::time_point next_poll = Clock::now();
        while (!host_.is_stopped()) {
            send_requested();
            if (is_due()) report_late();
            if (Clock::now() >= next_poll) {
                poll_ports();
                next_poll = Clock::now() + poll_interval_;
            }
            host_.wait_until(std::min(due(), next_poll));
        }
        if (!port_.empty()) switch_outputs_off();
        ports_->close();
    }

    void wake() const { host_.wake(); }

    void put(const std::string& name, double value) {
        const std::size_t index = output_index(channels_, name, value);
        {
            const std::lock_guard lock(mutex_);
            requested_[index] = static_cast<int>(value + 0.5);
        }
        host_.wake();
    }

  private:
    using Outputs = std::map<std::size_t, int>;  // values by the output's index

    /// Returns the time at which a value that waits for its fine byte is late.
    Clock::time_point due() {
        const std::lock_guard lock(mutex_);
        return due_.value_or(Clock::time_point::max());
    }
    bool is_due() { return Clock::now() >= due(); }

    void poll_ports() {
        try {
            const std::vector<std::string> names = ports_->inputs();
            if (!port_.empty() && !ports_->is_still_connected()) leave();
            if (port_.empty()) join(names);
            host_.no_longer_busy(id_);
        } catch (const Error& error) {
            if (!port_.empty()) leave();
            host_.busy(id_, error.what());
        }
    }

    void leave() {
        ports_->close();
        {
            const std::lock_guard lock(parsing_);
            parser_ = {};
            joiner_ = {};
        }
        port_.clear();
        host_.lost(id_);
    }

    void join(const std::vector<std::string>& names) {
        const auto port = std::ranges::find_if(names, [this](const std::string& name) {
            if (device_.port.empty()) return !is_software(name);
            return lower_case(name).find(lower_case(device_.port)) != std::string::npos;
        });
        if (port == names.end()) return;
        if (!ports_->open(*port, [this](auto bytes) { receive(bytes); })) return;
        port_ = *port;
        host_.connected(id_, text::printable(port_), channels_);
        for (const auto& [index, value] : outputs_) send(index, value);
    }

    /// Runs in the thread of the ports, which exists between open() and close(). Reports each
    /// message, also one that repeats the one before: for an endless knob it is a step.
    void receive(std::span<const std::uint8_t> bytes) {
        const std::lock_guard lock(parsing_);
        const Clock::time_point now = Clock::now();
        for (const MidiReport& report : parser_.feed(bytes)) {
            if (device_.channel != 0 && report.channel != device_.channel) continue;
            report_all(std::span(&report, 1), now);
            report_all(joiner_.take(report, now), now);
        }
        update_due();
    }
    /// Reports values whose fine byte has not come in time.
    void report_late() {
        const std::lock_guard lock(parsing_);
        const Clock::time_point now = Clock::now();
        report_all(joiner_.advance(now), now);
        update_due();
    }
    void report_all(std::span<const MidiReport> reports, Clock::time_point now) const {
        for (const MidiReport& report : reports) {
            host_.report(
                {now, id_ + "/" + channel_of(report), static_cast<double>(report.value), true});
        }
    }
    void update_due() {
        const auto due = joiner_.next();
        {
            const std::lock_guard lock(mutex_);
            if (std::exchange(due_, due) == due) return;
        }
        host_.wake();
    }

    void send_requested() {
        Outputs requested;
        {
            const std::lock_guard lock(mutex_);
            requested.swap(requested_);
        }
        for (const auto& [index, value] : requested) {
            outputs_[index] = value;
            if (!port_.empty()) send(index, value);
        }
    }
    void switch_outputs_off() {
        for (const auto& [index, value] : outputs_) {
            if (value != 0) send(index, 0);
        }
    }
    void send(std::size_t index, int value) {
        const int channel = std::max(device_.channel, 1);
        ports_->send(index < kLamps
                         ? control_change(channel, static_cast<int>(index - kLeds), value)
                         : note_on(channel, static_cast<int>(index - kLamps), value));
    }

    BoardHost& host_;
    const std::string id_;
    const MidiDevice device_;
    const Clock::duration poll_interval_;
    const std::vector<Channel> channels_;
    std::mutex mutex_;                      // guards the two members below
    Outputs requested_;                     // not sent yet
    std::optional<Clock::time_point> due_;  // of a value that waits for its fine byte
    // Used by the source's thread alone.
    std::unique_ptr<MidiPorts> ports_;
    std::string port_;  // name of the open port; "" if none is open
    Outputs outputs_;
    // Held during reports, so that they keep the order of the messages.
    std::mutex parsing_;
    MidiParser parser_;
    MidiJoiner joiner_;
};

MidiDevice read_midi(DeviceSection& section) {
    MidiDevice device;
    section.read_keys({{"port", [&] { device.port = section.text(); }},
                       {"channel", [&] { device.channel = section.whole(1, 16); }}});
    return device;
}

}  // namespace

std::vector<Channel> midi_channels(const std::string& board) {
    std::vector<Channel> channels;
    const auto add = [&](const std::string& letters, double max, bool output) {
        for (int i = 0; i < kMidiNumbers; ++i) {
            channels.push_back({board + "/" + letters + std::to_string(i), 0.0, max, output});
        }
    };
    add("cc", kMidiMax, false);
    add("n", 1.0, false);
    channels.push_back({board + "/pb1", 0.0, kMidiMax14, false});
    for (int i = 0; i < kMidiPairs; ++i) {
        channels.push_back({board + "/pair" + std::to_string(i), 0.0, kMidiMax14, false});
    }
    add("led", kMidiMax, true);
    add("lamp", kMidiMax, true);
    return channels;
}

std::unique_ptr<Source> make_midi_source(std::string id, MidiDevice device,
                                         std::unique_ptr<MidiPorts> ports,
                                         Clock::duration poll_interval) {
    return std::make_unique<ThreadedSource<MidiWorker>>(id, id, std::move(device), std::move(ports),
                                                        poll_interval);
}

std::unique_ptr<Source> make_midi_source(const std::string& id, const MidiDevice& device) {
    return make_midi_source(id, device, system_midi_ports(), 1s);
}

Driver DriverTable::midi() {
    return {read_midi, make_midi_source};
}

}  // namespace ocean::bridge
