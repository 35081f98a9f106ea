// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "learn.hpp"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>
#include <variant>

#include "command.hpp"
#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/internal/bridge/control_map_file.hpp"
#include "ocean/internal/bridge/devices.hpp"
#include "ocean/internal/bridge/k8055_source.hpp"
#include "ocean/internal/bridge/learner.hpp"
#include "ocean/internal/bridge/midi_source.hpp"
#include "ocean/internal/bridge/source.hpp"

namespace ocean::app {
namespace {

using Message = std::variant<bridge::Report, bridge::BoardEvent>;

/// Hands reports and events from the boards' threads to the main thread.
class MessageQueue {
  public:
    void add(Message message) {
        const std::lock_guard lock(mutex_);
        if (messages_.size() < kMaxMessages) messages_.push_back(std::move(message));
        changed_.notify_one();
    }
    /// Blocks until a message is available or the time is reached. Returns all messages.
    std::deque<Message> wait(std::optional<bridge::Clock::time_point> until) {
        std::unique_lock lock(mutex_);
        const auto is_available = [this] { return !messages_.empty(); };
        if (until) {
            changed_.wait_until(lock, *until, is_available);
        } else {
            changed_.wait(lock, is_available);
        }
        return std::exchange(messages_, {});
    }

  private:
    static constexpr std::size_t kMaxMessages = 65536;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Message> messages_;
};

/// Returns the boards of the map; without a map, each board that can be found without settings.
std::vector<bridge::DeviceRule> devices_of(const ServeWords& words,
                                           const bridge::ValueTable& values) {
    if (!words.map.empty()) {
        return bridge::parse_control_map(bridge::read_map_text(words.map), words.map, values)
            .devices;
    }
    if (words.dummy || !words.replay.empty()) return {};
    return bridge::devices_to_learn();
}

/// Returns the [[device]] of a board that has just connected, or "" for another event. The port of
/// a MIDI controller is the part of its name that stays the same when it is plugged in elsewhere.
std::string device_lines(const bridge::BoardEvent& event,
                         const std::vector<bridge::DeviceRule>& devices) {
    if (event.kind != bridge::BoardEvent::Kind::connected) return "";
    const auto rule = std::ranges::find(devices, event.board, &bridge::DeviceRule::id);
    if (rule == devices.end()) return "";
    const std::string begin = "[[device]]\nid = \"" + rule->id + "\"\ndriver = ";
    if (const auto* board = rule->device.get<bridge::K8055Device>()) {
        return begin + "\"k8055\"\naddress = " + std::to_string(board->address) + "\n";
    }
    if (rule->device.get<bridge::MidiDevice>() != nullptr) {
        // "nanoKONTROL2" of "nanoKONTROL2:nanoKONTROL2 MIDI 1 20:0".
        const std::string port = event.text.substr(0, event.text.find_first_of(":\"\\"));
        return begin + "\"midi\"\nport = \"" + port + "\"\n";
    }
    return "";
}

}  // namespace

void learn(const ServeWords& words, const Context& context) {
    if (!words.osc.empty() || !words.osc_to.empty()) {
        refuse("--learn is for boards; OSC needs no map, its addresses are names");
    }
    const bridge::ValueTable values(sea_of(words).parameters);
    bridge::Learner learner(values, *words.learn);
    const std::vector<bridge::DeviceRule> devices = devices_of(words, values);
    std::vector<std::unique_ptr<bridge::Source>> sources = file_sources(words);
    for (auto& source : bridge::make_sources(devices)) sources.push_back(std::move(source));

    MessageQueue messages;
    const auto stop = [&sources] {
        for (const auto& source : sources) source->stop();
    };
    const InterruptWatch::LastAct last(context.interrupts, stop);
    context.console.report("learn",
                           "move one control at a time: a fader over its range, an endless knob "
                           "slowly in both directions, a button twice",
                           {});
    for (const auto& source : sources) {
        source->start({[&messages](bridge::Report report) { messages.add(std::move(report)); },
                       [&messages](bridge::BoardEvent event) { messages.add(std::move(event)); }});
    }
    const auto channel_of = [&](const std::string& name) -> std::optional<bridge::Channel> {
        for (const auto& source : sources) {
            const std::vector<bridge::Channel> channels = source->channels();
            if (const auto* found = bridge::find_channel(channels, name)) return *found;
        }
        return std::nullopt;
    };
    for (;;) {
        for (const Message& message : messages.wait(learner.next())) {
            if (const auto* report = std::get_if<bridge::Report>(&message)) {
                const auto channel = channel_of(report->channel);
                learner.report(*report, channel ? &*channel : nullptr);
                continue;
            }
            const auto& event = std::get<bridge::BoardEvent>(message);
            const std::string text = event_text(event);
            context.console.report("board", text, {{"text", text}});
            if (!words.map.empty()) continue;
            const std::string lines = device_lines(event, devices);
            if (!lines.empty()) context.console.data(lines);
        }
        for (const bridge::Lesson& lesson : learner.advance(bridge::Clock::now())) {
            if (lesson.is_map) {
                context.console.data(lesson.text);
            } else {
                context.console.report("hint", lesson.text, {{"text", lesson.text}});
            }
        }
    }
}

}  // namespace ocean::app
