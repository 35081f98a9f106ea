// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How a product becomes image channels: names, order, sign and pixel type. The pure part of the EXR
// writer, apart from the library that stores the pixels.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ocean/io.hpp"

namespace ocean::io {

/// One channel of the file: a map of the surface times a sign, or a constant.
struct ImageChannel {
    std::string name;
    std::optional<Channel> source;  // none: `constant` everywhere
    float sign = 1.0f;
    float constant = 0.0f;
    bool half = false;
};

/// A product alone in its file has Y, or R,G,B; several in one file have names of their own.
std::vector<ImageChannel> image_channels(std::span<const Product* const> products, bool layered,
                                         const ExrOptions& options);

}  // namespace ocean::io
