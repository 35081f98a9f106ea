// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The separate waves of one place, which ShoreSurface::read adds up.
#include <cmath>

#include "coast/statics/shore_blend.hpp"
#include "coast/surface/shore_block.hpp"
#include "coast/surface/shore_surface.hpp"

namespace ocean {

LocalSea ShoreSurface::local_sea(WorldPoint place, std::vector<LocalWave>& waves,
                                 const ShoreSums* exact) const {
    waves.clear();
    LocalSea local;
    const Jet share = statics_.share_of_coast(place.x, place.y);
    if (share.value() <= 0.0f) return local;
    const ShoreEnergy& energy = *statics_.energy;
    const QuadSample ground = statics_.delays->ground.read(place.x, place.y);
    const QuadSample remainder = energy.remainder.read(place.x, place.y);
    const auto border = border_weights(share, held_in_unit(Jet(remainder.value[1])));
    local.is_over_bed = true;
    local.bed = static_cast<double>(ground.value[0]);
    local.coast = static_cast<double>(border.coast.value());
    local.open = static_cast<double>(border.open.value());
    const float uninfluenced = (1.0f - held_in_unit(Plain(ground.value[3])).value()) *
                               (1.0f - held_in_unit(Plain(remainder.value[2])).value());
    const float lee = energy.lee.at(place.x, place.y).height.value();
    local.bed_influence =
        static_cast<double>(bed_influence_in_lee(Plain(1.0f - uninfluenced), Plain(lee)).value());
    if (local.bed_influence <= 0.0) {
        // Both surfaces are the open sea.
        local.coast = 1.0;
        local.open = 0.0;
        return local;
    }
    const float depth = ground.value[1];
    local.depth = static_cast<double>(depth);
    local.short_wave_gain =
        static_cast<double>(short_waves_left(Jet(depth)).value() * lee * remainder.value[0]);
    const Quad wavenumbers = energy.depths.band_wavenumbers(depth);
    BlockSignal signal;
    Jet real(0.0f);
    Jet imaginary(0.0f);
    for (std::size_t w = 0; w < statics_.bands().waves.size(); ++w) {
        const ShoreWaves& of = statics_.bands().waves[w];
        const QuadSample delay = statics_.delays->waves[w].maps->read(place.x, place.y);
        const double x = place.x + static_cast<double>(delay.value[0]);
        const double y = place.y + static_cast<double>(delay.value[1]);
        read_signal(w, 1, &x, &y, JetParts::all, exact, signal);
        const float amplitude =
            lee * energy.amplitudes[w / 4].read(place.x, place.y).value[static_cast<int>(w % 4)];
        const Jet cosine(amplitude * std::cos(delay.value[2]));
        const Jet sine(amplitude * std::sin(delay.value[2]));
        const Jet re(signal.re.part[0][0], 0.0f, 0.0f, signal.re.part[3][0]);
        const Jet im(signal.im.part[0][0], 0.0f, 0.0f, signal.im.part[3][0]);
        waves.push_back({re * cosine - im * sine, re * sine + im * cosine,
                         static_cast<double>(wavenumbers[of.band]),
                         sector_centre(of.sector) + static_cast<double>(delay.value[3])});
        real += waves.back().real;
        imaginary += waves.back().imaginary;
    }
    const QuadSample broken = energy.breaking.read(place.x, place.y);
    const Jet k = energy.depths.at(Jet(depth)).wavenumber;
    const Jet highest = highest_wave(k, Jet(depth), breaker_index(Jet(ground.value[2])));
    const Jet rms_height(lee * broken.value[0]);
    const Jet gain =
        limiter_gain_(rms_height / highest, typical_shape_root(rms_height, k, Jet(depth)));
    local.limited = static_cast<double>(
        broken_wave(real, imaginary, highest, gain, k, Jet(depth)).share.value());
    return local;
}

}  // namespace ocean
