// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Slope tiles as products of image files: a file for each band of the waves too short for the
// frame's map.
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "ocean/bake/plan.hpp"
#include "ocean/detail.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/ocean.hpp"
#include "ocean/provenance.hpp"
#include "ocean/seafile.hpp"
#include "ocean/thread_pool.hpp"
#include "products/products.hpp"
#include "refuse.hpp"
#include "source.hpp"

namespace ocean {
namespace {

constexpr int kDefaultSamples = DetailSettings{}.samples;

/// Caches the share of the spectrum in each band, for the headers of the bands' files. It is
/// computed once for each frame of a sea with a take, and once for all frames of any other sea. Any
/// thread.
class DetailBudgets {
  public:
    DetailBudget of(const BakePlan& plan, int frame, const DetailSettings& settings) {
        const std::lock_guard lock(mutex_);
        const Sea& sea = sea_of(*plan.subject);
        const int key = sea.take.empty() ? 0 : frame;
        const auto found = found_.find(key);
        if (found != found_.end()) return found->second;
        ThreadPool alone(1);
        const Parameters parameters = sea.at(sea.time_of(frame));
        return found_[key] = detail_budget(parameters, make_directional_spectrum(parameters, alone),
                                           settings, alone);
    }

  private:
    std::mutex mutex_;
    std::map<int, DetailBudget> found_;
};

struct TileSettings {
    std::optional<int> samples;              // along a side of a tile, as given
    DetailSettings detail = {};              // with the resolution of the frame's map
    std::shared_ptr<DetailBudgets> budgets;  // shared by all frames
};

std::vector<FormatOption> list_options() {
    return {{"detail-samples", "N",
             "Samples along a side of each slope tile: 256, 512 or 1024; default " +
                 std::to_string(kDefaultSamples),
             "", kSeaKind}};
}

TileSettings read(const BakeOptions& options) {
    TileSettings settings;
    if (const std::string& samples = options.format_option("detail-samples"); !samples.empty()) {
        settings.samples =
            parse_whole_number(samples, "--detail-samples", kMinDetailSamples, kMaxDetailSamples);
    }
    return settings;
}

/// Returns the index of the product's band; nothing for `detail`, which means all bands, and for
/// other products.
std::optional<std::size_t> band_of(const Product& product) {
    for (std::size_t i = 1; i < kDetailProducts.size(); ++i) {
        if (kDetailProducts[i].name == product.name) return i - 1;
    }
    return std::nullopt;
}

/// Returns the list with all bands of the sea in place of `detail`. Throws Error for a repeated
/// band, and for a band that the sea does not have with maps of settings.resolution.
std::vector<const Product*> with_bands(const std::vector<const Product*>& products,
                                       const Parameters& parameters,
                                       const DetailSettings& settings) {
    std::vector<const Product*> all;
    for (const Product* product : products) {
        if (!kSlopeTiles.has(*product)) {
            all.push_back(product);
            continue;
        }
        if (parameters.water.bed) {
            throw Error(ErrorKind::unsupported,
                        "--products " + std::string(product->name) +
                            ": slope tiles repeat, and this sea has a bed (water.seabed)");
        }
        const std::size_t bands = detail_bands(parameters, settings).size();
        const auto band = band_of(*product);
        if (bands == 0 || band.value_or(0) >= bands) {
            refuse("--products " + std::string(product->name) + ": beside a map of " +
                   std::to_string(settings.resolution) + " samples this sea has " +
                   (bands == 0 ? "no waves left down to 12 mm" : std::to_string(bands) + " bands"));
        }
        const std::size_t first = band.value_or(0);
        const std::size_t last = band ? first : bands - 1;
        for (std::size_t i = first; i <= last; ++i) {
            const Product* const one = &kDetailProducts[i + 1];
            if (std::ranges::find(all, one) != all.end()) {
                refuse("--products: " + std::string(one->name) + " is repeated");
            }
            all.push_back(one);
        }
    }
    return all;
}

MadePlan<TileSettings> resolve(const BakePlan& draft, const TileSettings& requested,
                               const std::vector<const Product*>& products) {
    const DetailSettings detail = {draft.resolution, requested.samples.value_or(kDefaultSamples)};
    const Parameters& parameters = sea_of(*draft.subject).parameters;
    const bool has_tiles = std::ranges::any_of(
        products, [](const Product* product) { return kSlopeTiles.has(*product); });
    if (has_tiles && !parameters.water.bed && !draft.domain().wraps) {
        throw Error(ErrorKind::unsupported,
                    "--products detail: slope tiles repeat, and this region of a sea with hulls "
                    "does not");
    }
    return {with_bands(products, parameters, detail),
            {},
            {requested.samples, detail, std::make_shared<DetailBudgets>()}};
}

int tile_samples(const TileSettings& settings) {
    return settings.detail.samples;
}

std::vector<io::HeaderString> strings(const BakePlan& plan, const TileSettings& settings, int frame,
                                      const Product& product) {
    const DetailBudget budget = settings.budgets->of(plan, frame, settings.detail);
    const DetailBand& band = budget.bands[band_of(product).value()];
    return slope_tile_strings(band, budget.residual, plan.resolution);
}

/// Returns the bytes of two slopes for each band, and of one band again for its file.
std::uint64_t frame_bytes(const BakePlan& plan, const TileSettings& settings) {
    return detail_bytes(sea_of(*plan.subject).parameters, settings.detail, plan.backend) +
           maps_bytes(settings.detail.samples, 2 * kMaxDetailBands + 2);
}

/// Returns a band as a surface over its tile, with its slopes.
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

MadeFrame make(const FrameWork& work, const TileSettings& settings) {
    return [detail = ocean_of(work.source).detail(work.time(), settings.detail)](
               const Product& product) {
        return MadeSamples{.tile = band_surface(detail, band_of(product).value())};
    };
}

void adopt(const BakedHeader& header, BakeOptions& options) {
    const int samples = header.layout().samples[0];
    if (samples != kDefaultSamples) options.set_default("detail-samples", std::to_string(samples));
}

constexpr MadeProductOf<TileSettings> kOf = {
    .products = kDetailProducts,
    .tiles = "slope tiles",
    .options = list_options,
    .read = read,
    .resolve = resolve,
    .tile_samples = tile_samples,
    .strings = strings,
    .frame_bytes = frame_bytes,
    .make = make,
    .adopt = adopt,
};

}  // namespace

const MadeProduct kSlopeTiles = made_product<kOf>();

}  // namespace ocean
