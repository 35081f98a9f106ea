// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/preview/sea_maps.hpp"

#include <algorithm>
#include <cmath>

#include "cover_map.hpp"
#include "detail_tiles.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/open_sea.hpp"
#include "ocean/ocean.hpp"
#include "uploaded_maps.hpp"

namespace ocean::preview {

class SeaMaps::Impl {
  public:
    Impl(const SeaMapsOptions& options, gl::AfterStage after_stage)
        : options_(options),
          after_stage_(std::move(after_stage)),
          uploaded_(options.cascade_resolution, options.foam_resolution, after_stage_),
          coast_(options.coast) {
        if (options.compute) {
            computed_.emplace(
                gl::SeaTextureOptions{.cascade_resolution = options.cascade_resolution,
                                      .foam_resolution = options.foam_resolution,
                                      .foam_start = options.foam_start,
                                      .after_stage = after_stage_});
        }
    }

    DrawnSea show(Ocean& of, double time, const std::optional<std::array<double, 3>>& eye) {
        OpenSea& sea = of.open_sea();
        const FoamOfMaps foam = computed_ ? compute(sea, time) : upload(sea, time);
        shown_.foam_threshold = foam.threshold;
        shown_.foam_width = foam.width;
        const double power = power_of(sea, time, foam_of_lattice(foam.lattice));
        cover_.make(foam.texture, foam.lattice.resolution, foam.fade, power);
        done("cover");
        describe(sea, time);
        shown_.tiles.clear();
        if (options_.detail) {
            shown_.tiles = detail_.make(sea, time, shown_.cascades);
            done("detail");
        }
        shown_.coast = nullptr;
        const auto& bed = of.parameters().water.bed;
        if (eye && !repeats(of.parameters())) {
            shown_.coast = coast_.show(of, time, *eye, power);
            done("coast");
        } else if (bed) {
            shown_.coast = coast_.show_ground(bed);
            done("coast");
        }
        return shown_;
    }

    DrawnSea fade_from(const DrawnSea& before, double share) {
        if (shown_.coast && before.coast) shown_.coast = coast_.fade_from(*before.coast, share);
        return shown_;
    }

    void set_detail(bool on) { options_.detail = on; }
    // The sea itself follows the foam of its own backend, and knows its changes.
    void foam_changed(double from) {
        if (computed_) computed_->foam_changed(from);
    }
    void foam_changed() {
        if (computed_) computed_->foam_changed();
    }
    Pending pending() const { return cover_power_.pending(); }
    std::int64_t foam_settling_ticks(const Ocean& sea) const {
        return computed_ ? computed_->foam_settling_ticks() : sea.foam_settling_ticks();
    }

  private:
    FoamOfMaps compute(OpenSea& sea, double time) {
        computed_->show(sea, time);
        show_cascades(sea.modes(time), computed_->arrays(), sea.parameters().grid.patch_size);
        const gl::FoamTexture& foam = computed_->foam();
        return {foam.texture, foam.lattice, foam.fade, static_cast<double>(foam.threshold),
                static_cast<double>(foam.width)};
    }

    FoamOfMaps upload(OpenSea& sea, double time) {
        uploaded_.show(sea, time);
        show_cascades(sea.modes(time), uploaded_.arrays(), sea.parameters().grid.patch_size);
        return uploaded_.foam();
    }

    void show_cascades(const Modes& modes, const gl::CascadeArrays& maps, double sea_period) {
        shown_.cascades.clear();
        for (const CascadeModes& cascade : modes.cascades) {
            const auto number = static_cast<int>(shown_.cascades.size());
            shown_.cascades.push_back(
                {maps, number, cascade.lattice.period, 1.0, sea_period, number});
        }
    }

    /// Returns the power of the foam that is its cover.
    double power_of(OpenSea& sea, double time, const ShownFoam& foam) {
        return options_.live ? cover_power_.of(sea, time, foam) : sea.cover_power(time, foam);
    }

    void done(std::string_view stage) const {
        if (after_stage_) after_stage_(stage);
    }

    void describe(OpenSea& sea, double time) {
        shown_.time = time;
        shown_.period = sea.parameters().grid.patch_size;
        const CoverPattern& pattern = patterns_.of(sea.parameters(), sea.pool());
        shown_.covers = {{.texture = cover_.texture(),
                          .resolution = cover_.resolution(),
                          .period = shown_.period,
                          .direction = pattern.direction,
                          .stretch = pattern.stretch,
                          .streaks = pattern.streaks}};
        // The threshold of water that is never squeezed is the lowest number; see
        // whitecap_threshold.
        shown_.has_foam = shown_.has_foam || shown_.foam_threshold > -1e30;
        shown_.choppiness = sea.sea().at(time).surface.choppiness;
        const Revision revision = sea.modes(time).revision;
        if (revision == described_) return;
        const Parameters& parameters = sea.parameters();
        const SurfaceSettings& surface = parameters.surface;
        const SpectralMoments moments = sea.spectrum(time).moments(
            parameters.water, surface.shortest_wavelength, surface.longest_wavelength);
        shown_.significant_wave_height = moments.significant_wave_height();
        shown_.peak_period = moments.peak_omega > 0.0 ? kTwoPi / moments.peak_omega : 0.0;
        shown_.mean_square_slope = moments.mean_square_slope;
        described_ = revision;
    }

    SeaMapsOptions options_;
    gl::AfterStage after_stage_;
    std::optional<gl::SeaTextures> computed_;  // by shaders
    UploadedMaps uploaded_;                    // else
    CoverPower cover_power_;                   // for live maps
    CoverMap cover_;
    CoverPatterns patterns_;
    DetailTiles detail_;
    CoastMaps coast_;  // of a sea that does not repeat
    DrawnSea shown_;
    Revision described_;  // revision of the described modes
};

double finest_texel(const DrawnSea& sea) {
    double finest = sea.period;
    if (sea.coast && !sea.coast->windows.empty()) finest = sea.coast->windows[0].window.cell;
    for (const DrawnCascade& cascade : sea.cascades) {
        finest = std::min(finest, cascade.period / cascade.maps.resolution);
    }
    return finest;
}

DrawnSea cross_fade(const DrawnSea& from, const DrawnSea& to, double share, double correlation) {
    const double angle = 0.25 * kTwoPi * std::clamp(share, 0.0, 1.0);
    const double a = std::cos(angle), b = std::sin(angle);
    const auto mean_square = [&](double x, double y) {
        return std::sqrt(a * a * x * x + b * b * y * y);
    };
    // Waves that both have add up by their heights, not by their energies.
    const double height = mean_square(from.significant_wave_height, to.significant_wave_height);
    const double shared = 2.0 * a * b * std::max(correlation, -0.9) * from.significant_wave_height *
                          to.significant_wave_height;
    const double sum = std::sqrt(height * height + shared);
    const double scale = sum > 0.0 ? height / sum : 1.0;
    DrawnSea both = to;
    for (DrawnCascade& cascade : both.cascades) cascade.weight *= b * scale;
    for (DrawnTile& tile : both.tiles) tile.weight *= b * scale;
    for (DrawnCover& cover : both.covers) cover.share *= b * b;
    for (DrawnCascade cascade : from.cascades) {
        cascade.weight *= a * scale;
        both.cascades.push_back(cascade);
    }
    for (DrawnTile tile : from.tiles) {
        tile.weight *= a * scale;
        both.tiles.push_back(tile);
    }
    for (DrawnCover cover : from.covers) {
        cover.share *= a * a;
        both.covers.push_back(cover);
    }
    both.has_foam = from.has_foam || to.has_foam;
    both.choppiness = mean_square(from.choppiness, to.choppiness);
    both.significant_wave_height = height;
    both.mean_square_slope = a * a * from.mean_square_slope + b * b * to.mean_square_slope;
    return both;
}

SeaMaps::SeaMaps(const SeaMapsOptions& options, gl::AfterStage after_stage)
    : impl_(std::make_unique<Impl>(options, std::move(after_stage))) {}
SeaMaps::~SeaMaps() = default;

DrawnSea SeaMaps::show(Ocean& sea, double time, const std::optional<std::array<double, 3>>& eye) {
    return impl_->show(sea, time, eye);
}

DrawnSea SeaMaps::fade_from(const DrawnSea& before, double share) {
    return impl_->fade_from(before, share);
}

void SeaMaps::set_detail(bool on) {
    impl_->set_detail(on);
}

void SeaMaps::foam_changed(double from) {
    impl_->foam_changed(from);
}

void SeaMaps::foam_changed() {
    impl_->foam_changed();
}

Pending SeaMaps::pending() const {
    return impl_->pending();
}

std::int64_t SeaMaps::foam_settling_ticks(const Ocean& sea) const {
    return impl_->foam_settling_ticks(sea);
}

}  // namespace ocean::preview
