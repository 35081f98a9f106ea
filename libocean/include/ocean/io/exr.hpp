// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenEXR: images out, their headers and pixels back in. Files are flat, single part; the bottom
// scanline is the image's first row. Nothing in a file depends on the run: no dates, no host, no
// thread count.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/io/image.hpp"

namespace ocean::io {

enum class ExrCompression { none, rle, zips, zip, piz, pxr24 };
/// "zip", "pxr24" ...; a codec that spoils vectors (b44, b44a, dwaa, dwab) is refused with the
/// reason. Throws Error invalid_value.
ExrCompression find_exr_compression(std::string_view name);
std::string_view exr_compression_name(ExrCompression compression);

/// Atomic. `threads`: 0 = the cores this process may use. Throws Error output.
void write_exr(const Image& image, const std::string& path, ExrCompression compression,
               int threads = 0);
/// The bytes of the file before its pixels, as write_exr writes them: whoever wants to know whether
/// a file is still the one that would be written compares them. Needs no samples.
std::string exr_header_bytes(const Image& image, ExrCompression compression);
/// The most bytes that write_exr may write.
std::uint64_t most_exr_bytes(const Image& image, ExrCompression compression);

/// Decodes every pixel of a file that begins with `header`: rows from the top; of a row the
/// channels in the file's order; of a channel half or float values, little-endian. Throws Error
/// bad_file for another header and for damage.
void read_exr_pixels(const std::string& path, std::string_view header, int threads,
                     const ByteSink& sink);

/// The `ocean:` header strings of a baked file, in name order. Throws Error bad_file with the
/// reason; safe on hostile files.
std::vector<HeaderString> read_exr_header(const std::string& path);

struct ExrChannel {
    std::string name;
    PixelType type;

    bool operator==(const ExrChannel&) const = default;
};
/// How the first part of a file stores its pixels.
struct ExrLayout {
    int resolution;                             // samples along each side
    std::optional<ExrCompression> compression;  // none: a codec that write_exr does not have
    std::vector<ExrChannel> channels;           // in the file's order
};
/// Throws Error bad_file with the reason, also for an image that is no square; safe on hostile
/// files.
ExrLayout read_exr_layout(const std::string& path);
/// The channels that the file of an image has, in the file's order.
std::vector<ExrChannel> exr_channels(const Image& image);

}  // namespace ocean::io
