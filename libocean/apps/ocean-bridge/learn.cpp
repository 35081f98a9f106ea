// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "learn.hpp"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>
#include <variant>

#include "console.hpp"
#include "interrupt.hpp"
#include "ocean/bridge/devices.hpp"
#include "ocean/bridge/learner.hpp"
#include "ocean/bridge/source.hpp"
#include "ocean/error.hpp"

namespace ocean::app {
namespace {

using News = std::variant<bridge::Report, bridge::BoardEvent>;

/// What the boards' threads say, for the main thread.
class NewsQueue {
  public:
    void add(News news) {
        const std::lock_guard lock(mutex_);
        if (news_.size() < kMost) news_.push_back(std::move(news));
        changed_.notify_one();
    }
    /// Waits for something to be there, or until then.
    std::deque<News> wait(std::optional<bridge::Clock::time_point> until) {
        std::unique_lock lock(mutex_);
        const auto is_there = [this] { return !news_.empty(); };
        if (until) {
            changed_.wait_until(lock, *until, is_there);
        } else {
            changed_.wait(lock, is_there);
        }
        return std::exchange(news_, {});
    }

  private:
    static constexpr std::size_t kMost = 65536;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<News> news_;
};

/// Those of the map; without one each board that can be found without being told where it is.
std::vector<bridge::DeviceRule> devices_of(const ServeWords& words,
                                           const bridge::ValueTable& values) {
    if (!words.map.empty()) {
        return bridge::parse_map(bridge::read_map_text(words.map), words.map, values).devices;
    }
    if (words.dummy || !words.replay.empty()) return {};
    return bridge::devices_to_learn();
}

/// "[[device]]" of a controller that the map does not have yet, once it is connected.
std::string device_lines(const bridge::BoardEvent& event,
                         const std::vector<bridge::DeviceRule>& devices) {
    if (event.kind != bridge::BoardEvent::Kind::connected) return "";
    const auto rule = std::ranges::find(devices, event.board, &bridge::DeviceRule::id);
    if (rule == devices.end()) return "";
    if (const auto* board = std::get_if<bridge::K8055Device>(&rule->device)) {
        return "[[device]]\nid = \"" + rule->id +
               "\"\ndriver = \"k8055\"\naddress = " + std::to_string(board->address) + "\n";
    }
    // "nanoKONTROL2:nanoKONTROL2 MIDI 1 20:0": what stands before the colon stays at another plug.
    const std::string port = event.text.substr(0, event.text.find_first_of(":\"\\"));
    return "[[device]]\nid = \"" + rule->id + "\"\ndriver = \"midi\"\nport = \"" + port + "\"\n";
}

}  // namespace

void learn(const ServeWords& words, const Context& context) {
    if (!words.osc.empty() || !words.osc_to.empty()) {
        throw Error(ErrorKind::invalid_value,
                    "--learn listens to boards alone; OSC needs no map, its addresses are names");
    }
    const bridge::ValueTable values(sea_of(words).parameters);
    bridge::Learner learner(values, *words.learn);
    const std::vector<bridge::DeviceRule> devices = devices_of(words, values);
    std::vector<std::unique_ptr<bridge::Source>> sources = file_sources(words);
    for (auto& source : bridge::make_sources(devices)) sources.push_back(std::move(source));

    NewsQueue news;
    const auto stop = [&sources] {
        for (const auto& source : sources) source->stop();
    };
    const InterruptWatch::LastAct last(context.interrupts, stop);
    context.console.report("learn",
                           "move one control at a time: a fader over its way, an endless knob "
                           "slowly and both ways, a button twice",
                           {});
    for (const auto& source : sources) {
        source->start({[&news](bridge::Report report) { news.add(std::move(report)); },
                       [&news](bridge::BoardEvent event) { news.add(std::move(event)); }});
    }
    const auto channel_of = [&](const std::string& name) -> std::optional<bridge::Channel> {
        for (const auto& source : sources) {
            const std::vector<bridge::Channel> channels = source->channels();
            if (const auto* found = bridge::find_channel(channels, name)) return *found;
        }
        return std::nullopt;
    };
    for (;;) {
        for (const News& one : news.wait(learner.next())) {
            if (const auto* report = std::get_if<bridge::Report>(&one)) {
                const auto channel = channel_of(report->channel);
                learner.report(*report, channel ? &*channel : nullptr);
                continue;
            }
            const auto& event = std::get<bridge::BoardEvent>(one);
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
