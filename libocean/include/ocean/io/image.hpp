// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// An image as a value, the input of the image writers for samples of any meaning: products of a
// sea, a terrain, a spectrum or a mask.
//
//     io::Image image{.width = n, .height = n, .domain = surface.domain()};
//     image.planes.push_back({.name = "Y", .samples = surface.channel(Channel::height)});
//     image.provenance = {.kind = "sea", .text = write_sea(sea), .time = surface.time()};
//     io::write_exr(image, "height.exr", io::ExrCompression::zip);
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/provenance.hpp"

namespace ocean::io {

/// The stored type of a sample.
enum class PixelType { half_float, full_float };

/// A channel: factor * samples, or a constant. The samples must outlive the image.
struct ImagePlane {
    std::string name = {};
    PixelType type = PixelType::full_float;
    /// width * height values, row-major, the bottom row first; empty: `constant` everywhere.
    std::span<const float> samples = {};
    float factor = 1.0f;
    float constant = 0.0f;
};

struct Image {
    int width = 0;
    int height = 0;
    /// The domain of the samples in the world; absent for a picture. An image whose domain wraps
    /// can be tiled.
    std::optional<Domain> domain = {};
    std::vector<ImagePlane> planes;
    Provenance provenance = {};
    std::vector<HeaderString> strings = {};  // header strings beside the provenance

    bool wraps() const { return domain && domain->wraps; }
    /// Returns all strings of the header.
    std::vector<HeaderString> header_strings() const;
};

/// Receives the bytes of a file or of its pixels, piece by piece.
using ByteSink = std::function<void(std::string_view)>;

}  // namespace ocean::io
