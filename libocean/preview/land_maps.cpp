// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/preview/land_maps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "ocean/internal/gl/textures.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/land_quadtree.hpp"
#include "ocean/internal/terrain_modes.hpp"
#include "ocean/land_mask.hpp"

namespace ocean::preview {
namespace {

constexpr int kMaxMap = 4096;
constexpr int kMaxShapedMap = 2048;
constexpr int kMaxQuickMap = 1024;
/// The texel of a land without masks.
constexpr std::array<std::uint8_t, 4> kNoMasks = {128, 0, 0, 128};
constexpr std::size_t kComponents = 4;

/// Weights of the heights and slopes at both ends of a cubic Hermite segment, at 0 <= t < 1.
struct Hermite {
    std::array<double, 2> height, slope;

    explicit Hermite(double t) {
        const double s = 1.0 - t;
        height = {s * s * (1.0 + 2.0 * t), t * t * (1.0 + 2.0 * s)};
        slope = {t * s * s, -s * t * t};
    }
};

/// Statistics of a map.
struct Summary {
    double mean_square_slope = 0.0;
    double mean = 0.0, rms = 0.0;  // of the samples above a level
    double lowest = 0.0, highest = 0.0;
};

/// Sets the square of the slope of each texel and returns the statistics; mean and rms are those of
/// the samples above `level`.
Summary complete(std::vector<float>& texels, double level) {
    float lowest = texels[0], highest = texels[0];
    double slopes = 0.0, sum = 0.0, squares = 0.0, count = 0.0;
    const auto first = static_cast<double>(texels[0]);
    for (std::size_t i = 0; i < texels.size(); i += kComponents) {
        float* const t = &texels[i];
        t[3] = t[1] * t[1] + t[2] * t[2];
        slopes += static_cast<double>(t[3]);
        lowest = std::min(lowest, t[0]);
        highest = std::max(highest, t[0]);
        if (static_cast<double>(t[0]) <= level) continue;
        const double height = static_cast<double>(t[0]) - first;
        sum += height;
        squares += height * height;
        count += 1.0;
    }
    Summary summary;
    summary.mean_square_slope = slopes / static_cast<double>(texels.size() / kComponents);
    summary.lowest = static_cast<double>(lowest);
    summary.highest = static_cast<double>(highest);
    summary.mean = first + sum / std::max(count, 1.0);
    const double offset = sum / std::max(count, 1.0);
    summary.rms = std::sqrt(std::max(squares / std::max(count, 1.0) - offset * offset, 0.0));
    return summary;
}

/// Returns the square of a placed land's map, along its longer side: beyond the shorter one it
/// holds the edge.
Domain map_of_placed(const Terrain& land, int resolution) {
    const Domain own = land.domain();
    const double side = std::max(own.size[0], own.size[1]);
    return {own.origin, {side, side}, {resolution, resolution}, false};
}

/// Values of masks beside each other, as DrawnLand::masks holds them.
class MaskTexels {
  public:
    /// Returns the outputs that a function writes the available masks to.
    std::vector<MapOutput> outputs(ChannelSet available, std::size_t samples) {
        using enum LandMask;
        std::vector<MapOutput> made;
        for (const LandMask mask : {beach, cliff, streambed, deposit, wear}) {
            if (!available.contains(channel_of(mask))) continue;
            std::vector<float>& values = values_[static_cast<std::size_t>(mask)];
            values.resize(samples);
            MapOutput output{values.data(), 1, {}};
            output.component[0].quantity = channel_of(mask);
            made.push_back(output);
        }
        return made;
    }

    std::vector<std::uint8_t> packed(std::size_t samples) const {
        using enum LandMask;
        const auto byte = [](float value) {
            return static_cast<std::uint8_t>(std::clamp(255.0f * value + 0.5f, 0.0f, 255.0f));
        };
        std::vector<std::uint8_t> texels(kComponents * samples);
        for (std::size_t i = 0; i < samples; ++i) {
            std::uint8_t* const to = &texels[kComponents * i];
            to[0] = byte(0.5f + 0.5f * (at(beach, i) - at(cliff, i)));
            to[1] = byte(at(streambed, i));
            to[2] = byte(at(deposit, i));
            to[3] = byte(0.5f + 0.5f * at(wear, i));
        }
        return texels;
    }

  private:
    float at(LandMask mask, std::size_t i) const {
        const std::vector<float>& values = values_[static_cast<std::size_t>(mask)];
        return values.empty() ? 0.0f : values[i];
    }

    std::array<std::vector<float>, kMaskCount> values_;
};

}  // namespace

double LandImage::height_at(double x, double y) const {
    const double texel = period / resolution;
    const auto in_texels = [&](double at, double from) {
        const double u = (at - from) / texel;
        return wraps ? u : std::clamp(u, 0.0, resolution - 1.0);
    };
    const double u = in_texels(x, origin[0]), v = in_texels(y, origin[1]);
    const double column = std::floor(u), row = std::floor(v);
    const Hermite along(u - column), across(v - row);
    const auto wrapped = [&](double at) {
        const double n = resolution;
        return static_cast<std::size_t>(wraps ? at - n * std::floor(at / n)
                                              : std::min(at, n - 1.0));
    };
    double sum = 0.0;
    for (std::size_t j = 0; j < 2; ++j) {
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t at =
                wrapped(row + static_cast<double>(j)) * static_cast<std::size_t>(resolution) +
                wrapped(column + static_cast<double>(i));
            const float* const t = &texels[kComponents * at];
            sum += along.height[i] * across.height[j] * static_cast<double>(t[0]) +
                   texel * (along.slope[i] * across.height[j] * static_cast<double>(t[1]) +
                            along.height[i] * across.slope[j] * static_cast<double>(t[2]));
        }
    }
    return sum;
}

double DrawnLand::ground_at(double x, double y) const {
    ThreadPool caller(1);
    const WorldPoint point{x, y};
    QuerySample sample{};
    function->query({&point, 1}, {&sample, 1}, QuadtreeSettings{}.spacing, caller);
    return sample.height;
}

double DrawnLand::surface_at(double x, double y) const {
    const double ground = ground_at(x, y);
    return water_level ? std::max(ground, *water_level) : ground;
}

double texel_of(const DrawnLand& land) {
    return land.image->period / land.image->resolution;
}

double colour_scale(const DrawnLand& land) {
    return land.rms > 0.0 ? land.rms : 1.0;
}

double cover_relief(const DrawnLand& land) {
    if (!land.water_level) return colour_scale(land);
    constexpr double kReliefs = 3.0;  // between the water and the summit
    return std::max((land.heights[1] - *land.water_level) / kReliefs, 1.0);
}

CoverLines cover_lines(const DrawnLand& land, std::optional<double> snow_line) {
    if (land.water_level) {
        constexpr double kNoSnow = 1e6;  // [m]
        return {snow_line.value_or(kNoSnow), 0.5 * (*land.water_level + land.heights[1])};
    }
    constexpr double kSnowRise = 1.3, kTreesBelowSnow = 1.1;
    const double snow = snow_line.value_or(land.mean + kSnowRise * colour_scale(land));
    return {snow, snow - kTreesBelowSnow * colour_scale(land)};
}

int land_map_resolution(const TerrainModel& terrain, bool quick) {
    int own = terrain.resolution;
    if (terrain.base_model != nullptr) {
        const Domain domain = terrain_domain(terrain);
        own = std::max(domain.samples[0], domain.samples[1]);
    }
    if (quick) return std::min(own, kMaxQuickMap);
    return terrain.is_shaped() ? std::min(own, kMaxShapedMap) : std::min(2 * own, kMaxMap);
}

struct LandMaps::Impl {
    gl::Texture texture, masks;
    std::shared_ptr<LandImage> image;
    DrawnLand shown;

    void make(Terrain& land, int resolution) {
        // A caller may still read the image before.
        if (!image || image.use_count() > 2) image = std::make_shared<LandImage>();
        const bool fits = texture && image->resolution == resolution;
        const TerrainModel& terrain = land.model();
        const std::shared_ptr<const LandFunction> function = land.function();
        image->resolution = resolution;
        image->texels.resize(kComponents * Lattice{resolution, 1.0}.size());
        MapOutput output{image->texels.data(), kComponents, {}};
        output.component = {{{Channel::height}, {Channel::slope_x}, {Channel::slope_y}, {}}};
        if (terrain.is_shaped()) {
            make_shaped(land, output);
        } else {
            image->period = terrain.patch_size;
            image->origin = {};
            image->wraps = true;
            land.surface_into({&output, 1}, resolution);
            upload_masks({kNoMasks.begin(), kNoMasks.end()}, 1);
        }
        const std::optional<double> water =
            terrain.has_coast() ? std::optional(terrain.coast_level.value_or(0.0)) : std::nullopt;
        const Summary summary =
            complete(image->texels, water.value_or(-std::numeric_limits<double>::infinity()));
        if (!fits) texture = gl::make_texture(GL_RGBA32F, resolution, gl::Mipmaps::yes);
        upload();
        shown = {.texture = texture.name(),
                 .masks = masks.name(),
                 .has_masks = land.channels().intersects(kEveryMask),
                 .image = image,
                 .function = function,
                 .mean = terrain.is_shaped() ? summary.mean : land.offset(),
                 .rms = terrain.is_shaped() ? summary.rms : land.scale().rms,
                 .rms_slope = std::sqrt(summary.mean_square_slope),
                 .cell = function->cell(),
                 .heights = {summary.lowest, summary.highest},
                 .water_level = water};
    }

    void make_shaped(Terrain& land, const MapOutput& ground) {
        const int resolution = image->resolution;
        const Domain domain =
            land.model().is_placed() ? map_of_placed(land, resolution) : land.domain(resolution);
        image->period = domain.step(0) * resolution;
        image->origin = domain.origin;
        image->wraps = domain.wraps;
        MaskTexels texels;
        std::vector<MapOutput> outputs = texels.outputs(land.channels(), domain.count());
        const bool has_masks = !outputs.empty();
        outputs.push_back(ground);
        land.region_into(domain, outputs);
        if (has_masks) {
            upload_masks(texels.packed(domain.count()), resolution);
        } else {
            upload_masks({kNoMasks.begin(), kNoMasks.end()}, 1);
        }
    }

    void upload() const {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, texture.name());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image->resolution, image->resolution, GL_RGBA,
                        GL_FLOAT, image->texels.data());
        glGenerateMipmap(GL_TEXTURE_2D);
    }

    void upload_masks(const std::vector<std::uint8_t>& texels, int resolution) {
        glActiveTexture(GL_TEXTURE0);
        masks = gl::make_texture(GL_RGBA8, resolution, gl::Mipmaps::yes);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, resolution, resolution, GL_RGBA, GL_UNSIGNED_BYTE,
                        texels.data());
        glGenerateMipmap(GL_TEXTURE_2D);
    }
};

LandMaps::LandMaps() : impl_(std::make_unique<Impl>()) {}
LandMaps::~LandMaps() = default;

DrawnLand LandMaps::show(Terrain& land, int resolution) {
    // The land that is shown keeps its function, so that no other one has the same address.
    const bool known = impl_->shown.function != nullptr &&
                       land.function() == impl_->shown.function &&
                       resolution == impl_->image->resolution;
    if (!known) impl_->make(land, resolution);
    return impl_->shown;
}

}  // namespace ocean::preview
