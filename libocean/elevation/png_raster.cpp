// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Grey PNG by libpng: see image_raster.hpp.
#include <png.h>

#include <csetjmp>
#include <cstdint>
#include <cstring>

#include "image_raster.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::elevation {
namespace {

/// libpng's objects and its last message.
struct PngReader {
    png_structp png = nullptr;
    png_infop info = nullptr;
    char message[200] = "";

    explicit PngReader(std::istream& stream);
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
};

void keep_message(png_structp png, png_const_charp message) {
    auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
    std::strncpy(reader->message, message, sizeof(reader->message) - 1);
    std::longjmp(png_jmpbuf(png), 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep bytes, png_size_t count) {
    auto* stream = static_cast<std::istream*>(png_get_io_ptr(png));
    stream->read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(count));
    if (!*stream) png_error(png, "the file is cut off");
}

PngReader::PngReader(std::istream& stream) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, keep_message, ignore_warning);
    if (png == nullptr) throw RasterFault("cannot be read: libpng does not start");
    info = png_create_info_struct(png);
    png_set_read_fn(png, &stream, read_bytes);
    png_set_user_limits(png, static_cast<png_uint_32>(kMaxElevationSide),
                        static_cast<png_uint_32>(kMaxElevationSide));
}

/// Reads the header. Returns false if libpng fails: no object with a destructor may live here,
/// since longjmp skips it.
bool read_info(PngReader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_read_info(reader.png, reader.info);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool read_row(PngReader& reader, png_bytep row) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_read_row(reader.png, row, nullptr);
    return true;
}

RasterFault failed(const PngReader& reader) {
    return RasterFault("is no whole PNG file: " + text::printable(reader.message));
}

}  // namespace

void read_png(std::istream& stream, const RasterReceiver& receiver) {
    PngReader reader(stream);
    if (!read_info(reader)) throw failed(reader);
    const int bits = png_get_bit_depth(reader.png, reader.info);
    if (png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_GRAY) {
        throw RasterFault("is a picture with colours; a height map is grey, without transparency");
    }
    if (bits != 8 && bits != 16) {
        throw RasterFault("has " + std::to_string(bits) + " bits a pixel; allowed are 8 and 16");
    }
    if (png_get_interlace_type(reader.png, reader.info) != PNG_INTERLACE_NONE) {
        throw RasterFault("is interlaced; save it without interlacing");
    }
    RasterFacts facts;
    facts.columns = png_get_image_width(reader.png, reader.info);
    facts.rows = png_get_image_height(reader.png, reader.info);
    require_sides(facts.columns, facts.rows);
    facts.full_scale = bits == 16 ? 65535.0 : 255.0;
    if (bits == 8) {
        facts.notes.push_back("the image has 8 bits: heights are in steps of 1/255 of the range");
    }
    receiver.begin(facts);
    std::vector<std::uint8_t> line(png_get_rowbytes(reader.png, reader.info));
    std::vector<float> row(static_cast<std::size_t>(facts.columns));
    for (std::int64_t j = 0; j < facts.rows; ++j) {
        if (!read_row(reader, line.data())) throw failed(reader);
        for (std::size_t i = 0; i < row.size(); ++i) {
            row[i] = static_cast<float>(bits == 16 ? line[2 * i] << 8 | line[2 * i + 1] : line[i]);
        }
        receiver.row(row);
    }
}

}  // namespace ocean::elevation
