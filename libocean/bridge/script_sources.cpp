// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/script_sources.hpp"

#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/bridge/k8055_source.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/line_reader.hpp"
#include "ocean/internal/text.hpp"
#include "source_thread.hpp"

namespace ocean::bridge {
namespace {

constexpr std::size_t kMaxScriptBytes = std::size_t{16} << 20;
constexpr double kMaxSeconds = 1e6;
constexpr double kMaxValue = 1e9;

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
    const auto number = [&](std::string_view word, double min, double max) {
        const std::optional<double> parsed = text::parse_number(word);
        if (parsed && *parsed >= min && *parsed <= max) return *parsed;
        throw refused("'" + text::printable(word) + "' is not a number within " + plain_text(min) +
                      " .. " + plain_text(max));
    };
    ScriptLine line{number(seconds, 0.0, kMaxSeconds), std::string(channel),
                    number(value, -kMaxValue, kMaxValue)};
    if (!before.empty() && line.seconds < before.back().seconds) {
        throw refused("'" + text::printable(seconds) + "' is earlier than the line above");
    }
    if (!is_channel_name(channel)) {
        throw refused("'" + text::printable(channel) + "' is not a channel");
    }
    return line;
}

/// Plays a script.
class ScriptWorker {
  public:
    ScriptWorker(BoardHost& host, std::vector<Channel> channels, std::vector<ScriptLine> script,
                 bool has_positions)
        : host_(host),
          channels_(std::move(channels)),
          script_(std::move(script)),
          has_positions_(has_positions) {
        host_.offer("", channels_);
    }

    /// Reports the positions of all inputs.
    void begin() {
        if (!has_positions_) return;
        for (const Channel& channel : channels_) {
            if (!channel.output) host_.report({Clock::now(), channel.name, 0.0});
        }
    }

    void run() {
        const Clock::time_point begin = Clock::now();
        for (const ScriptLine& line : script_) {
            const auto due = begin + std::chrono::duration_cast<Clock::duration>(
                                         std::chrono::duration<double>(line.seconds));
            while (Clock::now() < due && !host_.is_stopped()) host_.wait_until(due);
            if (host_.is_stopped()) return;
            host_.report({due, line.channel, line.value});
        }
    }

    void wake() {}  // run() waits by the host

    void put(const std::string& name, double value) {
        const Channel* channel = find_channel(channels_, name);
        if (channel == nullptr || !has_positions_) {
            throw Error(ErrorKind::invalid_value, {.what = "cannot be set", .parameter = name});
        }
        require_in_range(*channel, value);
        // An input moves as if by a hand; an output has nothing to report.
        if (!channel->output) host_.report({Clock::now(), name, value});
    }

  private:
    BoardHost& host_;
    const std::vector<Channel> channels_;
    const std::vector<ScriptLine> script_;
    const bool has_positions_;  // the board reports positions, and put() moves its inputs
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
        if (channel == nullptr || channel->output || line.value < channel->min ||
            line.value > channel->max) {
            throw Error(ErrorKind::bad_file,
                        "the dummy board has no input " + line.channel + " with the value " +
                            plain_text(line.value) +
                            "; allowed: board0/a1 and a2 0 .. 255, d1 .. d5 0 or 1, c1 and c2 0 .. "
                            "65535");
        }
    }
    return std::make_unique<ThreadedSource<ScriptWorker>>("script", std::move(channels),
                                                          std::move(script), true);
}

std::unique_ptr<Source> make_replay_source(std::vector<ScriptLine> script) {
    std::vector<Channel> channels;
    for (const ScriptLine& line : script) {
        if (find_channel(channels, line.channel) != nullptr) continue;
        channels.push_back({line.channel, -kMaxValue, kMaxValue, false});
    }
    return std::make_unique<ThreadedSource<ScriptWorker>>("script", std::move(channels),
                                                          std::move(script), false);
}

}  // namespace ocean::bridge
