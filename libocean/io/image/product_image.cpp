// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of channels suit their readers. Cycles reads the first three or four channels, R,G,B,A
// first, under any name, and reads two channels as grey and alpha. Blender drops a channel whose
// last token is longer than one letter. So a single product is Y or R,G,B, a layered file has bare
// R,G,B,A for the displacement, and all other names end in one letter.
#include "ocean/internal/io/product_image.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/nearest_name.hpp"

namespace ocean::io {
namespace {

// Component c of a vector in a file is `sign` times component `source` of the z-up vector.
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

PixelType pixel_type(const Product& product, const ProductLayout& layout) {
    if (layout.type) return *layout.type;
    const bool is_only_position = layout.full_heights && product.set() == Channel::height;
    return product.precision == Precision::full || is_only_position ? PixelType::full_float
                                                                    : PixelType::half_float;
}

/// Builds the planes of an image, with the samples of a surface if it has one.
class ProductPlanes {
  public:
    ProductPlanes(const ProductLayout& layout, const Surface* surface,
                  std::span<const MadeMap> made)
        : layout_(layout), surface_(surface), made_(made) {}

    std::vector<ImagePlane> of(std::span<const Product* const> products) const {
        if (!layout_.layered) return separate(*products.front());
        std::vector<ImagePlane> planes;
        for (const Product* product : products) {
            for (ImagePlane& plane : layer(*product)) planes.push_back(std::move(plane));
        }
        return planes;
    }

  private:
    std::span<const float> made(const Product& product) const {
        if (surface_ == nullptr) return {};
        const auto found = std::ranges::find(made_, &product, &MadeMap::product);
        if (found != made_.end() && found->samples.size() == surface_->domain().count()) {
            return found->samples;
        }
        throw Error(ErrorKind::invalid_value,
                    "no map was made of '" + std::string(product.name) + "' for the surface");
    }

    std::span<const float> samples(const Product& product, Channel channel) const {
        if (surface_ == nullptr) return {};
        if (surface_->has(channel)) return surface_->channel(channel);
        throw Error(ErrorKind::invalid_value,
                    "the surface was evaluated without the channels of '" +
                        std::string(product.name) + "'");
    }

    /// Adds a product as X, Y, Z, or V for a scalar; scalars do not depend on the axes.
    std::vector<ImagePlane> components(const Product& product) const {
        if (product.count == 0) return {{"V", pixel_type(product, layout_), made(product)}};
        const auto order = component_order(product.vector ? layout_.axes : Axes::zup);
        std::vector<ImagePlane> planes;
        for (int c = 0; c < product.count; ++c) {
            const auto [source, sign] = order[static_cast<std::size_t>(c)];
            planes.push_back(
                {product.count == 1 ? "V" : std::string(1, "XYZ"[c]), pixel_type(product, layout_),
                 samples(product, product.channels[static_cast<std::size_t>(source)]), sign});
        }
        return planes;
    }

    std::vector<ImagePlane> separate(const Product& product) const {
        std::vector<ImagePlane> planes = components(product);
        if (planes.size() == 1) {
            planes[0].name = "Y";
            return planes;
        }
        // A slope is R,G and an empty B, because Cycles would read two channels as grey and alpha.
        planes.resize(3, ImagePlane{.type = planes[0].type});
        for (std::size_t c = 0; c < 3; ++c) planes[c].name = std::string(1, "RGB"[c]);
        return planes;
    }

    std::vector<ImagePlane> layer(const Product& product) const {
        if (product.name == "displacement") {
            std::vector<ImagePlane> planes = separate(product);
            planes.push_back({.name = "A", .type = planes.back().type, .constant = 1.0f});
            return planes;
        }
        std::vector<ImagePlane> planes = components(product);
        for (ImagePlane& plane : planes) plane.name = std::string(product.name) + "." + plane.name;
        return planes;
    }

    const ProductLayout& layout_;
    const Surface* surface_;
    std::span<const MadeMap> made_;
};

Image make_image(std::span<const Product* const> products, const ProductLayout& layout,
                 const Provenance& provenance, const Domain& domain, const Surface* surface,
                 std::span<const MadeMap> made = {}) {
    if (products.empty()) {
        throw Error(ErrorKind::invalid_value, "an image needs at least one product");
    }
    return {.width = domain.samples[0],
            .height = domain.samples[1],
            .domain = domain,
            .planes = ProductPlanes(layout, surface, made).of(products),
            .provenance = provenance,
            .strings = product_strings(products, axes_name(layout.axes))};
}

}  // namespace

Axes find_axes(std::string_view name) {
    if (const auto axes = enumerator_of<Axes>(name)) return *axes;
    throw Error(ErrorKind::invalid_value, "axes '" + std::string(name) + "' are unknown" +
                                              did_you_mean(name, kEnumWords<Axes>) +
                                              "; allowed: tnb, zup, yup");
}

std::string_view axes_name(Axes axes) {
    return word_of(axes);
}

Image product_image(std::span<const Product* const> products, const ProductLayout& layout,
                    const Provenance& provenance, int resolution) {
    Domain domain = provenance.domain.value_or(Domain{});
    if (domain.samples[0] != resolution) domain.samples = {resolution, resolution};
    return make_image(products, layout, provenance, domain, nullptr);
}

Image product_image(std::span<const Product* const> products, const ProductLayout& layout,
                    const Provenance& provenance, const Surface& surface,
                    std::span<const MadeMap> made) {
    return make_image(products, layout, provenance, surface.domain(), &surface, made);
}

}  // namespace ocean::io
