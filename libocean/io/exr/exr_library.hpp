// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the writer and the reader of images share of OpenEXR: the header, pixel types, threads.
#pragma once

#include <ImfHeader.h>
#include <ImfPixelType.h>

#include <cstddef>
#include <cstdint>

#include "ocean/io/exr.hpp"

namespace ocean::io {

/// Rows converted at a time: enough for every thread to have a ZIP block of 16, little memory.
inline constexpr int kRowsAtATime = 256;

inline Imf::PixelType imf_type(PixelType type) {
    return type == PixelType::half_float ? Imf::HALF : Imf::FLOAT;
}
inline std::size_t pixel_bytes(Imf::PixelType type) {
    return type == Imf::HALF ? 2 : 4;
}

/// What a file of one flat part claims, read without OpenEXR, which would believe it.
struct ExrClaims {
    std::int64_t width, height;  // samples
    std::uint32_t tile;          // the larger side of its tiles; 0: scanlines
    std::vector<ExrChannel> channels;
};
/// Throws Error bad_file.
ExrClaims read_exr_claims(const std::string& path);

Imf::Header make_exr_header(const Image& image, ExrCompression compression);

/// A share of OpenEXR's pool, which is one for the process: it grows to what all files in hand ask
/// for together. One thread is the caller's own and needs no pool.
class ImageThreads {
  public:
    /// 0 = the cores this process may use.
    explicit ImageThreads(int asked);
    ~ImageThreads();
    ImageThreads(const ImageThreads&) = delete;
    ImageThreads& operator=(const ImageThreads&) = delete;

    /// For OpenEXR: 0 is the caller's own.
    int count() const { return count_; }

  private:
    int count_;
};

}  // namespace ocean::io
