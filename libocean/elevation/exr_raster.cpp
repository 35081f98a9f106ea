// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The channel of an OpenEXR image that is heights: see raster.hpp.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfThreading.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"
#include "raster.hpp"

namespace ocean::elevation {
namespace {

using Names = std::vector<std::string>;

struct ChannelName {
    std::string layer;  // with its point, in lower case as the word
    std::string word;

    explicit ChannelName(std::string_view given) {
        const std::string name = lower_case(given);
        const std::size_t point = name.rfind('.');
        layer = name.substr(0, point == name.npos ? 0 : point + 1);
        word = name.substr(layer.size());
    }
    bool is_one_of(std::initializer_list<std::string_view> words) const {
        return std::ranges::find(words, word) != words.end();
    }
};

/// Returns the channels whose word is one of these; without words all but alpha. Y and Z of a layer
/// with an X are a vector, no heights.
Names select(const Names& names, std::initializer_list<std::string_view> words) {
    Names selected;
    for (const std::string& name : names) {
        const ChannelName one(name);
        const bool is_of_vector =
            one.is_one_of({"y", "z"}) && std::ranges::any_of(names, [&](const std::string& other) {
                return ChannelName(other).layer == one.layer && ChannelName(other).word == "x";
            });
        const bool is_alpha = one.is_one_of({"a", "alpha", "ar", "ag", "ab"});
        if (words.size() == 0 ? !is_alpha : one.is_one_of(words) && !is_of_vector) {
            selected.push_back(name);
        }
    }
    return selected;
}

/// Returns the channel of heights, and those that must repeat it or be 0 throughout, because they
/// may be meant as well.
Names height_channels(const Names& names) {
    Names found = select(names, {"height", "elevation"});
    if (found.empty()) found = select(names, {"z", "y", "depth", "r"});
    if (found.empty()) found = select(names, {});
    for (const std::string& green_or_blue : select(names, {"g", "b"})) {
        const std::string layer = ChannelName(green_or_blue).layer;
        const bool has_red = std::ranges::any_of(found, [&](const std::string& name) {
            return ChannelName(name).layer == layer && ChannelName(name).word == "r";
        });
        if (has_red) found.push_back(green_or_blue);
    }
    return found;
}

struct ChannelRow {
    std::vector<float> values;
    bool repeats = true;  // the heights
    bool is_zero = true;

    bool may_stand_beside(std::span<const float> heights) {
        repeats &= std::memcmp(values.data(), heights.data(), heights.size_bytes()) == 0;
        is_zero &= std::ranges::all_of(values, [](float value) { return value == 0.0f; });
        return repeats || is_zero;
    }
};

void read_image(Imf::InputFile& file, const RasterReceiver& receiver) {
    const Imath::Box2i window = file.header().dataWindow();
    RasterFacts facts;
    facts.columns = std::int64_t{window.max.x} - window.min.x + 1;
    facts.rows = std::int64_t{window.max.y} - window.min.y + 1;
    require_sides(facts.columns, facts.rows);
    Names names;
    const Imf::ChannelList& all = file.header().channels();
    for (auto channel = all.begin(); channel != all.end(); ++channel) {
        names.emplace_back(channel.name());
    }
    const auto shown = [](const std::string& name) { return text::printable(name, 40); };
    const std::string list = text::printable(joined(names, ", ", shown), 200);
    const Names chosen = height_channels(names);
    if (chosen.empty()) throw RasterFault("has no channel of heights, only " + list);
    if (names.size() > 1) {
        facts.notes.push_back("the heights are those of the channel " +
                              text::printable(chosen.front()) + " of " + list);
    }
    receiver.begin(facts);
    Imf::FrameBuffer buffer;
    std::vector<ChannelRow> rows(chosen.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].values.resize(static_cast<std::size_t>(facts.columns));
        char* const first = reinterpret_cast<char*>(rows[i].values.data()) -
                            std::ptrdiff_t{window.min.x} * std::ptrdiff_t{sizeof(float)};
        // A stride of 0 between rows: each one is read into the same memory.
        buffer.insert(chosen[i], Imf::Slice(Imf::FLOAT, first, sizeof(float), 0));
    }
    file.setFrameBuffer(buffer);
    for (int y = window.min.y; y <= window.max.y; ++y) {
        file.readPixels(y);
        for (ChannelRow& row : rows) {
            if (row.may_stand_beside(rows.front().values)) continue;
            throw RasterFault("has the channels " + list +
                              ", of which several may be the heights, and they differ; keep one of "
                              "them, or call it 'height'");
        }
        receiver.row(rows.front().values);
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
