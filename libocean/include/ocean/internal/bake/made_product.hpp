// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Products that are made of a whole frame instead of the channels of a sample, as a bake of images
// sees them. A new family is one constant in one file of bake/products/, and one line of the table
// in catalogue.cpp; formats are loops over that table.
#pragma once

#include <algorithm>
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

/// A family's part of a plan, resolved from its options and the subject.
template <typename Settings>
struct MadePlan {
    std::vector<const Product*> products;  // all made products of the plan, as their files
    ChannelSet channels;                   // the channels of the frame's map that the family needs
    Settings settings;
};

/// A family of made products with settings of one type. A required function that is left out does
/// not compile; other functions that are left out do nothing.
template <typename Settings>
struct MadeProductOf {
    using settings_type = Settings;

    /// The first one is the name of the family in messages.
    std::span<const Product> products;
    /// The name of its maps if they have a size of their own, "slope tiles": no layered file holds
    /// them. Empty: they have the size of the frame's map.
    std::string_view tiles = {};
    /// Returns its options, which are refused unless one of the products is requested.
    std::vector<FormatOption> (*options)() = [] { return std::vector<FormatOption>{}; };
    /// Returns the settings that the options request, before the subject is known. Throws Error.
    Required<Settings(const BakeOptions& options)> read;
    /// Returns the family's part of the plan; `products` are all that the draft requests. Throws
    /// Error.
    Required<MadePlan<Settings>(const BakePlan& draft, const Settings& requested,
                                const std::vector<const Product*>& products)>
        resolve;
    /// Returns the samples along a side of a tile.
    int (*tile_samples)(const Settings& settings) = [](const Settings&) { return 0; };
    /// Returns the header strings of a product's file, known before the product is made.
    std::vector<io::HeaderString> (*strings)(const BakePlan& plan, const Settings& settings,
                                             int frame, const Product& product) =
        [](const BakePlan&, const Settings&, int, const Product&) {
            return std::vector<io::HeaderString>{};
        };
    /// Returns the memory that a frame needs for the products [bytes], an upper bound.
    std::uint64_t (*frame_bytes)(const BakePlan& plan, const Settings& settings) =
        [](const BakePlan&, const Settings&) { return std::uint64_t{0}; };
    Required<MadeFrame(const FrameWork& work, const Settings& settings)> make;
    /// Sets the options that were not given from the header of a baked file that holds a product of
    /// the family.
    void (*adopt)(const BakedHeader& header, BakeOptions& options) = [](const BakedHeader&,
                                                                        BakeOptions&) {};
};

/// The row of a family in a Catalogue, without the type of its settings; made by made_product().
struct MadeProduct {
    std::span<const Product> products;
    std::string_view tiles;
    Required<std::vector<FormatOption>()> options;
    Required<ErasedSettings(const BakeOptions& options)> read;
    Required<MadePlan<ErasedSettings>(const BakePlan& draft, const ErasedSettings& requested,
                                      const std::vector<const Product*>& products)>
        resolve;
    Required<int(const ErasedSettings& settings)> tile_samples;
    Required<std::vector<io::HeaderString>(const BakePlan& plan, const ErasedSettings& settings,
                                           int frame, const Product& product)>
        strings;
    Required<std::uint64_t(const BakePlan& plan, const ErasedSettings& settings)> frame_bytes;
    Required<MadeFrame(const FrameWork& work, const ErasedSettings& settings)> make;
    Required<void(const BakedHeader& header, BakeOptions& options)> adopt;

    /// Returns true if the product is one of the family.
    bool has(const Product& product) const {
        return std::ranges::any_of(products,
                                   [&](const Product& own) { return own.name == product.name; });
    }
    /// Returns true if the list has a product of the family.
    bool is_among(std::span<const Product* const> list) const {
        return std::ranges::any_of(list, [this](const Product* product) { return has(*product); });
    }
};

/// Returns the row of a MadeProductOf, a constant at namespace scope. The type of the settings is
/// erased here only, so that a function for other settings does not compile.
template <const auto& kOf>
constexpr MadeProduct made_product() {
    using Settings = typename std::remove_cvref_t<decltype(kOf)>::settings_type;
    using Erased = const ErasedSettings&;
    using List = std::vector<const Product*>;
    return {
        .products = kOf.products,
        .tiles = kOf.tiles,
        .options = kOf.options,
        .read =
            +[](const BakeOptions& options) {
                return ErasedSettings::of<Settings>(kOf.read(options));
            },
        .resolve =
            +[](const BakePlan& draft, Erased requested, const List& products) {
                MadePlan<Settings> plan = kOf.resolve(draft, requested.as<Settings>(), products);
                return MadePlan<ErasedSettings>{
                    std::move(plan.products), plan.channels,
                    ErasedSettings::of<Settings>(std::move(plan.settings))};
            },
        .tile_samples = +[](Erased settings) { return kOf.tile_samples(settings.as<Settings>()); },
        .strings =
            +[](const BakePlan& plan, Erased settings, int frame, const Product& product) {
                return kOf.strings(plan, settings.as<Settings>(), frame, product);
            },
        .frame_bytes =
            +[](const BakePlan& plan, Erased settings) {
                return kOf.frame_bytes(plan, settings.as<Settings>());
            },
        .make = +[](const FrameWork& work,
                    Erased settings) { return kOf.make(work, settings.as<Settings>()); },
        .adopt = kOf.adopt,
    };
}

}  // namespace ocean
