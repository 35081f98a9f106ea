// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/bridge/source.hpp"

#include <algorithm>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::bridge {

bool is_channel_name(std::string_view name) {
    constexpr std::size_t kMaxPartBytes = 32;
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
    const std::size_t slash = name.find('/');
    if (slash == std::string_view::npos) return false;
    const std::string_view board = name.substr(0, slash);
    const std::string_view wire = name.substr(slash + 1);
    if (board.empty() || board.size() > kMaxPartBytes || wire.size() > kMaxPartBytes) return false;
    const auto end = std::ranges::find_if_not(wire, letter);
    return std::ranges::all_of(board, [&](char c) { return digit(c) || letter(c) || c == '_'; }) &&
           end != wire.begin() && end != wire.end() && std::all_of(end, wire.end(), digit);
}

std::string event_text(const BoardEvent& event) {
    const auto line = [&event](std::string_view word) {
        return event.board + std::string(word) + (event.text.empty() ? "" : ": " + event.text);
    };
    switch (event.kind) {
        case BoardEvent::Kind::connected:
            return line(" CONNECTED");
        case BoardEvent::Kind::lost:
            return line(" LOST");
        case BoardEvent::Kind::busy:
            return line(" BUSY");
    }
    return event.board;
}

const Channel* find_channel(const std::vector<Channel>& channels, std::string_view name) {
    const auto found = std::ranges::find(channels, name, &Channel::name);
    return found == channels.end() ? nullptr : &*found;
}

void require_in_range(const Channel& channel, double value) {
    if (value >= channel.min && value <= channel.max) return;
    const std::string given = plain_text(value);
    const std::string allowed = plain_text(channel.min) + " .. " + plain_text(channel.max);
    throw Error(ErrorKind::invalid_value, channel.name + " = " + given + ": allowed: " + allowed,
                {.parameter = channel.name, .value = given, .allowed = allowed});
}

std::size_t output_index(const std::vector<Channel>& channels, const std::string& name,
                         double value) {
    const Channel* channel = find_channel(channels, name);
    if (channel == nullptr || !channel->output) {
        throw Error(ErrorKind::invalid_value,
                    {.what = "is not an output of the board", .parameter = name});
    }
    require_in_range(*channel, value);
    return static_cast<std::size_t>(channel - channels.data());
}

}  // namespace ocean::bridge
