// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/bridge/script_sources.hpp"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include "ocean/bridge/k8055_source.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/line_reader.hpp"
#include "ocean/text.hpp"

namespace ocean::bridge {
namespace {

constexpr std::size_t kMaxScriptBytes = std::size_t{16} << 20;
constexpr double kLongestScript = 1e6;  // s
constexpr double kLargestValue = 1e9;

ScriptLine script_line(std::string_view text, const std::vector<ScriptLine>& before) {
    const auto refused = [](const std::string& message) {
        return Error(ErrorKind::bad_file,
                     message + "; allowed: SECONDS CHANNEL VALUE, such as 0.5 board0/a1 128");
    };
    const std::string_view seconds = next_word(text);
    const std::string_view channel = next_word(text);
    const std::string_view value = next_word(text);
    if (value.empty()) throw refused("a line of a script has three words");
    if (const std::string_view more = next_word(text); !more.empty()) {
        throw refused("'" + text::printable(more) + "' is one word too many");
    }
    const auto number = [&](std::string_view word, double lowest, double highest) {
        const std::optional<double> parsed = text::parse_number(word);
        if (parsed && *parsed >= lowest && *parsed <= highest) return *parsed;
        throw refused("'" + text::printable(word) + "' is not a number within " +
                      plain_text(lowest) + " .. " + plain_text(highest));
    };
    ScriptLine line{number(seconds, 0.0, kLongestScript), std::string(channel),
                    number(value, -kLargestValue, kLargestValue)};
    if (!before.empty() && line.seconds < before.back().seconds) {
        throw refused("'" + text::printable(seconds) + "' is before the line above");
    }
    if (!is_channel_name(channel)) {
        throw refused("'" + text::printable(channel) + "' is no channel");
    }
    return line;
}

/// Plays a script in a thread of its own.
class ScriptSource : public Source {
  public:
    ScriptSource(std::vector<Channel> channels, std::vector<ScriptLine> script, bool has_places)
        : channels_(std::move(channels)), script_(std::move(script)), has_places_(has_places) {}
    ~ScriptSource() override { stop(); }

    std::vector<Channel> channels() const override { return channels_; }

    void start(Listener listener) override {
        listener_ = std::move(listener);
        if (has_places_) {
            for (const Channel& channel : channels_) {
                if (!channel.output) listener_.report({Clock::now(), channel.name, 0.0});
            }
        }
        if (!script_.empty()) thread_ = std::thread([this] { play(); });
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
        const Channel* channel = find_channel(channels_, name);
        if (channel == nullptr || !has_places_) {
            throw Error(ErrorKind::invalid_value, {.what = "cannot be told", .parameter = name});
        }
        require_in_range(*channel, value);
        {
            const std::lock_guard lock(mutex_);
            if (stopped_ || !listener_.report) return;
        }
        // A hand on the knob. A lamp has nothing to report.
        if (!channel->output) listener_.report({Clock::now(), name, value});
    }

  private:
    void play() {
        const Clock::time_point begin = Clock::now();
        for (const ScriptLine& line : script_) {
            const auto due = begin + std::chrono::duration_cast<Clock::duration>(
                                         std::chrono::duration<double>(line.seconds));
            {
                std::unique_lock lock(mutex_);
                if (changed_.wait_until(lock, due, [this] { return stopped_; })) return;
            }
            listener_.report({due, line.channel, line.value});
        }
    }

    const std::vector<Channel> channels_;
    const std::vector<ScriptLine> script_;
    const bool has_places_;  // it tells where its knobs are, and takes what it is told
    Listener listener_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool stopped_ = false;
    std::thread thread_;
};

}  // namespace

std::vector<ScriptLine> parse_script(std::string_view content, const std::string& name) {
    std::vector<ScriptLine> script;
    LineReader lines(content, name);
    while (lines.next()) {
        const std::string_view line = lines.line().substr(0, lines.line().find('#'));
        if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
        try {
            script.push_back(script_line(line, script));
        } catch (const Error& error) {
            throw lines.fail(error.what());
        }
    }
    return script;
}

std::vector<ScriptLine> read_script(const std::string& path) {
    return parse_script(text::read_file(path, kMaxScriptBytes), path);
}

std::unique_ptr<Source> make_dummy_source(std::vector<ScriptLine> script) {
    std::vector<Channel> channels = k8055_channels("board0");
    for (const ScriptLine& line : script) {
        const Channel* channel = find_channel(channels, line.channel);
        if (channel == nullptr || channel->output || line.value < channel->lowest ||
            line.value > channel->highest) {
            throw Error(ErrorKind::bad_file,
                        "the dummy board has no input " + line.channel + " that can be " +
                            plain_text(line.value) +
                            "; allowed: board0/a1 and a2 0 .. 255, d1 .. d5 0 or 1, c1 and c2 0 .. "
                            "65535");
        }
    }
    return std::make_unique<ScriptSource>(std::move(channels), std::move(script), true);
}

std::unique_ptr<Source> make_replay_source(std::vector<ScriptLine> script) {
    std::vector<Channel> channels;
    for (const ScriptLine& line : script) {
        if (find_channel(channels, line.channel) != nullptr) continue;
        channels.push_back({line.channel, -kLargestValue, kLargestValue, false});
    }
    return std::make_unique<ScriptSource>(std::move(channels), std::move(script), false);
}

}  // namespace ocean::bridge
