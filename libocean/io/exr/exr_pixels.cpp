// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Decodes the pixels of an image that we wrote, which shows whether the file is complete, and gives
// its content for any compression. OpenEXR trusts the sizes in a header, so it gets only files
// whose header is known byte for byte.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <fstream>

#include "exr_library.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean::io {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
    throw Error(ErrorKind::bad_file, "cannot read '" + path + "': " + reason);
}

struct Plane {
    std::string name;
    Imf::PixelType type;
    std::size_t row_bytes;
    std::vector<char> rows;
};

std::vector<Plane> make_planes(const Imf::Header& header, int width) {
    std::vector<Plane> planes;
    const Imf::ChannelList& channels = header.channels();
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        const Imf::PixelType type = channel.channel().type;
        const std::size_t row = static_cast<std::size_t>(width) * pixel_bytes(type);
        planes.push_back({channel.name(), type, row, std::vector<char>(row * kRowsAtATime)});
    }
    return planes;
}

void read_rows(Imf::InputFile& image, std::vector<Plane>& planes, int y, int rows) {
    Imf::FrameBuffer buffer;
    for (Plane& plane : planes) {
        // OpenEXR expects the address that pixel (0, 0) would have.
        char* origin = plane.rows.data() - static_cast<std::size_t>(y) * plane.row_bytes;
        buffer.insert(plane.name,
                      Imf::Slice(plane.type, origin, pixel_bytes(plane.type), plane.row_bytes));
    }
    image.setFrameBuffer(buffer);
    image.readPixels(y, y + rows - 1);
}

void read_image(const std::string& path, int threads, const ByteSink& sink) {
    Imf::InputFile image(path.c_str(), threads);
    if (!image.isComplete()) refuse(path, "it is not complete");
    const Imath::Box2i window = image.header().dataWindow();
    const int height = window.max.y + 1;
    std::vector<Plane> planes = make_planes(image.header(), window.max.x + 1);
    for (int y = 0; y < height; y += kRowsAtATime) {
        const int rows = std::min(kRowsAtATime, height - y);
        read_rows(image, planes, y, rows);
        for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
            for (const Plane& plane : planes) {
                sink({plane.rows.data() + row * plane.row_bytes, plane.row_bytes});
            }
        }
    }
}

}  // namespace

void read_exr_pixels(const std::string& path, std::string_view header, int threads,
                     const ByteSink& sink) {
    std::string beginning(header.size(), '\0');
    std::ifstream file(utf8_path(path), std::ios::binary);
    if (!file) refuse(path, "it cannot be opened");
    if (!file.read(beginning.data(), static_cast<std::streamsize>(beginning.size())) ||
        beginning != header) {
        refuse(path, "its header differs from the expected one");
    }
    const ImageThreads share(threads);
    try {
        read_image(path, share.count(), sink);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        refuse(path, error.what());
    }
}

}  // namespace ocean::io
