// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The formats of this folder, and what several of them need.
#pragma once

#include <string>
#include <vector>

#include "ocean/bake/catalogue.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/io/product_image.hpp"

namespace ocean {

extern const BakeFormat kExrFormat;
extern const BakeFormat kDf3Format;
extern const BakeFormat kHeightFieldFormat;
extern const BakeFormat kMesh2Format;
extern const BakeFormat kPlyFormat;
extern const BakeFormat kObjFormat;
extern const BakeFormat kUsdFormat;
extern const BakeFormat kVdbFormat;

/// "normal, foam". Throws Error invalid_value for a name that is unknown or there twice.
std::vector<const Product*> find_products(const std::string& list, const Catalogue& catalogue);

/// Returns those products of a default list whose channels the subject has.
std::vector<const Product*> those_of(const Subject& subject,
                                     const std::vector<const Product*>& products);

/// --axes of what lies in the world, zup if it is not given. Throws Error invalid_value for tnb,
/// which is of maps alone: "of a mesh allowed are ...".
io::Axes read_up_axes(const BakeOptions& options, std::string_view what);

/// R, R/2, ... 32.
std::vector<int> halving_resolutions(int resolution);

}  // namespace ocean
