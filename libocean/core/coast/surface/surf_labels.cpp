// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast/surface/surf_labels.hpp"

#include <algorithm>
#include <array>

#include "coast/statics/breaking.hpp"
#include "coast/statics/shore_blend.hpp"
#include "coast/surface/shore_block.hpp"
#include "coast/surface/shore_surface.hpp"
#include "coast/surface/swash.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

/// Land above this multiple of the 2 % run-up stays dry.
constexpr float kNeverReached = 2.5f;

/// Returns true where waves may run up, and for ground near the line of still water.
bool is_in_swash(const RunUpSea& sea, const SwashPlace<Plain>& place) {
    const float bed = place.bed.value();
    if (!sea.runs_up || swash_weight(bed) <= 0.0f) return false;
    const float highest = run_up_2_percent(run_up_scale(sea, place.arrival.value()),
                                           beach_slope(place.slope.value()));
    return bed <= kNeverReached * highest;
}

/// Appends those labels, of up to kShoreBlock, that are in the swash, and those that are in the
/// surf alone.
void append_surf(const ShoreSurface& surface, std::span<const WorldPoint> labels,
                 std::uint32_t first, SurfLabels& swash, SurfLabels& surf_alone) {
    const ShoreStatics& statics = surface.statics();
    const Domain& domain = statics.domain();
    std::array<double, kShoreBlock> x{}, y{};
    for (std::size_t i = 0; i < labels.size(); ++i) {
        x[i] = labels[i].x;
        y[i] = labels[i].y;
    }
    GridPlaces places;
    QuadBlock broken, ground;
    places.find(statics.energy->breaking.domain(), labels.size(), x.data(), y.data());
    statics.energy->breaking.read(places, false, broken);
    places.find(domain, labels.size(), x.data(), y.data());
    statics.delays->ground.read(places, false, ground);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const float lee = statics.energy->lee.at(x[i], y[i]).height.value();
        scale_field(broken, 0, i, Plain(lee));
        scale_field(broken, 2, i, Plain(lee * lee));
        const float rms_height = broken.value[0][i];
        const float depth = ground.value[1][i];
        const float on_bed = statics.share_of_coast(x[i], y[i]).value();
        if (on_bed <= 0.0f) continue;
        const auto place = swash_place<Plain>(ground, i, broken, i);
        const bool runs_up = is_in_swash(surface.run_up(), place);
        const bool breaks = surf_weight(rms_height, depth) > 0.0f && place.bed.value() < 0.0f;
        if (!runs_up && !breaks) continue;
        SurfLabels& surf = runs_up ? swash : surf_alone;
        surf.index.push_back(first + static_cast<std::uint32_t>(i));
        surf.x.push_back(x[i]);
        surf.y.push_back(y[i]);
        surf.rms_height.push_back(rms_height);
        surf.depth.push_back(depth);
        surf.share.push_back(broken.value[1][i]);
        surf.on_bed.push_back(on_bed);
        surf.bed.push_back(place.bed.value());
        surf.slope.push_back(place.slope.value());
        surf.arrival.push_back(place.arrival.value());
        surf.group_width.push_back(place.group_width.value());
        surf.lee.push_back(lee);
        if (!runs_up) continue;
        const float k = statics.energy->depths.at(Plain(depth)).wavenumber.value();
        const float highest = highest_wave(k, depth, breaker_index(surf.slope.back()));
        surf.wavenumber.push_back(k);
        surf.highest.push_back(highest);
        surf.gain.push_back(
            surface.limiter_gain()(rms_height / highest, typical_shape_root(rms_height, k, depth)));
    }
}

}  // namespace

std::vector<SurfLabels> find_surf(const ShoreSurface& surface, std::span<const WorldPoint> labels,
                                  ThreadPool& pool) {
    constexpr std::size_t kPiece = 1024;
    const std::size_t count = (labels.size() + kPiece - 1) / kPiece;
    std::vector<SurfLabels> pieces(2 * count);
    pool.for_each_item(static_cast<int>(count), [&](int piece, int) {
        const auto p = static_cast<std::size_t>(piece);
        const std::size_t end = std::min((p + 1) * kPiece, labels.size());
        SurfLabels& swash = pieces[2 * p];
        swash.in_swash = true;
        for (std::size_t i = p * kPiece; i < end; i += kShoreBlock) {
            append_surf(surface, labels.subspan(i, std::min(kShoreBlock, end - i)),
                        static_cast<std::uint32_t>(i), swash, pieces[2 * p + 1]);
        }
    });
    std::erase_if(pieces, [](const SurfLabels& piece) { return piece.size() == 0; });
    return pieces;
}

void ShoreSurface::find_places(const SurfLabels& labels, std::size_t first,
                               BlockPlaces& places) const {
    places.count = std::min(kShoreBlock, labels.size() - first);
    std::copy_n(labels.x.begin() + static_cast<std::ptrdiff_t>(first), places.count,
                places.x.begin());
    std::copy_n(labels.y.begin() + static_cast<std::ptrdiff_t>(first), places.count,
                places.y.begin());
    find_places(places);
}

SignalCells ShoreSurface::cells(std::span<const SurfLabels* const> labels, ThreadPool& pool) const {
    SignalCells cells = signals_.no_cells();
    pool.for_each_item(static_cast<int>(cells.pairs.size()), [&](int pair, int) {
        const auto waves = static_cast<std::size_t>(pair);
        BlockPlaces places;
        QuadBlock delay;
        std::array<double, kShoreBlock> x, y;
        for (const SurfLabels* piece : labels) {
            for (std::size_t first = 0; first < piece->size(); first += kShoreBlock) {
                find_places(*piece, first, places);
                shift(waves, places, false, delay, x.data(), y.data());
                signals_.add_cells(waves, places.count, x.data(), y.data(), cells);
            }
        }
    });
    return cells;
}

void ShoreSurface::read_surf(const SurfLabels& labels, std::span<float> breaking,
                             std::span<float> depths) const {
    ShoalingBlock block;
    for (std::size_t first = 0; first < labels.size(); first += kShoreBlock) {
        const BlockPlaces& places = block.places;
        find_places(labels, first, block.places);
        add_waves(JetParts::value, false, nullptr, block);
        for (std::size_t n = 0; n < places.count; ++n) {
            const std::size_t at = first + n;
            const float lee = labels.lee[at];
            const float real = lee * block.sums.real.part[0][n];
            const float imaginary = lee * block.sums.imaginary.part[0][n];
            const float squares = lee * lee * block.sums.squares.part[0][n];
            const float bed = labels.bed[at];
            depths[at] =
                labels.in_swash ? swash_depth(labels, at, {real, imaginary, squares}) : -bed;
            if (breaking.empty()) continue;
            const float source = breaking_source(real, imaginary, labels.rms_height[at],
                                                 labels.depth[at], labels.share[at]);
            breaking[at] = surf_left(bed) * source;
            if (labels.in_swash) {
                const float tip = tip_foam(depths[at], labels.slope[at], swash_weight(bed));
                breaking[at] = std::max(breaking[at], tip);
            }
            breaking[at] *= labels.on_bed[at];
        }
    }
}

float ShoreSurface::swash_depth(const SurfLabels& labels, std::size_t at,
                                const SwashWaves<float>& waves) const {
    const float depth = labels.depth[at];
    const SwashPlace<float> place{labels.bed[at], labels.slope[at], labels.arrival[at],
                                  labels.rms_height[at], labels.group_width[at]};
    const BrokenWave<float> broken = broken_wave(waves.re, waves.im, labels.highest[at],
                                                 labels.gain[at], labels.wavenumber[at], depth);
    return swash_surface(run_up_, place, waves, broken.height).height - place.bed;
}

}  // namespace ocean
