// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/midi_source.hpp"

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "midi_messages.hpp"
#include "midi_source_of_ports.hpp"
#include "ocean/checked_text.hpp"
#include "ocean/error.hpp"

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;

// Where each kind begins among midi_channels().
constexpr std::size_t kControllers = 0;
constexpr std::size_t kNotes = kControllers + kMidiNumbers;
constexpr std::size_t kBend = kNotes + kMidiNumbers;
constexpr std::size_t kLeds = kBend + 1;
constexpr std::size_t kLamps = kLeds + kMidiNumbers;

std::size_t index_of(const MidiReport& report) {
    const auto number = static_cast<std::size_t>(report.number);
    if (report.kind == MidiKind::bend) return kBend;
    return (report.kind == MidiKind::note ? kNotes : kControllers) + number;
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
            lock.unlock();
            for (const auto& [index, value] : orders) tell(index, value);
            if (Clock::now() >= next_look) {
                look_around();
                next_look = Clock::now() + look_;
            }
            lock.lock();
            changed_.wait_until(lock, next_look, [this] { return stopped_ || !orders_.empty(); });
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
            const std::string trouble = id_ + " BUSY: " + error.what();
            if (std::exchange(trouble_, trouble) != trouble) listener_.event(trouble);
        }
    }

    void be_there(bool whether) {
        const std::lock_guard lock(mutex_);
        there_ = whether;
    }

    void leave() {
        ports_->close();
        open_.clear();
        be_there(false);
        listener_.event(id_ + std::string(kLost));
    }

    void join(const std::vector<std::string>& names) {
        const auto port = std::ranges::find_if(names, [this](const std::string& name) {
            if (device_.port.empty()) return !is_software(name);
            return small(name).find(small(device_.port)) != std::string::npos;
        });
        if (port == names.end()) return;
        parser_ = {};
        places_.clear();
        if (!ports_->open(*port, [this](auto bytes) { receive(bytes); })) return;
        open_ = *port;
        be_there(true);
        listener_.event(id_ + std::string(kConnected) + ": " + text::printable(open_));
        for (const auto& [index, value] : told_) send(index, value);
    }

    /// In the ports' thread, which lives between open() and close().
    void receive(std::span<const std::uint8_t> bytes) {
        for (const MidiReport& report : parser_.feed(bytes)) {
            if (device_.channel != 0 && report.channel != device_.channel) continue;
            const std::size_t index = index_of(report);
            const auto [place, is_new] = places_.try_emplace(index, report.value);
            if (!is_new && std::exchange(place->second, report.value) == report.value) continue;
            listener_.report(
                {Clock::now(), channels_[index].name, static_cast<double>(report.value), true});
        }
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
    Orders orders_;  // not told yet
    // Of the source's thread.
    std::unique_ptr<MidiPorts> ports_;
    std::string open_;     // the port's name
    std::string trouble_;  // that was said
    Orders told_;
    // Of the ports' thread.
    MidiParser parser_;
    Orders places_;
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
    channels.push_back({board + "/pb1", 0.0, kBendHighest, false});
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
