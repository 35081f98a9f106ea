// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lace and bubbles are nets of cells: a raft of bubbles thins and opens in the middle of its cells,
// and the walls between them, above all their junctions, last longest. A net consists of levels of
// ever smaller cells; the widest level is visible at every cover, the finer ones join as the cover
// grows. Within a level the distances to the nearest and the second nearest point separate walls
// from holes. Their difference alone would give straight walls, as thin at a junction as elsewhere;
// the first distance alone would give separate holes; together they give connected filaments around
// rounded holes. Patches make filaments thick in some regions and thin in others. Streaks are
// patches alone.
//
// Every step replaces values by their rank, so that its weights are shares of the area. The ranks
// are learned once from a coarse lattice; after that a texel is a function of its position, so any
// thread can make a row, and a finer texture is the same foam.
#include "ocean/internal/foam_texture.hpp"

#include <algorithm>
#include <complex>
#include <memory>
#include <span>
#include <string>

#include "base/noise_streams.hpp"
#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/foam/equaliser.hpp"
#include "waves/foam/foam_cells.hpp"
#include "waves/foam/tiled_noise.hpp"

namespace ocean {
namespace {

static_assert(streams_of(NoiseStream::foam_textures) ==
              kStreamsOfFoamTexture * kFoamTextures.size());

/// Samples along each side of the lattice from which ranks are learned.
constexpr int kLearned = 256;
/// Min texels across a cell; a level with smaller cells would be noise and is left out.
constexpr int kTexelsPerCell = 3;
/// Weights of a level's walls and of its holes' middles.
constexpr float kWalls = 0.7f, kHoles = 0.3f;
/// The range of wavenumbers of the noise that bends walls, relative to the cells' wavenumber.
constexpr double kLongestBend = 1.0 / 3.0, kShortestBend = 2.0;
constexpr int kBendFalloff = 6;

struct LevelRecipe {
    int count;     // cells along the tile's side
    float bend;    // of the walls, rms, in cells
    float spread;  // spread of the cells' sizes
    float begins;  // rank of the previous levels where this level joins
};
struct NetRecipe {
    std::array<LevelRecipe, 3> levels;
    NoiseBand patches;
    float patch_weight, grain_weight;  // beside the net's 1; grain: the last level alone
};
constexpr NetRecipe kLaceNet{
    {{{14, 0.22f, 0.45f, 0.0f}, {38, 0.20f, 0.45f, 0.10f}, {100, 0.14f, 0.45f, 0.26f}}},
    {3.0, 80.0, 5},
    0.30f,
    0.10f};
constexpr NetRecipe kBubbleNet{
    {{{32, 0.04f, 0.5f, 0.0f}, {81, 0.03f, 0.4f, 0.1f}, {162, 0.0f, 0.3f, 0.2f}}},
    {3.0, 60.0, 5},
    0.4f,
    0.0f};
constexpr NoiseBand kLongStreaks{7.0, 90.0, 4, 8.0}, kShortStreaks{12.0, 200.0, 3, 3.0};
constexpr float kShortStreakWeight = 0.35f;

/// Numbers of the random draws of a texture's parts: no two parts, and no part and the sea, share
/// draws.
std::uint32_t draws(FoamTextureKind kind, std::uint32_t part) {
    return noise_stream(NoiseStream::foam_textures,
                        kStreamsOfFoamTexture * static_cast<std::uint32_t>(kind) + part);
}

using Row = std::vector<float>;
using NoiseRow = std::vector<std::complex<float>>;

/// A net of cells of one size. Values are 0 on walls and junctions and 1 in the middle of holes.
class Level {
  public:
    Level(std::uint32_t seed, std::uint32_t field, const LevelRecipe& recipe, int size)
        : cells_(seed, field, recipe.count, recipe.spread), bend_(recipe.bend) {
        if (bend_ == 0.0f) return;
        const NoiseBand band{kLongestBend * recipe.count, kShortestBend * recipe.count,
                             kBendFalloff};
        noise_ = std::make_unique<TiledNoise>(seed, field, band, size);
    }

    /// Writes the rows of a texture from `first` on, each of `size` values.
    void rows(int first, int size, std::span<float> values) {
        Row holes(values.size());
        NoiseRow bend(static_cast<std::size_t>(size));
        const float step = static_cast<float>(cells_.count()) / static_cast<float>(size);
        for (std::size_t at = 0; at < values.size(); ++first) {
            const float y = (static_cast<float>(first) + 0.5f) * step;
            if (noise_) noise_->row((first + 0.5) / size, bend);
            for (std::size_t i = 0; i < bend.size(); ++i, ++at) {
                const auto bent = [this](float part) {
                    return std::clamp(bend_ * part, -FoamCells::kReach, FoamCells::kReach);
                };
                const auto d =
                    cells_.at((static_cast<float>(i) + 0.5f) * step + bent(bend[i].real()),
                              y + bent(bend[i].imag()));
                values[at] = d.second - d.first;
                holes[at] = d.first;
            }
        }
        wall_ranks_.equalise(values);
        hole_ranks_.equalise(holes);
        for (std::size_t at = 0; at < values.size(); ++at) {
            values[at] = kWalls * values[at] + kHoles * (1.0f - holes[at]);
        }
        ranks_.equalise(values);
    }

  private:
    FoamCells cells_;
    float bend_;
    std::unique_ptr<TiledNoise> noise_;
    Equaliser wall_ranks_, hole_ranks_, ranks_;
};

class Net {
  public:
    Net(const NetRecipe& recipe, FoamTextureKind kind, std::uint32_t seed, int size,
        ThreadPool& pool)
        : recipe_(recipe) {
        const auto shown = [size](const LevelRecipe& level) {
            return level.count * kTexelsPerCell <= size;
        };
        const auto count = std::max<std::ptrdiff_t>(1, std::ranges::count_if(recipe.levels, shown));
        levels_.resize(static_cast<std::size_t>(count));
        pool.for_each_item(static_cast<int>(count) + 1, [&](int part, int) {
            const auto l = static_cast<std::size_t>(part);
            if (l == levels_.size()) {
                patches_ = std::make_unique<TiledNoise>(seed, draws(kind, 0), recipe.patches, size);
                return;
            }
            levels_[l] = std::make_unique<Level>(
                seed, draws(kind, 1 + static_cast<std::uint32_t>(part)), recipe.levels[l], size);
            // The values whose ranks the equaliser learns.
            Row values(std::size_t{kLearned} * kLearned);
            levels_[l]->rows(0, kLearned, values);
        });
    }

    void rows(int first, int size, std::span<float> values) {
        Row level(values.size());
        for (std::size_t l = 0; l < levels_.size(); ++l) {
            levels_[l]->rows(first, size, level);
            const float begins = recipe_.levels[l].begins;
            for (std::size_t at = 0; at < values.size(); ++at) {
                values[at] = l == 0 ? level[at] : std::min(values[at], begins + level[at]);
            }
        }
        ranks_.equalise(values);
        Row patches(values.size());
        NoiseRow noise(static_cast<std::size_t>(size));
        for (std::size_t at = 0; at < values.size(); ++first) {
            patches_->row((first + 0.5) / size, noise);
            for (std::size_t i = 0; i < noise.size(); ++i, ++at) patches[at] = noise[i].real();
        }
        patch_ranks_.equalise(patches);
        const float grain = levels_.size() == recipe_.levels.size() ? recipe_.grain_weight : 0.0f;
        for (std::size_t at = 0; at < values.size(); ++at) {
            values[at] += recipe_.patch_weight * patches[at] + grain * level[at];
        }
    }

  private:
    const NetRecipe& recipe_;
    std::vector<std::unique_ptr<Level>> levels_;
    std::unique_ptr<TiledNoise> patches_;
    Equaliser ranks_, patch_ranks_;
};

class Streaks {
  public:
    Streaks(std::uint32_t seed, int size)
        : long_(seed, draws(FoamTextureKind::streaks, 0), kLongStreaks, size),
          short_(seed, draws(FoamTextureKind::streaks, 1), kShortStreaks, size) {}

    void rows(int first, int size, std::span<float> values) {
        NoiseRow noise(static_cast<std::size_t>(size)), shorter(noise.size());
        for (std::size_t at = 0; at < values.size(); ++first) {
            const double v = (first + 0.5) / size;
            long_.row(v, noise);
            short_.row(v, shorter);
            for (std::size_t i = 0; i < noise.size(); ++i, ++at) {
                values[at] = noise[i].real() + kShortStreakWeight * shorter[i].real();
            }
        }
    }

  private:
    TiledNoise long_, short_;
};

/// Returns all rows of an almost uniform texture, made of a pattern whose ranks are learned first.
template <typename Pattern>
std::vector<float> draw(Pattern pattern, int size, ThreadPool& pool) {
    Equaliser ranks;
    Row learned(std::size_t{kLearned} * kLearned);
    pattern.rows(0, kLearned, learned);
    ranks.equalise(learned);
    const auto side = static_cast<std::size_t>(size);
    std::vector<float> texture(side * side);
    pool.for_each_item(size, [&](int j, int) {
        const std::span row = std::span(texture).subspan(static_cast<std::size_t>(j) * side, side);
        pattern.rows(j, size, row);
        ranks.equalise(row);
    });
    return texture;
}

std::vector<float> draw(const FoamTextureSettings& settings, ThreadPool& pool) {
    const auto [kind, size, seed] = settings;
    if (kind == FoamTextureKind::streaks) return draw(Streaks(seed, size), size, pool);
    const NetRecipe& recipe = kind == FoamTextureKind::lace ? kLaceNet : kBubbleNet;
    return draw(Net(recipe, kind, seed, size, pool), size, pool);
}

}  // namespace

const FoamTextureInfo& foam_texture_info(FoamTextureKind kind) {
    return kFoamTextures[static_cast<std::size_t>(kind)];
}

FoamTextureKind find_foam_texture(std::string_view name) {
    if (const auto found = enumerator_of<FoamTextureKind>(name)) return *found;
    const std::string_view nearest = nearest_name(name, kEnumWords<FoamTextureKind>);
    throw Error(ErrorKind::invalid_value,
                "unknown foam texture '" + std::string(name.substr(0, 80)) +
                    (nearest.empty() ? "'; allowed: lace, bubbles, streaks"
                                     : "'; did you mean " + std::string(nearest) + "?"),
                {.parameter = "kind",
                 .value = std::string(name.substr(0, 80)),
                 .allowed = "lace, bubbles, streaks"});
}

std::uint64_t foam_texture_bytes(int size) {
    constexpr std::uint64_t kParts = std::uint64_t{16} << 20;  // noise, cells and rows
    const auto side = static_cast<std::uint64_t>(size);
    return side * side * sizeof(float) + kParts;
}

void require_foam_texture_size(int size) {
    if (is_power_of_two(size) && size >= kMinFoamTextureSize && size <= kMaxFoamTextureSize) return;
    const std::string given = std::to_string(size);
    const std::string allowed = "a power of two, " + std::to_string(kMinFoamTextureSize) + " .. " +
                                std::to_string(kMaxFoamTextureSize);
    throw Error(ErrorKind::invalid_value, "foam texture: size = " + given + "; allowed: " + allowed,
                {.parameter = "size", .value = given, .allowed = allowed});
}

std::vector<float> make_foam_texture(const FoamTextureSettings& settings, ThreadPool& pool) {
    const int size = settings.size;
    require_foam_texture_size(size);
    require_memory(foam_texture_bytes(size),
                   "a foam texture of " + std::to_string(size) + " texels a side",
                   "choose a smaller size");
    std::vector<float> texture = draw(settings, pool);
    settle_reads(texture, size, pool);
    return texture;
}

}  // namespace ocean
