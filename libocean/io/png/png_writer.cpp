// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <png.h>

#include "ocean/error.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/png.hpp"

namespace ocean::io {
namespace {

png_image image_of(int width, int height, png_uint_32 format) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(width);
    png.height = static_cast<png_uint_32>(height);
    png.format = format;
    return png;
}

/// Writes an image whose last row in memory is the top one. `row_stride` is libpng's [samples].
void write_rows(const std::string& path, int width, int height, png_uint_32 format,
                const void* samples, int row_stride) {
    png_image png = image_of(width, height, format);
    OutputFile file(path);
    // A negative stride writes the rows from the last one in memory to the first.
    const bool written =
        png_image_write_to_stdio(&png, file.stream(), 0, samples, -row_stride, nullptr) != 0;
    // The stream reports a full disk more precisely than libpng.
    if (!written && std::ferror(file.stream()) == 0) {
        throw Error(ErrorKind::output, path + ": " + png.message);
    }
    file.commit();
}

}  // namespace

void write_png(const std::string& path, int width, int height, std::span<const std::uint8_t> rgb) {
    write_rows(path, width, height, PNG_FORMAT_RGB, rgb.data(), 3 * width);
}

void write_grey_png(const std::string& path, int width, int height,
                    std::span<const std::uint16_t> grey) {
    write_rows(path, width, height, PNG_FORMAT_LINEAR_Y, grey.data(), width);
}

std::string grey_png(int width, int height, std::span<const std::uint16_t> grey) {
    png_image png = image_of(width, height, PNG_FORMAT_LINEAR_Y);
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, grey.data(), -width, nullptr) ==
        0) {
        throw Error(ErrorKind::output, std::string("a PNG image: ") + png.message);
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace ocean::io
