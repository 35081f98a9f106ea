// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The formats of this folder, and the helpers that several of them share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ocean/bake/catalogue.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/internal/io/product_image.hpp"

namespace ocean {

extern const BakeFormat kExrFormat;
extern const BakeFormat kDf3Format;
extern const BakeFormat kHeightFieldFormat;
extern const BakeFormat kMesh2Format;
extern const BakeFormat kPlyFormat;
extern const BakeFormat kObjFormat;
extern const BakeFormat kUsdFormat;
extern const BakeFormat kVdbFormat;
extern const BakeFormat kGeotiffFormat;

/// Returns "a, b or c".
std::string listing(const std::vector<std::string>& words, std::string_view conjunction);

/// Returns the products of "normal, foam". Throws Error invalid_value for a name that is unknown or
/// repeated.
std::vector<const Product*> find_products(const std::string& list, const Catalogue& catalogue);

struct ChosenProducts {
    std::vector<const Product*> products;
    bool is_default = false;  // --products was not given

    bool has(const Product& product) const;
};

/// Returns the products that --products requests. Throws Error invalid_value.
ChosenProducts choose_products(const BakeOptions& options, const ProductChoice& choice);

/// Returns the products of a default list whose channels the subject has.
std::vector<const Product*> available_products(const Subject& subject,
                                               const std::vector<const Product*>& products);

/// Returns true if points of the subject move sideways, by dx and dy.
bool is_displaced(const Subject& subject);

/// Returns the --axes of data in world coordinates; the default is zup. Throws Error invalid_value
/// for tnb, which only maps have; `holder` names the data in the message, "a mesh".
io::Axes read_up_axes(const BakeOptions& options, std::string_view holder);

/// Returns the strings in the header of a file; none for a file that `read` refuses.
std::vector<io::HeaderString> header_or_none(
    std::vector<io::HeaderString> (*read)(const std::string& path), const std::string& path);

/// Returns the heights of a frame's first map, with provenance and the resolution of the map.
io::Image height_image(const FrameWork& work);

/// Returns R, R/2, ... 32.
std::vector<int> halving_resolutions(int resolution);

}  // namespace ocean
