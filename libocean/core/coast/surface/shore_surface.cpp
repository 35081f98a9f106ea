// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See shore_surface.hpp. Labels are read in blocks; shore_waves.cpp adds the waves of a block.
#include "coast/surface/shore_surface.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "base/simd/simd_level.hpp"
#include "coast/statics/shore_blend.hpp"
#include "coast/surface/shore_block.hpp"
#include "ocean/internal/surf_traces.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/query/query_bounds.hpp"

namespace ocean {
namespace {

/// The rms errors of reads. The first is for the maps of the open sea and of the waves in no band,
/// relative to the significant wave height; the second for the signals where waves feel the bed,
/// relative to their rms.
constexpr double kOpenTolerance = 2e-7;
constexpr double kSignalTolerance = 2e-6;

}  // namespace

void ShoreSums::set_time(double to) {
    open.set_time(to);
    remainder.set_time(to);
    time = to;
}

/// The state of up to kShoreBlock labels. Scalar: Jet, or Plain without derivatives.
template <typename Scalar>
struct ShoreSurface::Block {
    JetParts parts;
    const ShoreSums* exact;
    BlockPlaces places;
    std::array<Scalar, kShoreBlock> share;          // share of the coast by the border alone
    std::array<Scalar, kShoreBlock> bed_influence;  // 0: the open sea, exactly
    std::array<Scalar, kShoreBlock> lee;            // factor on waves behind narrow walls
    QuadBlock ground, remainder;
    std::array<LinearWaves<Scalar>, kShoreBlock> open;
    // Labels where the waves feel the bed.
    ShoalingBlock shoaling;
    QuadBlock breaking;
    std::array<Scalar, kShoreBlock> wavenumber;
};

ShoreSurface::ShoreSurface(const Modes& modes, const Parameters& parameters,
                           const ShoreStatics& statics, int shown, Rates rates, ThreadPool& pool)
    : statics_(statics),
      run_up_{statics.energy->open_height,
              kTwoPi * parameters.water.gravity /
                  (statics.energy->peak_omega * statics.energy->peak_omega),
              parameters.water.shore.swash == Swash::on},
      choppiness_(parameters.surface.choppiness),
      shown_(shown),
      remainder_modes_(open_remainder(modes, statics.bands())),
      open_(modes, shown, kOpenTolerance * statics.energy->open_height, pool),
      remainder_(remainder_modes_, shown, kOpenTolerance * statics.energy->open_height, pool),
      signals_(modes, statics.bands(), kSignalTolerance, rates == Rates::with),
      rates_(rates),
      band_sector_loop_(band_sector_loop(simd_level())) {
    // Shallow water lengthens the displacement by coth(k d), and breaking limits its height.
    constexpr double kShallow = 2.0;
    reach_ = kShallow * choppiness_ * query_bounds(modes, shown, 2 * shown, true, pool).farthest;
}

ShoreSums ShoreSurface::sums(const Modes& modes, const Water& water) const {
    return {WaveSum(modes, water, shown_), WaveSum(remainder_modes_, water, shown_)};
}

void ShoreSurface::move_to(double time, Rates rates, ThreadPool& pool, const SignalCells* cells) {
    signals_.move_to(time, pool, rates == Rates::with, cells);
    time_ = time;
    open_.forget();
    remainder_.forget();
}

void ShoreSurface::prepare(const Modes& modes, double first, double last, ThreadPool& pool) {
    prepare(modes, {.open = {first, last}, .remainder = {first, last}}, pool);
}

void ShoreSurface::prepare(const Modes& modes, const Domain& labels, ThreadPool& pool) {
    if (!region_ || *region_ != labels) {
        region_spans_ = find_open_spans(statics_, labels, pool);
        region_ = labels;
    }
    prepare(modes, region_spans_, pool);
}

void ShoreSurface::prepare(const Modes& modes, const OpenSpans& spans, ThreadPool& pool) {
    const bool rates = signals_.has_rates();
    const auto prepare_map = [&](OpenSurface& map, const Modes& of, const SpanAlongX& span) {
        if (span.is_empty()) return;
        map.move_to(of, time_, rates, pool);
        map.prepare(span.first, span.last, pool);
    };
    prepare_map(open_, modes, spans.open);
    prepare_map(remainder_, remainder_modes_, spans.remainder);
}

void ShoreSurface::read(std::span<const WorldPoint> labels, JetParts parts,
                        std::span<ShorePoint> points, const ShoreSums* exact,
                        ReadySums ready) const {
    const auto read_all = [&](auto& block) {
        block.parts = parts;
        block.exact = exact;
        BlockPlaces& places = block.places;
        for (std::size_t first = 0; first < labels.size(); first += kShoreBlock) {
            places.count = std::min(kShoreBlock, labels.size() - first);
            for (std::size_t i = 0; i < places.count; ++i) {
                places.x[i] = labels[first + i].x;
                places.y[i] = labels[first + i].y;
            }
            read_block(block, {ready.sums, ready.labels, ready.first + first},
                       points.subspan(first, places.count));
        }
    };
    if (parts == JetParts::value) {
        Block<Plain> block;
        read_all(block);
    } else {
        Block<Jet> block;
        read_all(block);
    }
}

template <typename Scalar>
void ShoreSurface::read_block(Block<Scalar>& block, const ReadySums& ready,
                              std::span<ShorePoint> points) const {
    find_shoaling(block);
    for (std::size_t i = 0; i < block.places.count; ++i) {
        const bool whole = block.share[i].value() >= 1.0f && block.bed_influence[i].value() >= 1.0f;
        if (whole) {
            block.open[i] = {};
        } else {
            const double x = block.places.x[i], y = block.places.y[i];
            block.open[i] = block.exact != nullptr
                                ? waves_of<Scalar>(block.exact->open.at_label(x, y))
                                : open_.read<Scalar>(x, y);
        }
    }
    if (block.shoaling.places.count > 0) {
        if (ready.sums.empty()) {
            add_waves(block.parts, true, block.exact, block.shoaling);
        } else {
            take_sums(block.parts, ready, block.shoaling);
        }
        lower_in_lee(block);
    }
    finish(block, points);
}

/// Finds the labels that feel the bed, and reads the statics there.
template <typename Scalar>
void ShoreSurface::find_shoaling(Block<Scalar>& block) const {
    const BlockPlaces& places = block.places;
    BlockPlaces& shoaling = block.shoaling.places;
    shoaling.count = 0;
    bool is_inside = false;
    for (std::size_t i = 0; i < places.count; ++i) {
        const Jet share = statics_.share_of_coast(places.x[i], places.y[i]);
        if constexpr (std::is_same_v<Scalar, Jet>) {
            block.share[i] = share;
        } else {
            block.share[i] = share.value();
        }
        block.bed_influence[i] = {0.0f};
        is_inside = is_inside || share.value() > 0.0f;
    }
    if (!is_inside) return;
    const bool slopes = block.parts != JetParts::value;
    const ShoreEnergy& energy = *statics_.energy;
    find_places(block.places);
    statics_.delays->ground.read(places.delays, slopes, block.ground);
    energy.remainder.read(places.energy, slopes, block.remainder);
    for (std::size_t i = 0; i < places.count; ++i) {
        if (block.share[i].value() <= 0.0f) continue;
        block.bed_influence[i] = bed_influence_at<Scalar>(block.ground, block.remainder, i);
        if (!energy.lee.is_empty()) find_lee(block, i);
        if (block.bed_influence[i].value() <= 0.0f) continue;
        const std::size_t n = shoaling.count++;
        shoaling.x[n] = places.x[i];
        shoaling.y[n] = places.y[i];
        block.shoaling.label[n] = i;
        block.shoaling.partly[n] = block.bed_influence[i].value() < 1.0f;
        const auto values = energy.depths.at(field_at<Scalar>(block.ground, 1, i));
        block.wavenumber[n] = values.wavenumber;
        for (std::size_t band = 0; band < kShoreBands; ++band) {
            block.shoaling.displacement[band].set(n, values.displacement[band]);
        }
    }
    if (shoaling.count == 0) return;
    if (shoaling.count == places.count) {
        shoaling = places;
    } else {
        find_places(shoaling);
    }
    energy.breaking.read(shoaling.energy, slopes, block.breaking);
}

/// Reads the factor of the waves behind a narrow wall, where the coast's waves count.
template <typename Scalar>
void ShoreSurface::find_lee(Block<Scalar>& block, std::size_t i) const {
    const Jet height = statics_.energy->lee.at(block.places.x[i], block.places.y[i]).height;
    if constexpr (std::is_same_v<Scalar, Jet>) {
        block.lee[i] = height;
    } else {
        block.lee[i] = height.value();
    }
    block.bed_influence[i] = bed_influence_in_lee(block.bed_influence[i], block.lee[i]);
}

/// Lowers the waves behind narrow walls, and the statistics of these waves.
template <typename Scalar>
void ShoreSurface::lower_in_lee(Block<Scalar>& block) const {
    if (statics_.energy->lee.is_empty()) return;
    ShoalingBlock& shoaling = block.shoaling;
    for (std::size_t n = 0; n < shoaling.places.count; ++n) {
        const std::size_t i = shoaling.label[n];
        const Scalar lee = block.lee[i];
        const auto lower = [](BlockJets& sum, std::size_t at, const Scalar& by) {
            sum.set(at, by * sum.at<Scalar>(at));
        };
        for (BlockJets* const sum : {&shoaling.sums.real, &shoaling.sums.imaginary,
                                     &shoaling.sums.along_x, &shoaling.sums.along_y}) {
            lower(*sum, n, lee);
        }
        lower(shoaling.sums.squares, n, lee * lee);
        scale_field(block.breaking, 0, n, lee);
        scale_field(block.breaking, 2, n, lee * lee);
        scale_field(block.remainder, 0, i, lee);
    }
}

template <typename Scalar>
void ShoreSurface::apply_swash(const SwashPlace<Scalar>& place, const SwashWaves<Scalar>& waves,
                               const Scalar& bed_influence, LinearWaves<Scalar>& surface,
                               ShorePoint& point) const {
    const SwashSurface<Scalar> swash = swash_surface(run_up_, place, waves, surface.height);
    surface.height = surface.height + bed_influence * (swash.height - surface.height);
    const Scalar displaced = Scalar(1.0f) + bed_influence * (swash.displaced - Scalar(1.0f));
    surface.displacement_x = displaced * surface.displacement_x;
    surface.displacement_y = displaced * surface.displacement_y;

    const float bed = place.bed.value();
    const float depth = surface.height.value() - bed;
    const float slope = place.slope.value();
    point.wetness = covered_by(depth);
    point.breaking *= surf_left(bed);
    if (!run_up_.runs_up) return;
    const float run_up =
        run_up_2_percent(run_up_scale(run_up_, place.arrival.value()), beach_slope(slope));
    point.wetness = std::max(point.wetness, damp_of(bed, run_up));
    point.breaking = std::max(point.breaking, tip_foam(depth, slope, swash_weight(bed)));
}

template <typename Scalar>
void ShoreSurface::finish(Block<Scalar>& block, std::span<ShorePoint> points) const {
    const auto chop = static_cast<float>(choppiness_);
    const ShoalingBlock& shoaling = block.shoaling;
    std::array<LinearWaves<Scalar>, kShoreBlock> coast;
    for (ShorePoint& point : points) point = {};
    for (std::size_t n = 0; n < shoaling.places.count; ++n) {
        const std::size_t i = shoaling.label[n];
        const Scalar bed_influence = block.bed_influence[i];
        const Scalar depth = field_at<Scalar>(block.ground, 1, i);
        const Scalar rms_height = field_at<Scalar>(block.breaking, 0, n);
        const Scalar k = block.wavenumber[n];
        const Scalar real = shoaling.sums.real.at<Scalar>(n);
        const Scalar imaginary = shoaling.sums.imaginary.at<Scalar>(n);
        const Scalar highest =
            highest_wave(k, depth, breaker_index(field_at<Scalar>(block.ground, 2, i)));
        const Scalar gain =
            limiter_gain_(rms_height / highest, typical_shape_root(rms_height, k, depth));
        const BrokenWave<Scalar> broken = broken_wave(real, imaginary, highest, gain, k, depth);
        // Waves in no band change with the shortest waves in bands.
        const double x = shoaling.places.x[n], y = shoaling.places.y[n];
        const auto unbanded = block.exact != nullptr
                                  ? waves_of<Scalar>(block.exact->remainder.at_label(x, y))
                                  : remainder_.read<Scalar>(x, y);
        const Scalar short_wave_gain =
            Scalar(1.0f) +
            bed_influence *
                (short_waves_left(depth) * field_at<Scalar>(block.remainder, 0, i) - Scalar(1.0f));
        // Limiter and shape fade in with the influence of the bed, and the rest of the open sea's
        // displacement fades out.
        const Scalar share = Scalar(1.0f) + bed_influence * (broken.share - Scalar(1.0f));
        const Scalar open = Scalar(1.0f) - bed_influence;
        const LinearWaves<Scalar>& sea = block.open[i];
        coast[n].height =
            real + bed_influence * (broken.height - real) + short_wave_gain * unbanded.height;
        coast[n].displacement_x = share * shoaling.sums.along_x.at<Scalar>(n) +
                                  short_wave_gain * unbanded.displacement_x +
                                  open * (sea.displacement_x - unbanded.displacement_x -
                                          shoaling.sums.left_x.at<Scalar>(n));
        coast[n].displacement_y = share * shoaling.sums.along_y.at<Scalar>(n) +
                                  short_wave_gain * unbanded.displacement_y +
                                  open * (sea.displacement_y - unbanded.displacement_y -
                                          shoaling.sums.left_y.at<Scalar>(n));
        // The waves in no band break by the wind and end before the water does. Where few waves
        // arrive, few are steep enough to break by the wind.
        points[i].surf = std::max({surf_weight(rms_height.value(), depth.value()),
                                   1.0f - short_waves_left(Plain(depth.value())).value(),
                                   1.0f - shore_step(Plain(block.breaking.value[2][n])).value()});
        points[i].breaking = breaking_source(real.value(), imaginary.value(), rms_height.value(),
                                             depth.value(), block.breaking.value[1][n]);
        apply_swash<Scalar>(swash_place<Scalar>(block.ground, i, block.breaking, n),
                            {real, imaginary, shoaling.sums.squares.at<Scalar>(n)}, bed_influence,
                            coast[n], points[i]);
    }
    for (std::size_t i = 0, n = 0; i < block.places.count; ++i) {
        const bool is_shoaling = n < shoaling.places.count && shoaling.label[n] == i;
        const LinearWaves<Scalar>& local = is_shoaling ? coast[n] : block.open[i];
        n += is_shoaling ? 1 : 0;
        ShorePoint& point = points[i];
        point.on_bed = block.share[i].value();
        if (point.on_bed > 0.0f) point.bed = block.ground.value[0][i];
        BorderWeights<Scalar> weights;
        const bool mixed = point.on_bed < 1.0f && is_shoaling;
        if (mixed) {
            weights = border_weights(block.share[i],
                                     held_in_unit(field_at<Scalar>(block.remainder, 1, i)));
        }
        const auto mix = [&](const Scalar& coast_part, const Scalar& open_part) {
            return mixed ? weights.coast * coast_part + weights.open * open_part : coast_part;
        };
        point.height = Jet(mix(local.height, block.open[i].height));
        point.dx = Jet(-chop * mix(local.displacement_x, block.open[i].displacement_x));
        point.dy = Jet(-chop * mix(local.displacement_y, block.open[i].displacement_y));
        point.breaking *= point.on_bed;
        point.surf *= point.on_bed;
    }
}

}  // namespace ocean
