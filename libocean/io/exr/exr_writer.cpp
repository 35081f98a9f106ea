// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// EXR images of a surface: flat, single part, the bottom scanline is j = 0. The pixels go through
// OpenEXR into our own stream, because OpenEXR swallows what a full disk says at the close. Nothing
// in a file depends on the run: no dates, no host, no thread count.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <algorithm>
#include <charconv>
#include <mutex>

#include "../file/output_file.hpp"
#include "exr_channels.hpp"
#include "ocean/error.hpp"
#include "ocean/platform.hpp"
#include "ocean/version.hpp"

namespace ocean::io {
namespace {

// Rows converted at a time: enough for every thread to have a ZIP block of 16, little memory.
constexpr int kRowsAtATime = 256;

class ExrStream : public Imf::OStream {
  public:
    ExrStream(OutputFile& file, const std::string& path)
        : Imf::OStream(path.c_str()), file_(file) {}
    void write(const char bytes[], int count) override {
        file_.write({bytes, static_cast<std::size_t>(count)});
    }
    std::uint64_t tellp() override { return file_.tell(); }
    void seekp(std::uint64_t position) override { file_.seek(position); }

  private:
    OutputFile& file_;
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

Imf::PixelType imf_type(const ImageChannel& channel) {
    return channel.half ? Imf::HALF : Imf::FLOAT;
}

std::size_t pixel_bytes(const ImageChannel& channel) {
    return channel.half ? sizeof(Imath::half) : sizeof(float);
}

// No chromaticities: readers would convert colours that are metres.
Imf::Header make_header(const Frame& frame, std::span<const FieldInfo* const> products,
                        std::span<const ImageChannel> channels, const ExrOptions& options) {
    const int n = frame.surface.resolution();
    Imf::Header header(n, n);
    header.compression() = imf_compression(options.compression);
    for (const ImageChannel& channel : channels) {
        header.channels().insert(channel.name, Imf::Channel(imf_type(channel)));
    }
    Imf::addWrapmodes(header, "periodic");

    std::string fields, units;
    bool vectors = false;
    for (const FieldInfo* product : products) {
        fields += (fields.empty() ? "" : ",") + std::string(product->name);
        units +=
            (units.empty() ? "" : ",") + (product->unit.empty() ? "1" : std::string(product->unit));
        vectors = vectors || product->count == 3;
    }
    const auto set = [&header](const char* name, const std::string& text) {
        header.insert(name, Imf::StringAttribute(text));
    };
    set("ocean:sea", frame.sea_text);
    set("ocean:frame", std::to_string(frame.number));
    set("ocean:time", shortest_text(frame.time));
    // Scalars and slopes are the same in all axes: x east and y north, as in zup.
    set("ocean:axes", std::string(axes_name(vectors ? options.axes : Axes::zup)));
    set("ocean:period", shortest_text(frame.surface.period()));
    set("ocean:field", fields);
    set("ocean:unit", units);
    set("ocean:version", OCEAN_VERSION);
    return header;
}

// `bytes` receives `rows` scanlines from y on: y = 0 is the top, j = n - 1.
void convert_rows(const ImageChannel& channel, int n, int y, int rows, std::vector<char>& bytes) {
    const auto width = static_cast<std::size_t>(n);
    bytes.resize(width * static_cast<std::size_t>(rows) * pixel_bytes(channel));
    for (int row = 0; row < rows; ++row) {
        const auto j = static_cast<std::size_t>(n - 1 - (y + row));
        const auto first = static_cast<std::size_t>(row) * width;
        for (std::size_t i = 0; i < width; ++i) {
            const float value =
                channel.map.empty() ? channel.constant : channel.sign * channel.map[j * width + i];
            if (channel.half) {
                reinterpret_cast<Imath::half*>(bytes.data())[first + i] = Imath::half(value);
            } else {
                reinterpret_cast<float*>(bytes.data())[first + i] = value;
            }
        }
    }
}

void write_pixels(Imf::OutputFile& image, std::span<const ImageChannel> channels, int n) {
    std::vector<std::vector<char>> pixels(channels.size());
    for (int y = 0; y < n; y += kRowsAtATime) {
        const int rows = std::min(kRowsAtATime, n - y);
        Imf::FrameBuffer buffer;
        for (std::size_t c = 0; c < channels.size(); ++c) {
            convert_rows(channels[c], n, y, rows, pixels[c]);
            const std::size_t size = pixel_bytes(channels[c]);
            const std::size_t stride = size * static_cast<std::size_t>(n);
            // OpenEXR wants the address that the pixel (0, 0) would have.
            char* origin = pixels[c].data() - static_cast<std::size_t>(y) * stride;
            buffer.insert(channels[c].name,
                          Imf::Slice(imf_type(channels[c]), origin, size, stride));
        }
        image.setFrameBuffer(buffer);
        image.writePixels(rows);
    }
}

// OpenEXR has one pool for the process: it grows to the largest number asked for. One thread is the
// caller's own and needs no pool.
int image_threads(int asked) {
    static std::mutex mutex;
    const int threads = asked > 0 ? asked : available_cores();
    if (threads <= 1) return 0;
    const std::lock_guard lock(mutex);
    if (Imf::globalThreadCount() < threads) Imf::setGlobalThreadCount(threads);
    return threads;
}

void write_image(const Frame& frame, std::span<const FieldInfo* const> products,
                 std::span<const ImageChannel> channels, const std::string& path,
                 const ExrOptions& options) {
    OutputFile file(path);
    try {
        ExrStream stream(file, path);
        Imf::OutputFile image(stream, make_header(frame, products, channels, options),
                              image_threads(options.threads));
        write_pixels(image, channels, frame.surface.resolution());
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        // OpenEXR wraps what our stream threw in a sentence of its own.
        throw Error(ErrorKind::output, "cannot write '" + path + "': " + error.what());
    }
    file.commit();
}

}  // namespace

void write_exr(const Frame& frame, const FieldInfo& product, const std::string& path,
               const ExrOptions& options) {
    const FieldInfo* const products[] = {&product};
    write_image(frame, products, separate_channels(frame.surface, product, options), path, options);
}

void write_exr_layered(const Frame& frame, std::span<const FieldInfo* const> products,
                       const std::string& path, const ExrOptions& options) {
    if (products.empty()) {
        throw Error(ErrorKind::invalid_value, "a layered file needs at least one product");
    }
    write_image(frame, products, layered_channels(frame.surface, products, options), path, options);
}

}  // namespace ocean::io
