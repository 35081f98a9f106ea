// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "detail_tiles.hpp"

#include <algorithm>

#include "ocean/detail.hpp"
#include "ocean/internal/gl/textures.hpp"

namespace ocean::preview {
namespace {

constexpr DetailSettings kSettings{.resolution = 0, .samples = 512};
constexpr std::size_t kTileSide = 512;

/// Returns the means of the squares and of the product.
SlopeVariance variance_of(const std::vector<float>& slopes) {
    SlopeVariance sum;
    for (std::size_t row = 0; row < kTileSide; ++row) {
        float x[4] = {}, y[4] = {}, xy[4] = {};
        const float* s = &slopes[2 * kTileSide * row];
        for (std::size_t i = 0; i < kTileSide; i += 4) {
            for (std::size_t k = 0; k < 4; ++k) {
                const float a = s[2 * (i + k)], b = s[2 * (i + k) + 1];
                x[k] += a * a;
                y[k] += b * b;
                xy[k] += a * b;
            }
        }
        sum.x += static_cast<double>(x[0] + x[1] + x[2] + x[3]);
        sum.y += static_cast<double>(y[0] + y[1] + y[2] + y[3]);
        sum.xy += static_cast<double>(xy[0] + xy[1] + xy[2] + xy[3]);
    }
    constexpr double kCount = kTileSide * kTileSide;
    return {sum.x / kCount, sum.y / kCount, sum.xy / kCount};
}

/// A level of the mipmaps of a tile: slopes as in DrawnTile.
struct Level {
    std::size_t side;
    std::vector<float> slopes;

    const float* at(std::size_t x, std::size_t y) const {
        return &slopes[2 * ((y % side) * side + x % side)];
    }
};

Level halved(const Level& fine) {
    Level coarse{fine.side / 2, {}};
    for (std::size_t y = 0; y < fine.side; y += 2) {
        for (std::size_t x = 0; x < fine.side; x += 2) {
            for (const std::size_t c : {0, 1}) {
                coarse.slopes.push_back(0.25f * (fine.at(x, y)[c] + fine.at(x + 1, y)[c] +
                                                 fine.at(x, y + 1)[c] + fine.at(x + 1, y + 1)[c]));
            }
        }
    }
    return coarse;
}

/// Returns the mean square slope of bilinear reads, which are means between texels: a sum of the
/// covariances at lags of 0 and 1 texels, with weights 2/3 and 1/6 along each axis.
double read_variance(const Level& level) {
    double still = 0.0, beside = 0.0, across = 0.0;
    const auto product = [](const float* a, const float* b) {
        return static_cast<double>(a[0] * b[0] + a[1] * b[1]);
    };
    for (std::size_t y = 0; y < level.side; ++y) {
        for (std::size_t x = 0; x < level.side; ++x) {
            const float *here = level.at(x, y), *right = level.at(x + 1, y);
            const float *up = level.at(x, y + 1), *corner = level.at(x + 1, y + 1);
            still += product(here, here);
            beside += product(here, right) + product(here, up);
            across += product(here, corner) + product(right, up);
        }
    }
    return (4.0 * still + 2.0 * beside + 0.5 * across) /
           (9.0 * static_cast<double>(level.side * level.side));
}

/// Returns the shares of the tile's variance that reads of its mipmaps have.
std::array<double, kTileLevels> read_shares(const std::vector<float>& slopes) {
    std::array<double, kTileLevels> shares{};
    const SlopeVariance whole = variance_of(slopes);
    Level level{kTileSide, slopes};
    for (double& share : shares) {
        share = whole.mean_square_slope() > 0.0 ? read_variance(level) / whole.mean_square_slope()
                                                : 1.0;
        level = halved(level);
    }
    return shares;
}

}  // namespace

void DetailTiles::set_sea(OpenSea& sea, const DrawnCascade& finest) {
    const Grid grid{finest.maps.resolution, finest.period, 1, {}};
    const bool same_grid = sea_ && sea_->parameters().grid == grid;
    if (same_grid && revision_ == sea.revision()) return;
    Sea of = sea.sea();
    of.parameters.grid = grid;
    if (sea_) {
        sea_->change(std::move(of));
    } else {
        sea_ = std::make_unique<OpenSea>(std::move(of), OceanOptions{.threads = sea.pool().size()});
    }
    revision_ = sea.revision();
    if (same_grid) return;
    const std::size_t bands = detail_bands(sea_->parameters(), kSettings).size();
    maps_ = {};
    if (bands > 0) {
        maps_ =
            gl::make_texture_array(GL_RG32F, kTileSide, static_cast<int>(bands), gl::Mipmaps::yes);
        // A read between two levels would have the variance of neither.
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    }
    images_.assign(bands, std::vector<float>(2 * kTileSide * kTileSide));
    read_.clear();
}

const std::vector<DrawnTile>& DetailTiles::make(OpenSea& sea, double time,
                                                const std::vector<DrawnCascade>& cascades) {
    const DrawnCascade& finest = *std::ranges::min_element(
        cascades, {}, [](const DrawnCascade& c) { return c.period / c.maps.resolution; });
    set_sea(sea, finest);
    std::vector<MapOutput> outputs;
    for (std::vector<float>& image : images_) {
        outputs.push_back({image.data(), 2, {{{Channel::slope_x}, {Channel::slope_y}}}});
    }
    if (read_.empty()) {  // at a fixed time, so that the shares do not depend on the first picture
        sea_->detail_into(sea_->parameters().time.start, outputs, kSettings);
        for (const std::vector<float>& image : images_) read_.push_back(read_shares(image));
    }
    sea_->detail_into(time, outputs, kSettings);
    const DetailBudget budget = sea_->detail_budget(time, kSettings);
    tiles_.clear();
    for (std::size_t i = 0; i < images_.size(); ++i) {
        const auto layer = static_cast<int>(i);
        glBindTexture(GL_TEXTURE_2D_ARRAY, maps_.name());
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, kTileSide, kTileSide, 1, GL_RG,
                        GL_FLOAT, images_[i].data());
        const DetailBand& band = budget.bands[i];
        tiles_.push_back({maps_.name(), layer, static_cast<int>(kTileSide), band.tile,
                          band.shortest_wave, band.longest_wave, variance_of(images_[i]),
                          read_[i]});
    }
    if (!tiles_.empty()) glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    return tiles_;
}

}  // namespace ocean::preview
