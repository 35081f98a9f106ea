// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Slope tiles among the products of image files: which band each is, and what its file says of it.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "ocean/bake/plan.hpp"
#include "ocean/detail.hpp"

namespace ocean {

inline constexpr int kUsualDetailSamples = DetailSettings{}.samples;

/// Whether it is one of kDetailProducts.
bool is_detail(const Product& product);
/// Which band it is, 0 ..; none for other products.
std::optional<std::size_t> band_of(const Product& product);
/// The same list with all bands that there are in the place of `detail`. Throws Error for one that
/// the sea has not beside maps of that resolution, and for one that is there twice.
std::vector<const Product*> with_bands(const std::vector<const Product*>& products,
                                       const Parameters& parameters,
                                       const DetailSettings& settings);

/// What the spectrum has in the bands at each frame, for the headers of their files: found once for
/// all frames of a sea without a take. Several threads at once.
class DetailBudgets {
  public:
    DetailBudget of(const BakePlan& plan, int frame, const DetailSettings& settings);

  private:
    std::mutex mutex_;
    std::map<int, DetailBudget> found_;
};

/// Of the header of a band's file.
std::vector<io::HeaderString> band_strings(const DetailBudget& budget, std::size_t band,
                                           int map_resolution);
/// A band as a surface over its tile, with its slopes.
Surface band_surface(const Detail& detail, std::size_t band);

}  // namespace ocean
