// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/preview/coast_maps.hpp"

#include <algorithm>
#include <cmath>

#include "bed_ground.hpp"
#include "coast_windows.hpp"
#include "ocean/internal/gl/textures.hpp"

namespace ocean::preview {
namespace {

constexpr int kMaxGround = 2048;

/// A texture of an image of the windows, a layer for each.
struct Layers {
    std::vector<float> CoastImage::*image;
    gl::Mipmaps mipmaps;
    gl::Texture texture = {};

    void upload(const std::vector<CoastImage>& windows, bool anew) {
        const int side = windows.front().window.samples;
        if (anew) {
            texture =
                gl::make_texture_array(GL_RGBA32F, side, static_cast<int>(windows.size()), mipmaps);
        }
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture.name());
        GLint layer = 0;
        for (const CoastImage& window : windows) {
            glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer++, side, side, 1, GL_RGBA, GL_FLOAT,
                            (window.*image).data());
        }
        if (mipmaps == gl::Mipmaps::yes) glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    }
};

/// Returns the greatest distance of the surface from still water, where there is water [m].
double highest_of(const std::vector<CoastImage>& windows) {
    float highest = 0.0f;
    for (const CoastImage& window : windows) {
        for (std::size_t n = 0; n < window.shape.size(); n += kWindowComponents) {
            if (window.shape[n + 3] <= 0.0f) continue;
            highest = std::max(highest, std::abs(window.shape[n + 2]));
        }
    }
    return static_cast<double>(highest);
}

}  // namespace

double DrawnCoast::ground_at(double x, double y) const {
    return bed_height(*bed, x, y);
}

double DrawnCoast::surface_at(double x, double y) const {
    const double height = read_windows(windows, &CoastImage::shape, 2, x, y).value_or(0.0);
    return bed ? std::max(ground_at(x, y), height) : height;
}

class CoastMaps::Impl {
  public:
    explicit Impl(const CoastMapsOptions& options) : surface_(options) {}

    std::shared_ptr<const DrawnCoast> show(Ocean& sea, double time,
                                           const std::array<double, 3>& eye, double cover_power) {
        DrawnCoast& shown = next();
        show_bed(shown, sea.parameters().water.bed);
        shown.windows = surface_.at(sea, time, eye, cover_power);
        shown.area = surface_.area();
        upload(shown);
        return shown_;
    }

    std::shared_ptr<const DrawnCoast> show_ground(const std::shared_ptr<const SeaBed>& bed) {
        DrawnCoast& shown = next();
        show_bed(shown, bed);
        shown.area = bed->domain;
        shown.windows.clear();
        return shown_;
    }

    std::shared_ptr<const DrawnCoast> fade_from(const DrawnCoast& before, double share) {
        DrawnCoast& shown = *shown_;
        const auto part = static_cast<float>(share);
        for (std::size_t w = 0; w < std::min(shown.windows.size(), before.windows.size()); ++w) {
            CoastImage& to = shown.windows[w];
            const CoastImage& from = before.windows[w];
            if (!(to.window == from.window)) continue;
            for (const Layers& layers : layers_) {
                std::ranges::transform(from.*layers.image, to.*layers.image,
                                       (to.*layers.image).begin(),
                                       [&](float a, float b) { return a + part * (b - a); });
            }
        }
        if (!shown.windows.empty()) upload(shown);
        return shown_;
    }

  private:
    /// Returns the coast to write: a caller may still read the one before.
    DrawnCoast& next() {
        if (!shown_) {
            shown_ = std::make_shared<DrawnCoast>();
        } else if (shown_.use_count() > 1) {
            auto copy = std::make_shared<DrawnCoast>();
            copy->ground = shown_->ground;
            copy->bed = shown_->bed;
            shown_ = std::move(copy);
        }
        return *shown_;
    }

    void show_bed(DrawnCoast& shown, const std::shared_ptr<const SeaBed>& bed) {
        if (shown.bed == bed) return;
        shown.bed = bed;
        if (!bed) return;
        shown.ground = bed_land(*bed, bed_image(*bed, kMaxGround));
        const LandImage& image = *shown.ground.image;
        glActiveTexture(GL_TEXTURE0);
        ground_ = gl::make_texture(GL_RGBA32F, image.resolution, gl::Mipmaps::yes);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.resolution, image.resolution, GL_RGBA,
                        GL_FLOAT, image.texels.data());
        glGenerateMipmap(GL_TEXTURE_2D);
        masks_ = gl::make_texture(GL_RGBA8, image.resolution, gl::Mipmaps::yes);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.resolution, image.resolution, GL_RGBA,
                        GL_UNSIGNED_BYTE, bed_masks(image).data());
        glGenerateMipmap(GL_TEXTURE_2D);
        shown.ground.texture = ground_.name();
        shown.ground.masks = masks_.name();
    }

    void upload(DrawnCoast& shown) {
        glActiveTexture(GL_TEXTURE0);
        const std::array<std::size_t, 2> size = {
            shown.windows.size(), static_cast<std::size_t>(shown.windows.front().window.samples)};
        const bool anew = size != size_;
        size_ = size;
        for (Layers& layers : layers_) layers.upload(shown.windows, anew);
        shown.shape = layers_[0].texture.name();
        shown.gradients = layers_[1].texture.name();
        shown.moments = layers_[2].texture.name();
        shown.traces = layers_[3].texture.name();
        shown.highest = highest_of(shown.windows);
    }

    CoastSurface surface_;
    std::shared_ptr<DrawnCoast> shown_;
    gl::Texture ground_, masks_;
    std::array<std::size_t, 2> size_{};  // windows and samples of the textures
    std::array<Layers, 4> layers_ = {{{&CoastImage::shape, gl::Mipmaps::no},
                                      {&CoastImage::gradients, gl::Mipmaps::yes},
                                      {&CoastImage::moments, gl::Mipmaps::yes},
                                      {&CoastImage::traces, gl::Mipmaps::yes}}};
};

CoastMaps::CoastMaps(const CoastMapsOptions& options) : impl_(std::make_unique<Impl>(options)) {}
CoastMaps::~CoastMaps() = default;

std::shared_ptr<const DrawnCoast> CoastMaps::show(Ocean& sea, double time,
                                                  const std::array<double, 3>& eye,
                                                  double cover_power) {
    return impl_->show(sea, time, eye, cover_power);
}

std::shared_ptr<const DrawnCoast> CoastMaps::show_ground(const std::shared_ptr<const SeaBed>& bed) {
    return impl_->show_ground(bed);
}

std::shared_ptr<const DrawnCoast> CoastMaps::fade_from(const DrawnCoast& before, double share) {
    return impl_->fade_from(before, share);
}

}  // namespace ocean::preview
