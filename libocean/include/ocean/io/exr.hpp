// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenEXR: writes images, reads their headers and pixels. Files are flat and have a single part;
// the bottom scanline is the image's first row. The bytes of a file do not depend on the run: they
// hold no date, no host name and no thread count.
//
//     io::write_exr(image, "height.exr", io::find_exr_compression("zip"));
//     for (const io::HeaderString& each : io::read_exr_header("height.exr")) {
//         std::printf("%s: %s\n", each.name.c_str(), each.text.c_str());
//     }
//     const io::ExrLayout layout = io::read_exr_layout("height.exr");
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/io/image.hpp"

namespace ocean::io {

/// The values are the codes of the format.
enum class ExrCompression { none, rle, zips, zip, piz, pxr24 };
/// Returns the compression called "zip", "pxr24" ... Throws Error invalid_value for an unknown
/// name, and with the reason for a codec that distorts vectors (b44, b44a, dwaa, dwab).
ExrCompression find_exr_compression(std::string_view name);
std::string_view exr_compression_name(ExrCompression compression);

/// Writes an image atomically. `threads`: 0 = the cores this process may use. Throws Error output.
void write_exr(const Image& image, const std::string& path, ExrCompression compression,
               int threads = 0);
/// Returns the bytes that write_exr writes before the pixels. If a file begins with them, write_exr
/// would write the same header. Needs no samples.
std::string exr_header_bytes(const Image& image, ExrCompression compression);
/// Returns an upper bound of the bytes that write_exr writes.
std::uint64_t max_exr_bytes(const Image& image, ExrCompression compression);

/// Decodes the pixels of a file that begins with `header` and passes them to `sink`: rows from the
/// top; in a row the channels in the file's order; in a channel half or float values,
/// little-endian. Throws Error bad_file for another header and for a damaged file.
void read_exr_pixels(const std::string& path, std::string_view header, int threads,
                     const ByteSink& sink);

/// Returns the `ocean:` header strings of a baked file, sorted by name. Throws Error bad_file with
/// the reason; safe on hostile files.
std::vector<HeaderString> read_exr_header(const std::string& path);

struct ExrChannel {
    std::string name;
    PixelType type;

    bool operator==(const ExrChannel&) const = default;
};
/// The pixel layout of the first part of a file.
struct ExrLayout {
    std::array<int, 2> samples;                 // along x and y
    std::optional<ExrCompression> compression;  // absent: a codec that write_exr does not have
    std::vector<ExrChannel> channels;           // in the file's order
};
/// Returns the layout of a file. Throws Error bad_file with the reason; safe on hostile files.
ExrLayout read_exr_layout(const std::string& path);
/// Returns the channels of an image's file, in the file's order.
std::vector<ExrChannel> exr_channels(const Image& image);

}  // namespace ocean::io
