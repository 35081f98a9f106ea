// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/detail_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ocean/directional_spectrum.hpp"
#include "ocean/error.hpp"
#include "ocean/text.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

bool is_detail(const Product& product) {
    return std::ranges::any_of(kDetailProducts,
                               [&](const Product& detail) { return detail.name == product.name; });
}

std::optional<std::size_t> band_of(const Product& product) {
    for (std::size_t i = 1; i < kDetailProducts.size(); ++i) {
        if (kDetailProducts[i].name == product.name) return i - 1;
    }
    return std::nullopt;
}

std::vector<const Product*> with_bands(const std::vector<const Product*>& products,
                                       const Parameters& parameters,
                                       const DetailSettings& settings) {
    std::vector<const Product*> all;
    for (const Product* product : products) {
        if (!is_detail(*product)) {
            all.push_back(product);
            continue;
        }
        const std::size_t bands = detail_bands(parameters, settings).size();
        const auto band = band_of(*product);
        if (bands == 0 || band.value_or(0) >= bands) {
            throw Error(ErrorKind::invalid_value,
                        "--products " + std::string(product->name) + ": beside a map of " +
                            std::to_string(settings.resolution) + " samples this sea has " +
                            (bands == 0 ? "no waves left down to 12 mm"
                                        : std::to_string(bands) + " bands"));
        }
        const std::size_t first = band.value_or(0);
        const std::size_t last = band ? first : bands - 1;
        for (std::size_t i = first; i <= last; ++i) {
            const Product* const one = &kDetailProducts[i + 1];
            if (std::ranges::find(all, one) != all.end()) {
                throw Error(ErrorKind::invalid_value,
                            "--products: " + std::string(one->name) + " is there twice");
            }
            all.push_back(one);
        }
    }
    return all;
}

DetailBudget DetailBudgets::of(const BakePlan& plan, int frame, const DetailSettings& settings) {
    const std::lock_guard lock(mutex_);
    const int key = plan.sea.take.empty() ? 0 : frame;
    const auto found = found_.find(key);
    if (found != found_.end()) return found->second;
    ThreadPool alone(1);
    const Parameters parameters = plan.sea.at(plan.sea.time_of(frame));
    return found_[key] = detail_budget(parameters, make_directional_spectrum(parameters, alone),
                                       settings, alone);
}

namespace {

/// A variance in eight decimals: all machines agree on them.
std::string variance_text(double variance) {
    return shortest_text(std::round(variance * 1e8) / 1e8);
}

}  // namespace

std::vector<io::HeaderString> band_strings(const DetailBudget& budget, std::size_t band,
                                           int map_resolution) {
    const DetailBand& own = budget.bands[band];
    return {{"ocean:map_resolution", std::to_string(map_resolution)},
            {"ocean:tile", shortest_text(own.tile)},
            {"ocean:longest_wave", shortest_text(own.longest_wave)},
            {"ocean:shortest_wave", shortest_text(own.shortest_wave)},
            {"ocean:slope_variance", variance_text(own.variance.x) + "," +
                                         variance_text(own.variance.y) + "," +
                                         variance_text(own.variance.xy)},
            {"ocean:slope_residual", variance_text(budget.residual)}};
}

Surface band_surface(const Detail& detail, std::size_t band) {
    Surface surface(Lattice{detail.samples(), detail.bands()[band].tile}, detail.time(),
                    {Channel::slope_x, Channel::slope_y});
    const std::span<const float> slopes = detail.slopes(band);
    const std::span<float> x = surface.channel(Channel::slope_x);
    const std::span<float> y = surface.channel(Channel::slope_y);
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = slopes[2 * i];
        y[i] = slopes[2 * i + 1];
    }
    return surface;
}

}  // namespace ocean
