// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// EXR images of a surface: flat, single part, the bottom scanline is j = 0. The pixels go through
// OpenEXR into our own stream, because OpenEXR swallows what a full disk says at the close. Nothing
// in a file depends on the run: no dates, no host, no thread count.
#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>

#include <algorithm>

#include "../file/output_file.hpp"
#include "exr_channels.hpp"
#include "exr_library.hpp"
#include "ocean/error.hpp"

namespace ocean::io {
namespace {

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

// `bytes` receives `rows` scanlines from y on: y = 0 is the top, j = n - 1.
void convert_rows(const Surface& surface, const ImageChannel& channel, int y, int rows,
                  std::vector<char>& bytes) {
    const int n = surface.resolution();
    const std::span<const float> map =
        channel.source ? surface.channel(*channel.source) : std::span<const float>();
    const auto width = static_cast<std::size_t>(n);
    bytes.resize(width * static_cast<std::size_t>(rows) * pixel_bytes(imf_type(channel)));
    for (int row = 0; row < rows; ++row) {
        const auto j = static_cast<std::size_t>(n - 1 - (y + row));
        const auto first = static_cast<std::size_t>(row) * width;
        for (std::size_t i = 0; i < width; ++i) {
            const float value =
                channel.source ? channel.sign * map[j * width + i] : channel.constant;
            if (channel.half) {
                reinterpret_cast<Imath::half*>(bytes.data())[first + i] = Imath::half(value);
            } else {
                reinterpret_cast<float*>(bytes.data())[first + i] = value;
            }
        }
    }
}

void write_pixels(Imf::OutputFile& image, std::span<const ImageChannel> channels,
                  const Surface& surface) {
    const int n = surface.resolution();
    std::vector<std::vector<char>> pixels(channels.size());
    for (int y = 0; y < n; y += kRowsAtATime) {
        const int rows = std::min(kRowsAtATime, n - y);
        Imf::FrameBuffer buffer;
        for (std::size_t c = 0; c < channels.size(); ++c) {
            convert_rows(surface, channels[c], y, rows, pixels[c]);
            const std::size_t size = pixel_bytes(imf_type(channels[c]));
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

void require_channels(const Surface& surface, const Product& product) {
    for (int c = 0; c < product.count; ++c) {
        if (surface.has(product.channels[static_cast<std::size_t>(c)])) continue;
        throw Error(ErrorKind::invalid_value,
                    "the surface was evaluated without the channels of '" +
                        std::string(product.name) + "'");
    }
}

void write_image(const Frame& frame, std::span<const Product* const> products, bool layered,
                 const std::string& path, const ExrOptions& options) {
    for (const Product* product : products) require_channels(frame.surface, *product);
    const Lattice map{frame.surface.resolution(), frame.surface.period()};
    const ExrLabel label{frame.sea_text, frame.number, frame.time, frame.backend, map,
                         products,       layered};
    OutputFile file(path);
    try {
        const ImageThreads threads(options.threads);
        ExrStream stream(file, path);
        Imf::OutputFile image(stream, make_exr_header(label, options), threads.count());
        write_pixels(image, image_channels(products, layered, options), frame.surface);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        // OpenEXR wraps what our stream threw in a sentence of its own.
        throw Error(ErrorKind::output, "cannot write '" + path + "': " + error.what());
    }
    file.commit();
}

}  // namespace

void write_exr(const Frame& frame, const Product& product, const std::string& path,
               const ExrOptions& options) {
    const Product* const products[] = {&product};
    write_image(frame, products, false, path, options);
}

void write_exr_layered(const Frame& frame, std::span<const Product* const> products,
                       const std::string& path, const ExrOptions& options) {
    if (products.empty()) {
        throw Error(ErrorKind::invalid_value, "a layered file needs at least one product");
    }
    write_image(frame, products, true, path, options);
}

}  // namespace ocean::io
