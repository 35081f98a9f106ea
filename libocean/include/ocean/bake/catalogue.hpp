// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of a bake's formats, products, backends and subjects; options, help texts and plans
// are loops over them. A program adds its own by passing a longer table.
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

/// The value of `--backend` for the fastest backend on this machine.
inline constexpr std::string_view kAutoBackend = "auto";

/// The options that only .vdb files have. A program without OpenVDB reads them too, to refuse them
/// by the name of what it lacks.
inline constexpr const char* kVolumeOptions[] = {"box", "voxel", "velocity-voxel", "mist"};

/// A kind of subject, and the function that reads it back from the text in a baked file.
struct SubjectReader {
    std::string_view kind;
    /// Returns the subject; `name` is its path in messages. Throws Error.
    std::unique_ptr<Subject> (*parse)(std::string_view text, const std::string& name);
};

struct Catalogue {
    std::span<const BakeFormat* const> formats;
    std::span<const Product> products;  // including those of `made`
    std::span<const Backend> backends;
    std::span<const SubjectReader> subjects;
    std::span<const ChannelInfo> channels = {};  // beside the library's own
    std::span<const MadeProduct* const> made = {};

    /// Returns the format with an extension in lower case, ".exr"; null if none has it.
    const BakeFormat* find_format(std::string_view extension) const;
    /// Returns the format whose frame files have the extension; null if none has it.
    const BakeFormat* find_format_of_frame(std::string_view extension) const;
    /// Returns "height, displacement, ...".
    std::string product_names() const;
    /// Returns "cpu, radix2, dft or auto".
    std::string backend_names() const;
};

/// Returns the rows for Catalogue::products: products of channels, then those of each family.
std::vector<Product> all_products(std::span<const Product> of_channels,
                                  std::span<const MadeProduct* const> made);

/// Returns the library's own tables.
const Catalogue& standard_catalogue();

}  // namespace ocean
