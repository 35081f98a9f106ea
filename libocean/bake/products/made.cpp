// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "products/made.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"

namespace ocean {

std::vector<FormatOption> made_options(const Catalogue& catalogue) {
    std::vector<FormatOption> all;
    for (const MadeProduct* made : catalogue.made) {
        std::ranges::move(made->options(), std::back_inserter(all));
    }
    std::ranges::sort(all, {}, &FormatOption::name);
    return all;
}

std::vector<Made> read_made(const BakeOptions& options, const Catalogue& catalogue,
                            std::span<const Product* const> products, bool is_layered) {
    std::vector<Made> all;
    for (const MadeProduct* made : catalogue.made) {
        const bool is_asked_for = made->is_among(products);
        for (const FormatOption& option : made->options()) {
            const std::string& typed = options.format_option(option.name);
            if (typed.empty() || is_asked_for) continue;
            throw Error(ErrorKind::invalid_value, "--" + option.name + " " + typed + ": needs " +
                                                      std::string(made->products.front().name) +
                                                      " among the --products");
        }
        if (!is_asked_for) continue;
        if (is_layered && !made->tiles.empty()) {
            throw Error(ErrorKind::invalid_value, "--layout layered: " + std::string(made->tiles) +
                                                      " are no maps of the sea's size");
        }
        all.push_back({made, made->read(options)});
    }
    return all;
}

const Made* maker_of(const Product& product, std::span<const Made> made) {
    const auto found =
        std::ranges::find_if(made, [&](const Made& one) { return one.of->has(product); });
    return found == made.end() ? nullptr : &*found;
}

}  // namespace ocean
