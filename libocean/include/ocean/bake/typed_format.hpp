// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How a format of baked files is written: functions over settings of the format's own type.
// bake_format() makes the row of it that catalogues and plans hold. At the end of this header,
// likewise, products that are made of a whole frame.
//
//     struct Settings { int digits = 3; };
//     constexpr BakeFormatOf<Settings> kStatsOf = {
//         .name = "stats", .extension = ".stats", .family = "Statistics",
//         .read_options = read_options, .resolve = resolve, .files = list_files, .recipe = recipe,
//         .is_baked = is_baked, .max_bytes = max_bytes, .write = write,  // functions of its own
//     };
//     constexpr BakeFormat kStats = bake_format<kStatsOf>();  // a row for a Catalogue
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "ocean/bake/format.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/channel.hpp"
#include "ocean/surface.hpp"

namespace ocean {

/// Shared files that list the frames of their folder. For these the plan's all_frames also holds
/// the frames of earlier chunks, and they are written again after the frames.
template <typename Settings>
struct FrameListsOf {
    std::size_t count;  // of files, the first ones of SharedFilesOf::list
    /// Returns true if an existing frame file shows the plan's subject with the plan's options,
    /// whatever its frame.
    Required<bool(const BakePlan& plan, const Settings& settings, const BakeFile& file)>
        matches_plan;
    /// True if readers silently interpolate missing frames.
    bool interpolates_missing_frames = false;
};

/// Files that all frames of a plan share, such as a USD stage.
template <typename Settings>
struct SharedFilesOf {
    Required<std::vector<BakeFile>(const BakePlan& plan, const Settings& settings)> list;
    /// Writes one shared file. Every shard must write identical bytes.
    Required<void(const BakePlan& plan, const Settings& settings, const BakeFile& file)> write;
    std::optional<FrameListsOf<Settings>> frame_lists = {};
};

/// A format with settings of one type, for a constant at namespace scope. A required function that
/// is left out does not compile; other functions that are left out do nothing.
template <typename Settings>
struct BakeFormatOf {
    using settings_type = Settings;

    std::string_view name;                  // "height_field"
    std::string_view extension;             // in lower case with its dot, ".png"
    std::string_view frame_extension = {};  // of frame files, if it differs from `extension`
    std::string_view label = {};            // in lists of formats, "EXR"; empty: `name`
    std::string_view family;                // heading of its options in help texts, "EXR files"
    std::string_view summary = {};          // what it writes, in a line of help; empty: `family`
    std::string_view example = {};          // options of its example in help, "--mist 0.1"
    /// False if files hold heights of places only: a displaced subject, such as a sea, is refused.
    bool holds_displaced = true;
    /// Memory of a library that is loaded for this format alone [bytes].
    std::uint64_t library_bytes = 0;

    /// Returns the options that files of this format have.
    std::vector<FormatOption> (*options)(const Catalogue& catalogue) = [](const Catalogue&) {
        return std::vector<FormatOption>{};
    };
    /// Returns the products among which --products chooses; nothing for a format without a choice.
    std::optional<ProductChoice> (*product_choice)(const Catalogue& catalogue) =
        [](const Catalogue&) { return std::optional<ProductChoice>{}; };
    /// Returns the settings that the options request, before the subject is known. Throws Error.
    Required<Settings(const BakeOptions& options, const Catalogue& catalogue)> read_options;
    /// Returns the products that the settings of a draft request; a draft with products that its
    /// subject does not have is refused. For formats with a choice of products.
    std::vector<const Product*> (*products)(const BakePlan& draft, const Settings& settings) =
        [](const BakePlan&, const Settings&) { return std::vector<const Product*>{}; };
    /// Returns the format's part of the plan, for a draft that has its subject and its resolution.
    /// Throws Error.
    Required<FormatPlan<Settings>(const BakePlan& draft, const Settings& requested)> resolve;
    /// Returns the files of a frame in the order in which they are written. Must be cheap: it is
    /// called for all frames of a bake before the first one is baked.
    Required<std::vector<BakeFile>(const BakePlan& plan, const Settings& settings, int frame)>
        files;
    std::optional<SharedFilesOf<Settings>> shared = {};
    /// Returns the SHA-256 of everything that decides the content of a file.
    Required<std::string(const BakePlan& plan, const Settings& settings, const BakeFile& file)>
        recipe;
    /// Returns true if an existing file looks like one that a bake wrote, of any subject: any other
    /// file is the user's and is not replaced. Reads the beginning of the file only.
    Required<bool(const BakeFile& file)> is_baked;
    /// Returns the memory that a frame needs beside its maps [bytes], an upper bound.
    std::uint64_t (*frame_bytes)(const BakePlan& plan, const Settings& settings) =
        [](const BakePlan&, const Settings&) { return std::uint64_t{0}; };
    /// Returns an upper bound of a file's size [bytes].
    Required<std::uint64_t(const BakePlan& plan, const Settings& settings, const BakeFile& file)>
        max_bytes;
    /// Writes the files of a frame, each by work.write_and_verify.
    Required<void(const FrameWork& work, const Settings& settings, std::span<const BakeFile> files)>
        write;
    /// Passes the decoded samples of a file to `sink`, whatever its compression, and returns true;
    /// returns false for a file that is not an image. Throws Error bad_file for a file that is
    /// damaged, or that is not the plan's.
    bool (*read_pixels)(const BakePlan& plan, const Settings& settings, const BakeFile& file,
                        int threads, const io::ByteSink& sink) =
        [](const BakePlan&, const Settings&, const BakeFile&, int, const io::ByteSink&) {
            return false;
        };
    /// True if read_pixels throws for every file that the plan would not write. Files of other
    /// formats are recognised by the manifest only.
    bool header_proves_recipe = false;
    /// Returns the strings of a baked file's header. Throws Error bad_file. Null for a format whose
    /// files have no header.
    std::vector<io::HeaderString> (*read_header)(const std::string& path) = nullptr;
    /// Sets the options that were not given from the header of a baked file (--from).
    void (*adopt)(const BakedHeader& header, const Catalogue& catalogue,
                  BakeOptions& options) = [](const BakedHeader&, const Catalogue&, BakeOptions&) {};
};

/// Settings of a format without options.
struct NoSettings {};

/// Returns the row of a BakeFormatOf, a constant at namespace scope. The type of the settings is
/// erased here only, so that a function for other settings does not compile.
template <const auto& kOf>
constexpr BakeFormat bake_format() {
    using Settings = typename std::remove_cvref_t<decltype(kOf)>::settings_type;
    using Plan = const BakePlan&;
    using File = const BakeFile&;
    constexpr bool kHasLists = kOf.shared.has_value() && kOf.shared->frame_lists.has_value();
    return {
        .name = kOf.name,
        .extension = kOf.extension,
        .frame_extension = kOf.frame_extension,
        .label = kOf.label.empty() ? kOf.name : kOf.label,
        .family = kOf.family,
        .summary = kOf.summary.empty() ? kOf.family : kOf.summary,
        .example = kOf.example,
        .holds_displaced = kOf.holds_displaced,
        .library_bytes = kOf.library_bytes,
        .options = kOf.options,
        .product_choice = kOf.product_choice,
        .read_options =
            +[](const BakeOptions& options, const Catalogue& catalogue) {
                return ErasedSettings::of<Settings>(kOf.read_options(options, catalogue));
            },
        .products = +[](Plan draft) { return kOf.products(draft, draft.settings.as<Settings>()); },
        .resolve =
            +[](Plan draft) {
                FormatPlan<Settings> plan = kOf.resolve(draft, draft.settings.as<Settings>());
                return FormatPlan<ErasedSettings>{
                    std::move(plan.maps), ErasedSettings::of<Settings>(std::move(plan.settings)),
                    std::move(plan.named_products), std::move(plan.note)};
            },
        .files = +[](Plan plan,
                     int frame) { return kOf.files(plan, plan.settings.as<Settings>(), frame); },
        .has_shared_files = kOf.shared.has_value(),
        .shared_files =
            +[](Plan plan) {
                if (!kOf.shared) return std::vector<BakeFile>{};
                return kOf.shared->list(plan, plan.settings.as<Settings>());
            },
        .write_shared =
            +[](Plan plan, File file) {
                if (kOf.shared) kOf.shared->write(plan, plan.settings.as<Settings>(), file);
            },
        .frame_lists = kHasLists ? kOf.shared->frame_lists->count : 0,
        .matches_plan =
            +[](Plan plan, File file) {
                if constexpr (kHasLists) {
                    return kOf.shared->frame_lists->matches_plan(plan, plan.settings.as<Settings>(),
                                                                 file);
                }
                return false;
            },
        .interpolates_missing_frames =
            kHasLists && kOf.shared->frame_lists->interpolates_missing_frames,
        .recipe = +[](Plan plan,
                      File file) { return kOf.recipe(plan, plan.settings.as<Settings>(), file); },
        .is_baked = kOf.is_baked,
        .frame_bytes =
            +[](Plan plan) { return kOf.frame_bytes(plan, plan.settings.as<Settings>()); },
        .max_bytes =
            +[](Plan plan, File file) {
                return kOf.max_bytes(plan, plan.settings.as<Settings>(), file);
            },
        .write =
            +[](const FrameWork& work, std::span<const BakeFile> files) {
                kOf.write(work, work.plan.settings.as<Settings>(), files);
            },
        .read_pixels =
            +[](Plan plan, File file, int threads, const io::ByteSink& sink) {
                return kOf.read_pixels(plan, plan.settings.as<Settings>(), file, threads, sink);
            },
        .header_proves_recipe = kOf.header_proves_recipe,
        .read_header = kOf.read_header,
        .adopt = kOf.adopt,
    };
}

// ---- Products that are made of a whole frame instead of the channels of a sample, as a bake of
// images sees them. A new family is one constant in one file of bake/products/, and one line of the
// table in catalogue.cpp; formats are loops over that table.

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
