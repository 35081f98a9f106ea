// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The use of OpenEXR that writers and readers of images share: header, pixel types, threads.
#pragma once

#include <ImfHeader.h>
#include <ImfPixelType.h>

#include <cstddef>
#include <cstdint>

#include "ocean/io/exr.hpp"

namespace ocean::io {

/// The rows that are converted at a time: a ZIP block of 16 for every thread, in little memory.
inline constexpr int kRowsAtATime = 256;

inline Imf::PixelType imf_type(PixelType type) {
    return type == PixelType::half_float ? Imf::HALF : Imf::FLOAT;
}
inline std::size_t pixel_bytes(Imf::PixelType type) {
    return type == Imf::HALF ? 2 : 4;
}

/// The sizes that a file of one flat part claims, read without OpenEXR, which would trust them.
struct ExrClaims {
    std::int64_t width, height;  // [samples]
    std::uint32_t tile;          // the larger side of its tiles [samples]; 0: scanlines
    std::vector<ExrChannel> channels;
};
/// Returns the claimed sizes of a file. Throws Error bad_file.
ExrClaims read_exr_claims(const std::string& path);

Imf::Header make_exr_header(const Image& image, ExrCompression compression);

/// A share of OpenEXR's thread pool. A process has one pool, with as many threads as all open files
/// request together. A file with one thread uses the caller's and needs no pool.
class ImageThreads {
  public:
    /// `threads`: 0 = the cores this process may use.
    explicit ImageThreads(int requested);
    ~ImageThreads();
    ImageThreads(const ImageThreads&) = delete;
    ImageThreads& operator=(const ImageThreads&) = delete;

    /// Returns the number of threads for OpenEXR, where 0 is the caller's thread.
    int count() const { return count_; }

  private:
    int count_;
};

}  // namespace ocean::io
