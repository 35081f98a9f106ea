// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What can be baked, and by whom: the tables that options, help texts and plans are loops over. A
// program that adds a format, a product or a backend of its own hands over a longer table.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/backend.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/bake/made_product.hpp"
#include "ocean/channel.hpp"
#include "ocean/subject.hpp"

namespace ocean {

/// As `--backend`: what is fastest on this machine.
inline constexpr std::string_view kAutoBackend = "auto";

/// A kind of subject that baked files may show, and the way back from their text to it.
struct SubjectReader {
    std::string_view kind;
    /// `name` stands for a path in messages. Throws Error.
    std::unique_ptr<Subject> (*parse)(std::string_view text, const std::string& name);
};

struct Catalogue {
    std::span<const BakeFormat* const> formats;
    std::span<const Product> products;  // with those of `made`
    std::span<const Backend> backends;
    std::span<const SubjectReader> subjects;
    std::span<const ChannelInfo> channels = {};  // beside the library's own
    std::span<const MadeProduct* const> made = {};

    /// ".exr, .df3, .png (height_field) or .inc (mesh2)", with the last conjunction.
    std::string extensions(std::string_view conjunction) const;
    /// By an extension in lower case, ".exr"; null if there is none of it.
    const BakeFormat* find_format(std::string_view extension) const;
    /// By that of a frame's own file.
    const BakeFormat* find_format_of_frame(std::string_view extension) const;
    /// "height, displacement, ...".
    std::string product_names() const;
    /// "cpu, radix2, dft or auto".
    std::string backend_names() const;
};

/// Returns the rows of Catalogue::products: those made of channels, then those of each family.
std::vector<Product> all_products(std::span<const Product> of_channels,
                                  std::span<const MadeProduct* const> made);

/// The library's own.
const Catalogue& standard_catalogue();

}  // namespace ocean
