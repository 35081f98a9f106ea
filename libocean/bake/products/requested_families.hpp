// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The families of made products that a plan requests, for the formats of images.
#pragma once

#include <span>
#include <vector>

#include "ocean/bake/catalogue.hpp"
#include "ocean/bake/typed_format.hpp"

namespace ocean {

/// A family of made products with its settings.
struct RequestedFamily {
    const MadeProduct* row;
    ErasedSettings settings;

    bool has_tiles() const { return !row->tiles.empty(); }
};

/// Returns the options of all families, sorted by name.
std::vector<FormatOption> family_options(const Catalogue& catalogue);

/// Returns the families that make some of the products, with the settings that the options request.
/// Throws Error invalid_value for an option of another family, and for tiles in a layered file.
std::vector<RequestedFamily> read_families(const BakeOptions& options, const Catalogue& catalogue,
                                           std::span<const Product* const> products,
                                           bool is_layered);

/// Returns the family that makes the product; null for a product of channels.
const RequestedFamily* maker_of(const Product& product, std::span<const RequestedFamily> families);

}  // namespace ocean
