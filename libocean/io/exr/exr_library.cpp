// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Headers and threads; see exr_library.hpp. A header is a function of the sea, the frame and the
// options alone: whoever wants to know whether a file is still the one that a bake would write
// compares the headers. Nothing in it depends on the run: no dates, no host, no thread count.
#include "exr_library.hpp"

#include <ImfChannelList.h>
#include <ImfIO.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <charconv>
#include <mutex>

#include "ocean/platform.hpp"
#include "ocean/version.hpp"

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

std::string shortest_text(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

Imf::Compression imf_compression(ExrCompression compression) {
    switch (compression) {
        case ExrCompression::none:
            return Imf::NO_COMPRESSION;
        case ExrCompression::rle:
            return Imf::RLE_COMPRESSION;
        case ExrCompression::zips:
            return Imf::ZIPS_COMPRESSION;
        case ExrCompression::zip:
            return Imf::ZIP_COMPRESSION;
        case ExrCompression::piz:
            return Imf::PIZ_COMPRESSION;
        case ExrCompression::pxr24:
            return Imf::PXR24_COMPRESSION;
    }
    return Imf::ZIP_COMPRESSION;
}

std::mutex pool_mutex;
int threads_in_use = 0;

}  // namespace

// No chromaticities: readers would convert colours that are metres.
Imf::Header make_exr_header(const ExrLabel& label, const ExrOptions& options) {
    const int n = label.map.resolution;
    Imf::Header header(n, n);
    header.compression() = imf_compression(options.compression);
    for (const ImageChannel& channel : image_channels(label.products, label.layered, options)) {
        header.channels().insert(channel.name, Imf::Channel(imf_type(channel)));
    }
    Imf::addWrapmodes(header, "periodic");

    std::string fields, units;
    bool vectors = false;
    for (const Product* product : label.products) {
        fields += (fields.empty() ? "" : ",") + std::string(product->name);
        units +=
            (units.empty() ? "" : ",") + (product->unit.empty() ? "1" : std::string(product->unit));
        vectors = vectors || product->count == 3;
    }
    const auto set = [&header](const char* name, const std::string& text) {
        header.insert(name, Imf::StringAttribute(text));
    };
    set("ocean:sea", label.sea_text);
    set("ocean:frame", std::to_string(label.number));
    set("ocean:time", shortest_text(label.time));
    // Scalars and slopes are the same in all axes: x east and y north, as in zup.
    set("ocean:axes", std::string(axes_name(vectors ? options.axes : Axes::zup)));
    set("ocean:period", shortest_text(label.map.period));
    set("ocean:field", fields);
    set("ocean:unit", units);
    set("ocean:backend", std::string(label.backend.name));
    set("ocean:version", OCEAN_VERSION);
    return header;
}

std::string exr_header_bytes(const ExrLabel& label, const ExrOptions& options) {
    // Magic number and version 2 of a flat single part with short names, then the attributes.
    StringStream stream;
    stream.text = std::string("\x76\x2f\x31\x01\x02\0\0\0", 8);
    make_exr_header(label, options).writeTo(stream);
    return stream.text;
}

ImageThreads::ImageThreads(int asked) {
    const int threads = asked > 0 ? asked : available_cores();
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
