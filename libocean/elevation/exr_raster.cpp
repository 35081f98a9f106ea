// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The channel of an OpenEXR image that is heights: see exr_raster.hpp.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfThreading.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <set>
#include <string_view>

#include "exr_raster.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::elevation {
namespace {

/// The channel of heights, and others that may be it: they must repeat it, or be 0 throughout.
struct HeightChannels {
    std::string chosen;
    std::vector<std::string> others;
};

std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    });
    return lower;
}

/// The names of an image's channels, by what they say.
class ChannelNames {
  public:
    explicit ChannelNames(const Imf::ChannelList& channels) {
        for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
            names_.emplace_back(channel.name());
            spelled_.insert(lower_case(channel.name()));
        }
    }
    std::size_t size() const { return names_.size(); }
    std::string listed() const {
        std::string list;
        for (const std::string& name : names_) {
            list += (list.empty() ? "" : ", ") + text::printable(name, 40);
        }
        return text::printable(list, 200);
    }

    /// Returns the channels that may be heights: one that says so, else one that images keep them
    /// in with the rest of its colour, else any. Alpha never is.
    HeightChannels heights() const {
        std::vector<std::string> found = select({"height", "elevation"});
        if (found.empty()) found = select({"z", "y", "depth", "r"});
        if (found.empty()) found = select({});
        for (std::size_t i = 0, named = found.size(); i < named; ++i) {
            if (last_word(found[i]) != "r") continue;
            for (const std::string& name : names_) {
                const bool same_layer = layer(name) == layer(found[i]);
                const std::string word = last_word(name);
                if (same_layer && (word == "g" || word == "b")) found.push_back(name);
            }
        }
        if (found.empty()) throw RasterFault("has no channel of heights, only " + listed());
        return {found.front(), {found.begin() + 1, found.end()}};
    }

  private:
    static std::string layer(std::string_view name) {
        const std::size_t point = name.rfind('.');
        return lower_case(name.substr(0, point == name.npos ? 0 : point + 1));
    }
    static std::string last_word(const std::string& name) {
        return lower_case(name).substr(layer(name).size());
    }
    /// Returns the channels with one of the words as last part of their names, all without words.
    /// X, Y and Z of one layer are a vector, no heights.
    std::vector<std::string> select(std::initializer_list<std::string_view> words) const {
        std::vector<std::string> chosen;
        for (const std::string& name : names_) {
            const std::string word = last_word(name);
            constexpr std::array<std::string_view, 5> kAlpha = {"a", "alpha", "ar", "ag", "ab"};
            if (std::ranges::find(kAlpha, word) != kAlpha.end()) continue;
            if (words.size() > 0 && std::ranges::find(words, word) == words.end()) continue;
            const bool of_vector =
                (word == "y" || word == "z") && spelled_.contains(layer(name) + "x");
            if (words.size() == 0 || !of_vector) chosen.push_back(name);
        }
        return chosen;
    }

    std::vector<std::string> names_;
    std::set<std::string> spelled_;
};

/// A channel that must repeat the heights, or be 0 throughout.
struct OtherChannel {
    std::vector<float> row;
    bool repeats = true;
    bool is_zero = true;

    void compare(std::span<const float> heights) {
        repeats = repeats && std::memcmp(row.data(), heights.data(), heights.size_bytes()) == 0;
        is_zero = is_zero && std::ranges::all_of(row, [](float value) { return value == 0.0f; });
    }
};

void read_image(Imf::InputFile& file, const RasterReceiver& receiver) {
    const Imath::Box2i window = file.header().dataWindow();
    RasterFacts facts;
    facts.columns = std::int64_t{window.max.x} - window.min.x + 1;
    facts.rows = std::int64_t{window.max.y} - window.min.y + 1;
    require_sides(facts.columns, facts.rows);
    const ChannelNames names(file.header().channels());
    const HeightChannels channels = names.heights();
    if (names.size() > 1) {
        facts.notes.push_back("the heights are those of the channel " +
                              text::printable(channels.chosen) + " of " + names.listed());
    }
    receiver.begin(facts);
    Imf::FrameBuffer buffer;
    const auto insert = [&](const std::string& name, std::vector<float>& row) {
        row.resize(static_cast<std::size_t>(facts.columns));
        // A stride of 0 between rows: each one is read into the same memory.
        buffer.insert(name, Imf::Slice(Imf::FLOAT,
                                       reinterpret_cast<char*>(row.data()) -
                                           std::ptrdiff_t{window.min.x} *
                                               static_cast<std::ptrdiff_t>(sizeof(float)),
                                       sizeof(float), 0));
    };
    std::vector<float> row;
    std::vector<OtherChannel> others(channels.others.size());
    insert(channels.chosen, row);
    for (std::size_t i = 0; i < others.size(); ++i) insert(channels.others[i], others[i].row);
    file.setFrameBuffer(buffer);
    for (int y = window.min.y; y <= window.max.y; ++y) {
        file.readPixels(y);
        for (OtherChannel& other : others) {
            other.compare(row);
            if (other.repeats || other.is_zero) continue;
            throw RasterFault("has the channels " + names.listed() +
                              ", of which several may be the heights, and they differ; keep one of "
                              "them, or call it 'height'");
        }
        receiver.row(row);
    }
}

}  // namespace

void read_exr(const std::string& path, const RasterReceiver& receiver) {
    try {
        Imf::setGlobalThreadCount(0);
        Imf::InputFile file(path.c_str(), 0);
        read_image(file, receiver);
    } catch (const RasterFault&) {
        throw;
    } catch (const std::exception& error) {
        throw RasterFault("is no whole EXR file: " + text::printable(error.what(), 200));
    }
}

}  // namespace ocean::elevation
