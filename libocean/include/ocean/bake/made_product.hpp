// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Products that are made of a whole frame instead of the channels of a sample: all that a bake of
// images knows of them. One constant in one file of bake/products/, and one line of the table in
// catalogue.cpp, make a new one; formats are loops over that table.
#pragma once

#include <algorithm>
#include <any>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "ocean/bake/format.hpp"
#include "ocean/channel.hpp"
#include "ocean/surface.hpp"

namespace ocean {

/// The samples of one product: either a map of the frame's size, or a tile of its own size.
struct MadeSamples {
    std::vector<float> map = {};  // of a product without channels, [j][i]
    Surface tile = {};            // with the product's channels
};

/// Returns the samples of a product. It is called once for each product of a frame, when its file
/// is about to be written, so that a frame need not hold all of them.
using MadeFrame = std::function<MadeSamples(const Product& product)>;

/// What becomes of the products that a plan asks for, once the subject is known.
template <typename Settings>
struct MadePlan {
    std::vector<const Product*> products;  // those of others too, all in the order of their files
    ChannelSet channels;                   // of the frame's map, that the products are made of
    Settings settings;
};

/// A family of made products with settings of one type. Functions that are left out do
/// nothing; they are not null.
template <typename Settings>
struct MadeProductOf {
    using settings_type = Settings;

    /// The first one is the name of the family in messages.
    std::span<const Product> products;
    /// What its maps are called where they have a size of their own, "slope tiles": no layered file
    /// holds them. Empty: they have the size of the frame's map.
    std::string_view tiles = {};
    /// Refused where none of the products is asked for. A help text sorts them by name.
    std::vector<FormatOption> (*options)() = [] { return std::vector<FormatOption>{}; };
    /// Returns the settings that the options ask for, before there is a subject. Throws Error.
    Required<Settings(const BakeOptions& options)> read;
    /// `products` are all that the plan asks for. Throws Error.
    Required<MadePlan<Settings>(const BakePlan& begun, const Settings& asked,
                                const std::vector<const Product*>& products)>
        settle;
    /// Returns the samples along a side of a tile.
    int (*tile_samples)(const Settings& settings) = [](const Settings&) { return 0; };
    /// Returns what the header of a product's file says of it, known before the product is made.
    std::vector<io::HeaderString> (*strings)(const BakePlan& plan, const Settings& settings,
                                             int frame, const Product& product) =
        [](const BakePlan&, const Settings&, int, const Product&) {
            return std::vector<io::HeaderString>{};
        };
    /// Returns the memory [bytes] that a frame needs for them, at most.
    std::uint64_t (*frame_bytes)(const BakePlan& plan, const Settings& settings) =
        [](const BakePlan&, const Settings&) { return std::uint64_t{0}; };
    Required<MadeFrame(const FrameWork& work, const Settings& settings)> make;
    /// Takes what was not typed from the header of a baked file that holds one of them.
    void (*adopt)(const BakedHeader& header, BakeOptions& options) = [](const BakedHeader&,
                                                                        BakeOptions&) {};
};

/// The same without the type of the settings, for a table of all families. See made_product().
struct MadeProduct {
    std::span<const Product> products;
    std::string_view tiles;
    std::vector<FormatOption> (*options)();
    std::any (*read)(const BakeOptions& options);
    MadePlan<std::any> (*settle)(const BakePlan& begun, const std::any& asked,
                                 const std::vector<const Product*>& products);
    int (*tile_samples)(const std::any& settings);
    std::vector<io::HeaderString> (*strings)(const BakePlan& plan, const std::any& settings,
                                             int frame, const Product& product);
    std::uint64_t (*frame_bytes)(const BakePlan& plan, const std::any& settings);
    MadeFrame (*make)(const FrameWork& work, const std::any& settings);
    void (*adopt)(const BakedHeader& header, BakeOptions& options);

    bool has(const Product& product) const {
        return std::ranges::any_of(products,
                                   [&](const Product& own) { return own.name == product.name; });
    }
    /// Whether one of them is in the list.
    bool is_among(std::span<const Product* const> list) const {
        return std::ranges::any_of(list, [this](const Product* product) { return has(*product); });
    }
};

/// Returns the row of a MadeProductOf, a constant at namespace scope. The only place where the type
/// of the settings is lost, so that a function for other settings does not compile.
template <const auto& kOf>
constexpr MadeProduct made_product() {
    using Settings = typename std::remove_cvref_t<decltype(kOf)>::settings_type;
    using Any = const std::any&;
    using Typed = const Settings&;
    using List = std::vector<const Product*>;
    return {
        .products = kOf.products,
        .tiles = kOf.tiles,
        .options = kOf.options,
        .read = [](const BakeOptions& options) -> std::any { return kOf.read(options); },
        .settle =
            [](const BakePlan& begun, Any asked, const List& products) {
                MadePlan<Settings> plan = kOf.settle(begun, std::any_cast<Typed>(asked), products);
                return MadePlan<std::any>{std::move(plan.products), plan.channels,
                                          std::move(plan.settings)};
            },
        .tile_samples =
            [](Any settings) { return kOf.tile_samples(std::any_cast<Typed>(settings)); },
        .strings =
            [](const BakePlan& plan, Any settings, int frame, const Product& product) {
                return kOf.strings(plan, std::any_cast<Typed>(settings), frame, product);
            },
        .frame_bytes =
            [](const BakePlan& plan, Any settings) {
                return kOf.frame_bytes(plan, std::any_cast<Typed>(settings));
            },
        .make = [](const FrameWork& work,
                   Any settings) { return kOf.make(work, std::any_cast<Typed>(settings)); },
        .adopt = kOf.adopt,
    };
}

}  // namespace ocean
