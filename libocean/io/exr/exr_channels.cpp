// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Channel names are chosen by what readers do with them. Cycles takes the first three or four
// channels whatever their names, R,G,B,A first; two channels it takes for grey and alpha. Blender
// drops a channel whose last token is longer than one letter. So a product alone is Y or R,G,B, a
// layered file has bare R,G,B,A for the displacement, and all other names end in one letter.
#include "exr_channels.hpp"

#include <algorithm>
#include <array>

namespace ocean::io {
namespace {

// Component c of a file vector is `sign` times component `source` of the z-up one.
struct Component {
    int source;
    float sign;
};

std::array<Component, 3> component_order(Axes axes) {
    switch (axes) {
        case Axes::zup:
            return {{{0, 1.0f}, {1, 1.0f}, {2, 1.0f}}};
        case Axes::yup:
            return {{{0, 1.0f}, {2, 1.0f}, {1, -1.0f}}};
        case Axes::tnb:
            break;
    }
    return {{{0, 1.0f}, {2, 1.0f}, {1, 1.0f}}};
}

bool stored_as_half(const Product& product, PixelType type) {
    if (type != PixelType::automatic) return type == PixelType::half_float;
    // Half is 2 mm at 4 m: too coarse for what moves geometry.
    return product.name != "displacement" && product.name != "velocity";
}

// Components named X, Y, Z, or V for a scalar; a slope lies in the plane whatever the axes.
std::vector<ImageChannel> components(const Product& product, const ExrOptions& options) {
    const auto order = component_order(product.count == 3 ? options.axes : Axes::zup);
    std::vector<ImageChannel> result;
    for (int c = 0; c < product.count; ++c) {
        const auto [source, sign] = order[static_cast<std::size_t>(c)];
        ImageChannel image;
        image.name = product.count == 1 ? "V" : std::string(1, "XYZ"[c]);
        image.source = product.channels[static_cast<std::size_t>(source)];
        image.sign = sign;
        image.half = stored_as_half(product, options.type);
        result.push_back(image);
    }
    return result;
}

std::vector<ImageChannel> separate_channels(const Product& product, const ExrOptions& options) {
    auto channels = components(product, options);
    if (product.count == 1) {
        channels[0].name = "Y";
        return channels;
    }
    // A slope is R,G and an empty B, because Cycles would read two channels as grey and alpha.
    for (std::size_t c = 0; c < 3; ++c) {
        if (c == channels.size()) {
            channels.emplace_back();
            channels[c].half = channels[0].half;
        }
        channels[c].name = std::string(1, "RGB"[c]);
    }
    return channels;
}

std::vector<ImageChannel> layered_channels(std::span<const Product* const> products,
                                           const ExrOptions& options) {
    std::vector<ImageChannel> result;
    for (const Product* product : products) {
        if (product->name == "displacement") {
            for (ImageChannel& image : separate_channels(*product, options)) {
                result.push_back(image);
            }
            ImageChannel alpha;
            alpha.name = "A";
            alpha.constant = 1.0f;
            alpha.half = result.back().half;
            result.push_back(alpha);
            continue;
        }
        for (ImageChannel& image : components(*product, options)) {
            image.name = std::string(product->name) + "." + image.name;
            result.push_back(image);
        }
    }
    return result;
}

}  // namespace

std::vector<ImageChannel> image_channels(std::span<const Product* const> products, bool layered,
                                         const ExrOptions& options) {
    return layered ? layered_channels(products, options)
                   : separate_channels(*products.front(), options);
}

std::vector<ExrChannel> exr_channels(std::span<const Product* const> products, bool layered,
                                     PixelType type) {
    ExrOptions options;
    options.type = type;
    std::vector<ExrChannel> channels;
    for (const ImageChannel& image : image_channels(products, layered, options)) {
        channels.push_back(
            {image.name, image.half ? PixelType::half_float : PixelType::full_float});
    }
    std::sort(channels.begin(), channels.end(),
              [](const ExrChannel& a, const ExrChannel& b) { return a.name < b.name; });
    return channels;
}

}  // namespace ocean::io
