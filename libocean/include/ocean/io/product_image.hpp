// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The products of a sea as an image: names, order, signs and types of the channels, and the header
// strings that say which sea and which moment it is.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "ocean/channel.hpp"
#include "ocean/io/image.hpp"
#include "ocean/io/provenance.hpp"
#include "ocean/surface.hpp"

namespace ocean::io {

/// Order of vector components: zup (x, y, z), yup (x, z, -y), tnb (x, z, y).
enum class Axes { zup, yup, tnb };
/// "zup", "yup", "tnb"; throws Error invalid_value.
Axes find_axes(std::string_view name);
std::string_view axes_name(Axes axes);

struct ProductLayout {
    Axes axes = Axes::tnb;
    /// None: as the product's row says.
    std::optional<PixelType> type = {};
    /// false: one product as R,G,B or Y. true: all products in one image for compositors, R,G,B,A =
    /// displacement and 1, then normal.X ...
    bool layered = false;
};

/// The samples of a product without channels, as many as the surface beside it has.
struct MadeMap {
    const Product* product;
    std::span<const float> samples;
};

/// The image of one product, or in a layered one of several, before its surface is computed: all
/// but the samples. Throws Error invalid_value without products.
Image product_image(std::span<const Product* const> products, const ProductLayout& layout,
                    const Provenance& provenance, int resolution);
/// Returns that image with the samples of the surface, which must outlive it, and of each product
/// without channels those that were `made` for it. Throws Error invalid_value if the surface was
/// evaluated without a channel of the products, or nothing was made.
Image product_image(std::span<const Product* const> products, const ProductLayout& layout,
                    const Provenance& provenance, const Surface& surface,
                    std::span<const MadeMap> made = {});

}  // namespace ocean::io
