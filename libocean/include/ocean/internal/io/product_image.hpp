// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The products of a subject as an image: names, order, signs and types of the channels, and the
// header strings that say which subject and which moment it is.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "ocean/channel.hpp"
#include "ocean/internal/io/provenance.hpp"
#include "ocean/io/image.hpp"
#include "ocean/surface.hpp"

namespace ocean::io {

/// Order of vector components: zup (x, y, z), yup (x, z, -y), tnb (x, z, y).
enum class Axes { zup, yup, tnb };
/// Returns the axes called "zup", "yup" or "tnb". Throws Error invalid_value.
Axes find_axes(std::string_view name);
std::string_view axes_name(Axes axes);

struct ProductLayout {
    Axes axes = Axes::tnb;
    /// Absent: the type of the product's row.
    std::optional<PixelType> type = {};
    /// True: a height without `type` is a float. For subjects whose only position is the height: a
    /// half would be metres off.
    bool full_heights = false;
    /// false: one product as R,G,B or Y. true: all products in one image for compositors, R,G,B,A =
    /// displacement and 1, then normal.X ...
    bool layered = false;
};

/// The samples of a product without channels, as many as the surface of the image has.
struct MadeMap {
    const Product* product;
    std::span<const float> samples;
};

/// Returns the image of one product, or a layered image of several, without samples, for use before
/// the surface is computed. Throws Error invalid_value without products.
Image product_image(std::span<const Product* const> products, const ProductLayout& layout,
                    const Provenance& provenance, int resolution);
/// Returns the image of one product, or a layered image of several, with the samples of the
/// surface, or of `made` for products without channels. Surface and maps must outlive the image.
/// Throws Error invalid_value if the surface lacks a channel of the products, or `made` lacks one.
Image product_image(std::span<const Product* const> products, const ProductLayout& layout,
                    const Provenance& provenance, const Surface& surface,
                    std::span<const MadeMap> made = {});

}  // namespace ocean::io
