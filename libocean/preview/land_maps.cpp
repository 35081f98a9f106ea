// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/preview/land_maps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "ocean/gl/textures.hpp"

namespace ocean::preview {
namespace {

constexpr int kMaxMap = 4096;
constexpr int kMaxQuickMap = 1024;
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
    double lowest = 0.0, highest = 0.0;
};

/// Sets the square of the slope of each texel and returns the statistics.
Summary complete(std::vector<float>& texels) {
    float lowest = texels[0], highest = texels[0];
    double sum = 0.0;
    for (std::size_t i = 0; i < texels.size(); i += kComponents) {
        float* const t = &texels[i];
        t[3] = t[1] * t[1] + t[2] * t[2];
        sum += static_cast<double>(t[3]);
        lowest = std::min(lowest, t[0]);
        highest = std::max(highest, t[0]);
    }
    return {sum / static_cast<double>(texels.size() / kComponents), static_cast<double>(lowest),
            static_cast<double>(highest)};
}

}  // namespace

double LandImage::height_at(double x, double y) const {
    const double texel = period / resolution;
    const double u = x / texel, v = y / texel;
    const double column = std::floor(u), row = std::floor(v);
    const Hermite along(u - column), across(v - row);
    const auto wrapped = [&](double at) {
        const double n = resolution;
        return static_cast<std::size_t>(at - n * std::floor(at / n));
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

double texel_of(const ShownLand& land) {
    return land.image->period / land.image->resolution;
}

double colour_scale(const ShownLand& land) {
    return land.rms > 0.0 ? land.rms : 1.0;
}

double default_snow_line(const ShownLand& land) {
    constexpr double kRise = 1.3;
    return land.mean + kRise * colour_scale(land);
}

int land_map_resolution(const Terrain& terrain, bool quick) {
    return quick ? std::min(terrain.resolution, kMaxQuickMap)
                 : std::min(2 * terrain.resolution, kMaxMap);
}

struct LandMaps::Impl {
    gl::Texture texture;
    std::shared_ptr<LandImage> image;
    ShownLand shown;
    Revision revision;
    double offset = 0.0;

    void make(Land& land, int resolution) {
        // A caller may still read the image before.
        if (!image || image.use_count() > 2) image = std::make_shared<LandImage>();
        const bool fits = texture && image->resolution == resolution;
        image->resolution = resolution;
        image->period = land.terrain().patch_size;
        image->texels.resize(kComponents * Lattice{resolution, 1.0}.size());
        MapOutput output{image->texels.data(), kComponents, {}};
        output.component = {{{Channel::height}, {Channel::slope_x}, {Channel::slope_y}, {}}};
        land.surface_into({&output, 1}, resolution);
        const Summary summary = complete(image->texels);
        if (!fits) texture = gl::make_texture(GL_RGBA32F, resolution, gl::Mipmaps::yes);
        upload();
        shown = {.texture = texture.name(),
                 .image = image,
                 .mean = land.offset(),
                 .rms = land.scale().rms,
                 .rms_slope = std::sqrt(summary.mean_square_slope),
                 .cell = image->period / land.terrain().resolution,
                 .heights = {summary.lowest, summary.highest}};
    }

    void upload() const {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, texture.name());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image->resolution, image->resolution, GL_RGBA,
                        GL_FLOAT, image->texels.data());
        glGenerateMipmap(GL_TEXTURE_2D);
    }
};

LandMaps::LandMaps() : impl_(std::make_unique<Impl>()) {}
LandMaps::~LandMaps() = default;

ShownLand LandMaps::show(Land& land, int resolution) {
    const Revision revision = land.modes().revision;
    const bool known = impl_->image && revision == impl_->revision &&
                       land.offset() == impl_->offset && resolution == impl_->image->resolution;
    if (!known) {
        impl_->make(land, resolution);
        impl_->revision = revision;
        impl_->offset = land.offset();
    }
    return impl_->shown;
}

}  // namespace ocean::preview
