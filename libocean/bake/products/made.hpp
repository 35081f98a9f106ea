// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The made products that a plan asks for: what formats of images do with them.
#pragma once

#include <any>
#include <span>
#include <vector>

#include "ocean/bake/catalogue.hpp"

namespace ocean {

/// A family of made products that is asked for, with its own settings.
struct Made {
    const MadeProduct* of;
    std::any settings;

    bool has_tiles() const { return !of->tiles.empty(); }
};

/// Returns the options of all families, by name.
std::vector<FormatOption> made_options(const Catalogue& catalogue);

/// Returns those families that have one of the products, with what the options say. Throws Error
/// invalid_value for an option of another family, and for tiles in a layered file.
std::vector<Made> read_made(const BakeOptions& options, const Catalogue& catalogue,
                            std::span<const Product* const> products, bool is_layered);

/// Returns which of the families makes the product; null for one of channels.
const Made* maker_of(const Product& product, std::span<const Made> made);

}  // namespace ocean
