// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// An image as a value: what every image writer takes, whatever the samples mean. Above it stand the
// products of a sea (product_image.hpp); a terrain, a spectrum or a mask may stand there as well.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/io/provenance.hpp"

namespace ocean::io {

/// How a sample is stored.
enum class PixelType { half_float, full_float };

/// One channel: factor * samples, or a constant. The samples must outlive the image.
struct ImagePlane {
    std::string name = {};
    PixelType type = PixelType::full_float;
    std::span<const float> samples =
        {};  // width * height, row-major, the bottom row first; or none
    float factor = 1.0f;
    float constant = 0.0f;  // everywhere, where there are no samples
};

struct Image {
    int width = 0;
    int height = 0;
    /// Where the samples lie in the world; nothing for a picture. One that wraps tiles.
    std::optional<Domain> domain = {};
    std::vector<ImagePlane> planes;
    Provenance provenance = {};
    std::vector<HeaderString> strings = {};  // what the header says beside the provenance

    bool wraps() const { return domain && domain->wraps; }
    /// Returns all strings of the header.
    std::vector<HeaderString> header_strings() const;
};

/// Receives the bytes of a file or of its pixels, piece by piece.
using ByteSink = std::function<void(std::string_view)>;

}  // namespace ocean::io
