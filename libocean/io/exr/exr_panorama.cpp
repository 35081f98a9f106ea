// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads panoramas from EXR files. The sizes in a file are checked before OpenEXR, which trusts
// them, allocates anything.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <cmath>

#include "exr_library.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/io/panorama.hpp"

namespace ocean::io {
namespace {

constexpr int kMaxWidth = 8192;
// OpenEXR buffers one block of lines, or one tile, of all channels.
constexpr std::size_t kMaxChannels = 16;
constexpr std::uint32_t kMaxTile = 1024;
constexpr float kMaxRadiance = 65504.0f;  // of half floats

[[noreturn]] void refuse_panorama(const std::string& path, const std::string& reason) {
    throw Error(ErrorKind::bad_file, "cannot read '" + path + "' as a panorama: " + reason);
}

void judge(const std::string& path, const ExrClaims& claims) {
    const auto [width, height, tile, channels] = claims;
    if (width != 2 * height || height % 2 != 0 || width < 8 || width > kMaxWidth) {
        refuse_panorama(
            path,
            "it is " + std::to_string(width) + " x " + std::to_string(height) +
                "; a panorama is twice as wide as high, 8 x 4 to 8192 x 4096, of even height");
    }
    for (const char* name : {"R", "G", "B"}) {
        if (std::ranges::none_of(channels,
                                 [&](const auto& channel) { return channel.name == name; })) {
            refuse_panorama(path, "it has no channel " + std::string(name));
        }
    }
    if (channels.size() > kMaxChannels) refuse_panorama(path, "it has more than 16 channels");
    if (tile > kMaxTile) refuse_panorama(path, "its tiles are larger than 1024 x 1024");
}

/// Reads the rows from the top one down.
void read_rows(const std::string& path, int threads, Panorama& panorama) {
    Imf::InputFile file(path.c_str(), threads);
    const Imath::Box2i window = file.header().dataWindow();
    const std::size_t pixel = 3 * sizeof(float);
    const std::size_t row = pixel * static_cast<std::size_t>(panorama.width);
    // OpenEXR expects the address that pixel (0, 0) would have.
    char* origin = reinterpret_cast<char*>(panorama.rgb.data()) -
                   static_cast<std::ptrdiff_t>(row) * window.min.y -
                   static_cast<std::ptrdiff_t>(pixel) * window.min.x;
    Imf::FrameBuffer buffer;
    for (const char* name : {"R", "G", "B"}) {
        buffer.insert(name, Imf::Slice(Imf::FLOAT, origin, pixel, row));
        origin += sizeof(float);
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
}

}  // namespace

Panorama read_exr_panorama(const std::string& path, int threads) {
    const ExrClaims claims = read_exr_claims(path);
    judge(path, claims);
    Panorama panorama;
    panorama.width = static_cast<int>(claims.width);
    panorama.height = static_cast<int>(claims.height);
    const auto row = 3 * static_cast<std::ptrdiff_t>(panorama.width);
    panorama.rgb.resize(static_cast<std::size_t>(row * panorama.height));
    const ImageThreads share(threads);
    try {
        read_rows(path, share.count(), panorama);
    } catch (const std::exception& error) {
        refuse_panorama(path, error.what());
    }
    const auto top = panorama.rgb.begin();
    for (int j = 0; j < panorama.height / 2; ++j) {
        std::swap_ranges(top + j * row, top + (j + 1) * row, top + (panorama.height - 1 - j) * row);
    }
    for (float& light : panorama.rgb) {
        light = std::isnan(light) ? 0.0f : std::clamp(light, 0.0f, kMaxRadiance);
    }
    return panorama;
}

}  // namespace ocean::io
