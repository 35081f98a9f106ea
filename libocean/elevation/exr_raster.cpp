// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One channel of an OpenEXR image: see image_raster.hpp.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfThreading.h>

#include <cstdint>

#include "image_raster.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::elevation {
namespace {

/// Returns the channel of heights.
std::string channel_of(const Imf::ChannelList& channels, RasterFacts& facts) {
    std::string names;
    std::string first;
    int count = 0;
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        if (count == 0) first = channel.name();
        names += (count++ == 0 ? "" : ", ") + text::printable(channel.name(), 40);
    }
    if (count == 0) throw RasterFault("has no channels");
    std::string chosen = first;
    for (const char* name : {"Y", "height"}) {
        if (channels.findChannel(name) == nullptr) continue;
        chosen = name;
        break;
    }
    if (count > 1) {
        facts.notes.push_back("the heights are those of the channel " + text::printable(chosen) +
                              " of " + text::printable(names, 200));
    }
    return chosen;
}

void read_image(Imf::InputFile& file, const RasterReceiver& receiver) {
    const Imath::Box2i window = file.header().dataWindow();
    RasterFacts facts;
    facts.columns = std::int64_t{window.max.x} - window.min.x + 1;
    facts.rows = std::int64_t{window.max.y} - window.min.y + 1;
    require_sides(facts.columns, facts.rows);
    const std::string channel = channel_of(file.header().channels(), facts);
    receiver.begin(facts);
    std::vector<float> row(static_cast<std::size_t>(facts.columns));
    Imf::FrameBuffer buffer;
    // A stride of 0 between rows: each one is read into the same memory.
    buffer.insert(channel, Imf::Slice(Imf::FLOAT,
                                      reinterpret_cast<char*>(row.data()) -
                                          std::ptrdiff_t{window.min.x} *
                                              static_cast<std::ptrdiff_t>(sizeof(float)),
                                      sizeof(float), 0));
    file.setFrameBuffer(buffer);
    for (int y = window.min.y; y <= window.max.y; ++y) {
        file.readPixels(y);
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
