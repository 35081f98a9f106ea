// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How a product becomes image channels: names, order, sign and pixel type. The pure part of the EXR
// writer, apart from the library that stores the pixels.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "ocean/io.hpp"

namespace ocean::io {

/// One channel of the file: a map of the surface times a sign, or a constant.
struct ImageChannel {
    std::string name;
    std::span<const float> map;  // empty: `constant` everywhere
    float sign = 1.0f;
    float constant = 0.0f;
    bool half = false;
};

/// Channels of a product alone in its file: Y, or R,G,B.
std::vector<ImageChannel> separate_channels(const Surface& surface, const FieldInfo& product,
                                            const ExrOptions& options);
/// Channels of several products in one file.
std::vector<ImageChannel> layered_channels(const Surface& surface,
                                           std::span<const FieldInfo* const> products,
                                           const ExrOptions& options);

}  // namespace ocean::io
