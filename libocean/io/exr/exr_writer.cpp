// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes images as EXR files. OpenEXR writes into our own stream, because its own one ignores the
// error of a full disk when it is closed.
#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>

#include <algorithm>

#include "exr_library.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/io/output_file.hpp"

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

/// Converts `rows` scanlines from y on into `bytes`; y = 0 is the top, the image's last row.
void convert_rows(const Image& image, const ImagePlane& plane, int y, int rows,
                  std::vector<char>& bytes) {
    const auto width = static_cast<std::size_t>(image.width);
    bytes.resize(width * static_cast<std::size_t>(rows) * pixel_bytes(imf_type(plane.type)));
    for (int row = 0; row < rows; ++row) {
        const auto j = static_cast<std::size_t>(image.height - 1 - (y + row));
        const auto first = static_cast<std::size_t>(row) * width;
        for (std::size_t i = 0; i < width; ++i) {
            const float value = plane.samples.empty() ? plane.constant
                                                      : plane.factor * plane.samples[j * width + i];
            if (plane.type == PixelType::half_float) {
                reinterpret_cast<Imath::half*>(bytes.data())[first + i] = Imath::half(value);
            } else {
                reinterpret_cast<float*>(bytes.data())[first + i] = value;
            }
        }
    }
}

void write_pixels(Imf::OutputFile& file, const Image& image) {
    std::vector<std::vector<char>> pixels(image.planes.size());
    for (int y = 0; y < image.height; y += kRowsAtATime) {
        const int rows = std::min(kRowsAtATime, image.height - y);
        Imf::FrameBuffer buffer;
        for (std::size_t c = 0; c < image.planes.size(); ++c) {
            const ImagePlane& plane = image.planes[c];
            convert_rows(image, plane, y, rows, pixels[c]);
            const std::size_t size = pixel_bytes(imf_type(plane.type));
            const std::size_t stride = size * static_cast<std::size_t>(image.width);
            // OpenEXR expects the address that pixel (0, 0) would have.
            char* origin = pixels[c].data() - static_cast<std::size_t>(y) * stride;
            buffer.insert(plane.name, Imf::Slice(imf_type(plane.type), origin, size, stride));
        }
        file.setFrameBuffer(buffer);
        file.writePixels(rows);
    }
}

}  // namespace

void write_exr(const Image& image, const std::string& path, ExrCompression compression,
               int threads) {
    OutputFile file(path);
    try {
        const ImageThreads share(threads);
        ExrStream stream(file, path);
        Imf::OutputFile output(stream, make_exr_header(image, compression), share.count());
        write_pixels(output, image);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        // OpenEXR wraps the message of our stream's exception in a sentence of its own.
        throw Error(ErrorKind::output, "cannot write '" + path + "': " + error.what());
    }
    file.commit();
}

}  // namespace ocean::io
