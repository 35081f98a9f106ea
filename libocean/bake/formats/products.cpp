// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Options that several formats have: --products and --axes.
#include <algorithm>
#include <iterator>

#include "formats/formats.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {

namespace {

[[noreturn]] void refuse(const std::string& list, const std::string& reason) {
    throw Error(ErrorKind::invalid_value, "--products " + list + ": " + reason);
}

bool is_also_allowed(const Product& product, const ProductChoice& choice) {
    return std::ranges::find(choice.also_allowed, product.name, &Product::name) !=
           choice.also_allowed.end();
}

/// Returns all words that a list may contain.
std::vector<std::string_view> names_of(const ProductChoice& choice) {
    std::vector<std::string_view> names;
    for (const Product& product : choice.known) {
        const std::vector<std::string> allowed = split(choice.allowed, ',');
        const bool is_allowed = choice.allowed.empty() ||
                                std::ranges::find(allowed, product.name) != allowed.end() ||
                                is_also_allowed(product, choice);
        if (is_allowed) names.push_back(product.name);
    }
    if (choice.alone != nullptr) names.push_back(choice.alone->name);
    if (!choice.nothing.empty()) names.push_back(choice.nothing);
    return names;
}

/// Returns the first name of the list that no product has; "" if all are known.
std::string unknown_name(const std::string& list, std::span<const Product> known) {
    for (const std::string& part : split(list, ',')) {
        const std::string name(trimmed(part));
        if (std::ranges::find(known, name, &Product::name) == known.end()) return name;
    }
    return "";
}

std::vector<const Product*> parse_products(const std::string& list,
                                           std::span<const Product> known) {
    std::vector<const Product*> products;
    for (const std::string& part : split(list, ',')) {
        const std::string name(trimmed(part));
        const Product* product = &find_product(name, known);
        if (std::ranges::find(products, product) != products.end()) {
            refuse(list, name + " is repeated");
        }
        products.push_back(product);
    }
    return products;
}

/// Returns true if the list is that product alone. Throws Error if the list has further products.
bool is_alone(const std::string& list, const Product& product) {
    if (list == product.name) return true;
    for (const std::string& part : split(list, ',')) {
        if (trimmed(part) != product.name) continue;
        const std::string name(product.name);
        refuse(list, name + " is a file of points; allowed is --products " + name + " alone");
    }
    return false;
}

void require_allowed(const std::string& list, const std::vector<const Product*>& products,
                     const ProductChoice& choice) {
    if (choice.allowed.empty()) return;
    const std::string allowed(choice.allowed);
    const auto possible = parse_products(allowed, choice.known);
    for (const Product* product : products) {
        if (std::ranges::find(possible, product) != possible.end()) continue;
        if (is_also_allowed(*product, choice)) continue;
        refuse(list, std::string(choice.holder) + " has no " + std::string(product->name) +
                         "; allowed are " + std::string(choice.nothing) + ", " + allowed +
                         (choice.also_allowed.empty() ? "" : " and the masks of a land"));
    }
}

}  // namespace

std::vector<const Product*> find_products(const std::string& list, const Catalogue& catalogue) {
    return parse_products(list, catalogue.products);
}

bool ChosenProducts::has(const Product& product) const {
    return std::ranges::any_of(products,
                               [&](const Product* one) { return one->name == product.name; });
}

ChosenProducts choose_products(const BakeOptions& options, const ProductChoice& choice) {
    const std::string& typed = options.format_option("products");
    ChosenProducts chosen;
    chosen.is_default = typed.empty();
    const std::string list = chosen.is_default ? std::string(choice.default_list) : typed;
    if (choice.alone != nullptr && is_alone(list, *choice.alone)) {
        chosen.products = {choice.alone};
    } else if (choice.nothing.empty() || list != choice.nothing) {
        try {
            chosen.products = parse_products(list, choice.known);
        } catch (const Error&) {
            const std::string unknown = unknown_name(list, choice.known);
            const std::string meant = did_you_mean(unknown, names_of(choice));
            if (!choice.one_refusal.empty()) refuse(list, std::string(choice.one_refusal) + meant);
            if (unknown.empty() || meant.empty()) throw;
            refuse(list, "unknown product '" + text::printable(unknown) + "'" + meant);
        }
        require_allowed(list, chosen.products, choice);
    }
    return chosen;
}

std::vector<const Product*> available_products(const Subject& subject,
                                               const std::vector<const Product*>& products) {
    std::vector<const Product*> available;
    std::ranges::copy_if(products, std::back_inserter(available), [&](const Product* product) {
        return subject.channels().contains(product->set());
    });
    return available;
}

bool is_displaced(const Subject& subject) {
    return subject.channels().contains({Channel::dx, Channel::dy});
}

io::Axes read_up_axes(const BakeOptions& options, std::string_view holder) {
    const std::string& text = options.format_option("axes");
    if (text.empty()) return io::Axes::zup;
    const io::Axes axes = io::find_axes(text);
    if (axes != io::Axes::tnb) return axes;
    throw Error(ErrorKind::invalid_value,
                "--axes tnb: allowed for " + std::string(holder) + " are zup and yup");
}

}  // namespace ocean
