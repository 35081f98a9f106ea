// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of a bake's formats, products, backends and subjects; options, help texts and plans
// are loops over them. A program adds its own by passing a longer table.
//
//     const Catalogue& standard = standard_catalogue();
//     std::vector<const BakeFormat*> formats(standard.formats.begin(), standard.formats.end());
//     formats.push_back(&kStats);  // of this program: typed_format.hpp
//     Catalogue own = standard;
//     own.formats = formats;
//     const BakePlan plan = make_bake_plan(options, own);
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/backend.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/channel.hpp"
#include "ocean/subject.hpp"

namespace ocean {

struct MadeProduct;

/// The value of `--backend` for the fastest backend on this machine.
inline constexpr std::string_view kAutoBackend = "auto";

/// A format that needs a library. A program that was built without the library refuses the files
/// and the options by its name.
struct FormatLibrary {
    std::string_view extension;
    std::string_view library;  // "OpenVDB"
    std::string_view family;   // the heading of the options, BakeFormat::family
    /// Options that only this format has.
    std::span<const char* const> options = {};
};

/// A kind of subject, and the function that reads it back from the text in a baked file.
struct SubjectReader {
    std::string_view kind;
    /// Returns the subject; `name` is its path in messages. Throws Error.
    std::unique_ptr<Subject> (*parse)(std::string_view text, const std::string& name);
};

struct Catalogue {
    std::span<const BakeFormat* const> formats;
    std::span<const Product> products;  // including the products of `made`
    std::span<const Backend> backends;
    std::span<const SubjectReader> subjects;
    std::span<const ChannelInfo> channels = {};  // beside the library's own
    std::span<const MadeProduct* const> made = {};
    std::span<const FormatLibrary> libraries = {};  // of all formats that need one

    /// Returns the format with an extension in lower case, ".exr"; null if none has it.
    const BakeFormat* find_format(std::string_view extension) const;
    /// Returns the format whose frame files have the extension; null if none has it.
    const BakeFormat* find_format_of_frame(std::string_view extension) const;
    /// Returns true if the format of a row of `libraries` is not among `formats`.
    bool lacks(const FormatLibrary& one) const { return find_format(one.extension) == nullptr; }
    /// Returns "EXR, DF3, PNG ...", the labels of the formats; with `displaced` only of the formats
    /// that can hold a displaced subject.
    std::string format_labels(bool displaced) const;
    /// Returns "cpu, radix2, dft or auto".
    std::string backend_names() const;
};

/// Returns the rows for Catalogue::products: the products of channels, then the products of each
/// family.
std::vector<Product> all_products(std::span<const Product> of_channels,
                                  std::span<const MadeProduct* const> made);

/// Returns the library's own tables.
const Catalogue& standard_catalogue();

}  // namespace ocean
