// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "products/requested_families.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "ocean/bake/plan.hpp"
#include "refuse.hpp"

namespace ocean {

std::vector<FormatOption> family_options(const Catalogue& catalogue) {
    std::vector<FormatOption> all;
    for (const MadeProduct* made : catalogue.made) {
        std::ranges::move(made->options(), std::back_inserter(all));
    }
    std::ranges::sort(all, {}, &FormatOption::name);
    return all;
}

std::vector<RequestedFamily> read_families(const BakeOptions& options, const Catalogue& catalogue,
                                           std::span<const Product* const> products,
                                           bool is_layered) {
    std::vector<RequestedFamily> families;
    for (const MadeProduct* made : catalogue.made) {
        const bool is_requested = made->is_among(products);
        for (const FormatOption& option : made->options()) {
            const std::string& value = options.format_option(option.name);
            if (value.empty() || is_requested) continue;
            refuse("--" + option.name + " " + value + ": needs " +
                   std::string(made->products.front().name) + " among the --products");
        }
        if (!is_requested) continue;
        if (is_layered && !made->tiles.empty()) {
            refuse("--layout layered: " + std::string(made->tiles) +
                   " do not have the size of the sea's map");
        }
        families.push_back({made, made->read(options)});
    }
    return families;
}

const RequestedFamily* maker_of(const Product& product, std::span<const RequestedFamily> families) {
    const auto found = std::ranges::find_if(
        families, [&](const RequestedFamily& family) { return family.row->has(product); });
    return found == families.end() ? nullptr : &*found;
}

}  // namespace ocean
