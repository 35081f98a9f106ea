// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See exr_library.hpp. A header is a function of the image and the compression alone; it holds no
// date, no host name and no thread count.
#include "exr_library.hpp"

#include <ImfChannelList.h>
#include <ImfIO.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <algorithm>
#include <mutex>

#include "ocean/internal/platform.hpp"

namespace ocean::io {
namespace {

class StringStream : public Imf::OStream {
  public:
    StringStream() : Imf::OStream("") {}
    void write(const char bytes[], int count) override {
        text.append(bytes, static_cast<std::size_t>(count));
    }
    std::uint64_t tellp() override { return text.size(); }
    void seekp(std::uint64_t) override {}

    std::string text;
};

std::mutex pool_mutex;
int threads_in_use = 0;

}  // namespace

// The header has no chromaticities: readers would convert metres as if they were colours.
Imf::Header make_exr_header(const Image& image, ExrCompression compression) {
    Imf::Header header(image.width, image.height);
    static_assert(Imf::PXR24_COMPRESSION == static_cast<int>(ExrCompression::pxr24));
    header.compression() = static_cast<Imf::Compression>(compression);
    for (const ImagePlane& plane : image.planes) {
        header.channels().insert(plane.name, Imf::Channel(imf_type(plane.type)));
    }
    if (image.wraps()) Imf::addWrapmodes(header, "periodic");
    for (const auto& [name, text] : image.header_strings()) {
        header.insert(name, Imf::StringAttribute(text));
    }
    return header;
}

std::string exr_header_bytes(const Image& image, ExrCompression compression) {
    // Magic number and version 2 of a flat single part with short names, then the attributes.
    StringStream stream;
    stream.text = std::string("\x76\x2f\x31\x01\x02\0\0\0", 8);
    make_exr_header(image, compression).writeTo(stream);
    return stream.text;
}

std::uint64_t max_exr_bytes(const Image& image, ExrCompression compression) {
    // No codec makes a file larger: a block that would grow is stored uncompressed.
    constexpr std::uint64_t kPerBlock = 16;  // its offset in the table, its row and its size
    const auto width = static_cast<std::uint64_t>(image.width);
    const auto height = static_cast<std::uint64_t>(image.height);
    std::uint64_t sample = 0;
    for (const ImagePlane& plane : image.planes) sample += pixel_bytes(imf_type(plane.type));
    return exr_header_bytes(image, compression).size() + height * (kPerBlock + width * sample);
}

std::vector<ExrChannel> exr_channels(const Image& image) {
    std::vector<ExrChannel> channels;
    for (const ImagePlane& plane : image.planes) channels.push_back({plane.name, plane.type});
    std::sort(channels.begin(), channels.end(),
              [](const ExrChannel& a, const ExrChannel& b) { return a.name < b.name; });
    return channels;
}

ImageThreads::ImageThreads(int requested) {
    const int threads = requested > 0 ? requested : available_cores();
    count_ = threads > 1 ? threads : 0;
    const std::lock_guard lock(pool_mutex);
    threads_in_use += count_;
    if (Imf::globalThreadCount() < threads_in_use) Imf::setGlobalThreadCount(threads_in_use);
}

ImageThreads::~ImageThreads() {
    const std::lock_guard lock(pool_mutex);
    threads_in_use -= count_;
}

}  // namespace ocean::io
