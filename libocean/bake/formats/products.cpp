// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "formats/formats.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/text.hpp"

namespace ocean {

std::vector<const Product*> find_products(const std::string& list, const Catalogue& catalogue) {
    std::vector<const Product*> products;
    for (const std::string& part : split(list, ',')) {
        const std::string name(csv::trimmed(part));
        const Product* product = &find_product(name, catalogue.products);
        if (std::find(products.begin(), products.end(), product) != products.end()) {
            throw Error(ErrorKind::invalid_value,
                        "--products " + list + ": " + name + " is there twice");
        }
        products.push_back(product);
    }
    return products;
}

std::vector<const Product*> those_of(const Subject& subject,
                                     const std::vector<const Product*>& products) {
    std::vector<const Product*> there;
    std::ranges::copy_if(products, std::back_inserter(there), [&](const Product* product) {
        return subject.channels().contains(product->set());
    });
    return there;
}

io::Axes read_up_axes(const BakeOptions& options, std::string_view what) {
    const std::string& text = options.format_option("axes");
    if (text.empty()) return io::Axes::zup;
    const io::Axes axes = io::find_axes(text);
    if (axes != io::Axes::tnb) return axes;
    throw Error(ErrorKind::invalid_value,
                "--axes tnb: of " + std::string(what) + " allowed are zup and yup");
}

}  // namespace ocean
