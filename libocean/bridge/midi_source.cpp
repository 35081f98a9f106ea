// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/midi_source.hpp"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "midi_joiner.hpp"
#include "midi_messages.hpp"
#include "midi_source_of_ports.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;

// Where the outputs begin among midi_channels().
constexpr std::size_t kLeds = 2 * kMidiNumbers + 1 + kMidiPairs;
constexpr std::size_t kLamps = kLeds + kMidiNumbers;

/// "cc7" of controller 7.
std::string channel_of(const MidiReport& report) {
    constexpr std::array<std::string_view, 6> kLetters = {"cc", "n", "pb", "pair", "nrpn", "rpn"};
    return std::string(kLetters[static_cast<std::size_t>(report.kind)]) +
           std::to_string(report.number);
}

/// Ports that are no controllers: the kernel's own loop, and bridges.
bool is_software(const std::string& port) {
    return port.starts_with("Midi Through") || port.starts_with("ocean-bridge");
}

std::string small(std::string text) {
    for (char& c : text) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return text;
}

class MidiSource : public Source {
  public:
    MidiSource(std::string id, MidiDevice device, std::unique_ptr<MidiPorts> ports,
               Clock::duration look)
        : id_(std::move(id)),
          device_(std::move(device)),
          look_(look),
          channels_(midi_channels(id_)),
          ports_(std::move(ports)) {}
    ~MidiSource() override { stop(); }

    std::vector<Channel> channels() const override {
        const std::lock_guard lock(mutex_);
        return there_ ? channels_ : std::vector<Channel>();
    }

    void start(Listener listener) override {
        listener_ = std::move(listener);
        thread_ = std::thread([this] { run(); });
    }

    void stop() override {
        {
            const std::lock_guard lock(mutex_);
            stopped_ = true;
        }
        changed_.notify_all();
        if (thread_.joinable()) thread_.join();
    }

    void put(const std::string& name, double value) override {
        const std::size_t index = output_index(channels_, name, value);
        {
            const std::lock_guard lock(mutex_);
            orders_[index] = static_cast<int>(value + 0.5);
        }
        changed_.notify_all();
    }

  private:
    using Orders = std::map<std::size_t, int>;  // by the output's index

    void run() {
        Clock::time_point next_look = Clock::now();
        std::unique_lock lock(mutex_);
        while (!stopped_) {
            const Orders orders = std::exchange(orders_, {});
            const bool is_due = due_ && Clock::now() >= *due_;
            lock.unlock();
            for (const auto& [index, value] : orders) tell(index, value);
            if (is_due) report_late();
            if (Clock::now() >= next_look) {
                look_around();
                next_look = Clock::now() + look_;
            }
            lock.lock();
            if (stopped_ || !orders_.empty()) continue;
            changed_.wait_until(lock, due_ ? std::min(*due_, next_look) : next_look);
        }
        lock.unlock();
        if (!open_.empty()) put_out();
        ports_->close();
    }

    void look_around() {
        try {
            const std::vector<std::string> names = ports_->inputs();
            if (!open_.empty() && !ports_->is_still_there()) leave();
            if (open_.empty()) join(names);
            trouble_.clear();
        } catch (const Error& error) {
            if (!open_.empty()) leave();
            const std::string trouble = error.what();
            if (std::exchange(trouble_, trouble) == trouble) return;
            listener_.event({BoardEvent::Kind::busy, id_, trouble});
        }
    }

    void be_there(bool whether) {
        const std::lock_guard lock(mutex_);
        there_ = whether;
    }

    void leave() {
        ports_->close();
        {
            const std::lock_guard hearing(hearing_);
            parser_ = {};
            joiner_ = {};
        }
        open_.clear();
        be_there(false);
        listener_.event({BoardEvent::Kind::lost, id_});
    }

    void join(const std::vector<std::string>& names) {
        const auto port = std::ranges::find_if(names, [this](const std::string& name) {
            if (device_.port.empty()) return !is_software(name);
            return small(name).find(small(device_.port)) != std::string::npos;
        });
        if (port == names.end()) return;
        if (!ports_->open(*port, [this](auto bytes) { receive(bytes); })) return;
        open_ = *port;
        be_there(true);
        listener_.event({BoardEvent::Kind::connected, id_, text::printable(open_)});
        for (const auto& [index, value] : told_) send(index, value);
    }

    /// In the ports' thread, which lives between open() and close(). Each message is told, also one
    /// that says the same as that before: of an endless knob that is a step.
    void receive(std::span<const std::uint8_t> bytes) {
        const std::lock_guard hearing(hearing_);
        const Clock::time_point now = Clock::now();
        for (const MidiReport& report : parser_.feed(bytes)) {
            if (device_.channel != 0 && report.channel != device_.channel) continue;
            report_all(std::span(&report, 1), now);
            report_all(joiner_.take(report, now), now);
        }
        set_due();
    }
    void report_late() {
        const std::lock_guard hearing(hearing_);
        const Clock::time_point now = Clock::now();
        report_all(joiner_.advance(now), now);
        set_due();
    }
    void report_all(std::span<const MidiReport> reports, Clock::time_point now) const {
        for (const MidiReport& report : reports) {
            listener_.report(
                {now, id_ + "/" + channel_of(report), static_cast<double>(report.value), true});
        }
    }
    void set_due() {
        const auto due = joiner_.next();
        {
            const std::lock_guard lock(mutex_);
            if (std::exchange(due_, due) == due) return;
        }
        changed_.notify_all();
    }

    void tell(std::size_t index, int value) {
        told_[index] = value;
        if (!open_.empty()) send(index, value);
    }
    void put_out() {
        for (const auto& [index, value] : told_) {
            if (value != 0) send(index, 0);
        }
    }
    void send(std::size_t index, int value) {
        const int channel = std::max(device_.channel, 1);
        ports_->send(index < kLamps
                         ? control_change(channel, static_cast<int>(index - kLeds), value)
                         : note_on(channel, static_cast<int>(index - kLamps), value));
    }

    const std::string id_;
    const MidiDevice device_;
    const Clock::duration look_;
    const std::vector<Channel> channels_;
    Listener listener_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    bool stopped_ = false;
    bool there_ = false;
    Orders orders_;                         // not told yet
    std::optional<Clock::time_point> due_;  // of a value that waits for its fine byte
    // Of the source's thread.
    std::unique_ptr<MidiPorts> ports_;
    std::string open_;     // the port's name
    std::string trouble_;  // that was said
    Orders told_;
    // Held while something is reported, so that nothing overtakes what came before it.
    std::mutex hearing_;
    MidiParser parser_;
    MidiJoiner joiner_;
    std::thread thread_;
};

}  // namespace

std::vector<Channel> midi_channels(const std::string& board) {
    std::vector<Channel> channels;
    const auto add = [&](const std::string& letters, double highest, bool output) {
        for (int i = 0; i < kMidiNumbers; ++i) {
            channels.push_back({board + "/" + letters + std::to_string(i), 0.0, highest, output});
        }
    };
    add("cc", kMidiHighest, false);
    add("n", 1.0, false);
    channels.push_back({board + "/pb1", 0.0, kMidiWidest, false});
    for (int i = 0; i < kMidiPairs; ++i) {
        channels.push_back({board + "/pair" + std::to_string(i), 0.0, kMidiWidest, false});
    }
    add("led", kMidiHighest, true);
    add("lamp", kMidiHighest, true);
    return channels;
}

std::unique_ptr<Source> make_midi_source(std::string id, MidiDevice device,
                                         std::unique_ptr<MidiPorts> ports, Clock::duration look) {
    return std::make_unique<MidiSource>(std::move(id), std::move(device), std::move(ports), look);
}

std::unique_ptr<Source> make_midi_source(const std::string& id, const MidiDevice& device) {
    return make_midi_source(id, device, system_midi_ports(), 1s);
}

}  // namespace ocean::bridge
