// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The steps of a terrain's synthesis as images: white noise, its transform, the filter, and the
// filtered transform (terrain_stages.hpp).
#include <array>
#include <memory>
#include <string>

#include "ocean/bake/plan.hpp"
#include "ocean/bake/typed_format.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/terrain_stages.hpp"
#include "ocean/terrainfile.hpp"
#include "products.hpp"
#include "refuse.hpp"

namespace ocean {
namespace {

constexpr Product stage(TerrainStep step, std::string_view unit, std::string_view help) {
    return {.name = word_of(step),
            .channels = {},
            .count = 0,
            .unit = unit,
            .subject = kTerrainKind,
            .precision = Precision::full,
            .help = help};
}
constexpr std::array kStages = {
    stage(TerrainStep::noise, "", "White noise in space, with the variance 1"),
    stage(TerrainStep::transform, "", "Its Fourier transform: magnitudes, k = 0 in the middle"),
    stage(TerrainStep::filter, "m", "The filter of each wave, the root of its variance"),
    stage(TerrainStep::filtered, "m", "The filtered transform: magnitude of each wave"),
};

NoSettings read(const BakeOptions&) {
    return {};
}

MadePlan<NoSettings> resolve(const BakePlan& draft, const NoSettings&,
                             const std::vector<const Product*>& products) {
    const TerrainModel* terrain = find_terrain(*draft.subject);
    if (terrain == nullptr) {
        throw Error(ErrorKind::unsupported, "only a terrain has the steps of its synthesis");
    }
    const Domain domain = draft.domain();
    if (domain.samples != std::array{terrain->resolution, terrain->resolution}) {
        refuse("the steps of the synthesis have the terrain's own resolution, " +
               std::to_string(terrain->resolution) +
               " samples along each side of one tile: `--set resolution=R` changes it");
    }
    return {products, {Channel::height}, {}};
}

std::uint64_t frame_bytes(const BakePlan& plan, const NoSettings&) {
    constexpr std::uint64_t kBytesPerSample = 52;
    return plan.domain().count() * kBytesPerSample;
}

MadeFrame make(const FrameWork& work, const NoSettings&) {
    auto stages = std::make_shared<const TerrainStages>(terrain_stages(terrain_of(work.source)));
    return [stages = std::move(stages)](const Product& product) {
        for (std::size_t step = 0; step < kStages.size(); ++step) {
            if (kStages[step].name != product.name) continue;
            return MadeSamples{.map = plane_of(*stages, static_cast<TerrainStep>(step))};
        }
        return MadeSamples{};
    };
}

constexpr MadeProductOf<NoSettings> kOf = {
    .products = kStages,
    .read = read,
    .resolve = resolve,
    .frame_bytes = frame_bytes,
    .make = make,
};

}  // namespace

const MadeProduct kTerrainStages = made_product<kOf>();

}  // namespace ocean
