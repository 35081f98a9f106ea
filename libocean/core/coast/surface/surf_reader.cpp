// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast/surface/surf_reader.hpp"

#include <algorithm>
#include <functional>

#include "coast/surface/shore_surface.hpp"
#include "ocean/internal/surf_traces.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

std::vector<WorldPoint> labels_of(const Domain& domain) {
    std::vector<WorldPoint> labels(domain.count());
    std::size_t next = 0;
    for (int j = 0; j < domain.samples[1]; ++j) {
        for (int i = 0; i < domain.samples[0]; ++i) {
            const auto [x, y] = domain.place(i, j);
            labels[next++] = {x, y};
        }
    }
    return labels;
}

/// Returns whether a trace changes at labels: wet ground does in the swash alone.
bool needs(SurfTrace trace, const SurfLabels& labels) {
    return trace == SurfTrace::foam || labels.in_swash;
}

}  // namespace

RegionTraces::RegionTraces(const Domain& of) : domain(of), reader([of] { return labels_of(of); }) {}

const std::vector<SurfReader::Piece>& SurfReader::read(const ShoreSurface& surface,
                                                       ThreadPool& pool) {
    read(surface, SurfTrace::foam, pool);
    return *pieces_;
}

void SurfReader::read(const ShoreSurface& surface, SurfTrace trace, ThreadPool& pool) {
    if (!pieces_) {
        std::vector<Piece> pieces;
        for (SurfLabels& labels : find_surf(surface, labels_(), pool)) {
            std::vector<float> depths(labels.size());
            std::ranges::transform(labels.bed, depths.begin(), std::negate<>());
            pieces.push_back({std::move(labels), {}, std::move(depths)});
        }
        pieces_ = std::move(pieces);
    }
    foam_time_.reset();  // invalid until the new reads are complete
    wet_time_.reset();
    pool.for_each_item(static_cast<int>(pieces_->size()), [&](int number, int) {
        Piece& piece = (*pieces_)[static_cast<std::size_t>(number)];
        if (!needs(trace, piece.labels)) return;
        std::span<float> breaking;
        if (trace == SurfTrace::foam) {
            piece.breaking.resize(piece.labels.size());
            breaking = piece.breaking;
        }
        surface.read_surf(piece.labels, breaking, piece.depths);
    });
}

SignalCells SurfReader::cells(const ShoreSurface& surface, SurfTrace trace,
                              ThreadPool& pool) const {
    std::vector<const SurfLabels*> labels;
    for (const Piece& piece : *pieces_) {
        if (needs(trace, piece.labels)) labels.push_back(&piece.labels);
    }
    return surface.cells(labels, pool);
}

FoamSource SurfReader::source(SurfTrace trace, double lifetime, SurfaceAt surface_at,
                              ThreadPool& pool,
                              std::function<void(std::int64_t, std::int64_t)> progress) {
    const auto tick = [this, trace, surface_at = std::move(surface_at), &pool](
                          double time, const FoamLayer& before, std::span<float> left) {
        const bool is_foam = trace == SurfTrace::foam;
        if ((is_foam ? foam_time_ : wet_time_) != time) {
            std::optional<SignalCells>& cells = cells_[static_cast<std::size_t>(trace)];
            const ShoreSurface& surface = surface_at(time, cells ? &*cells : nullptr);
            read(surface, trace, pool);
            if (!cells) cells = this->cells(surface, trace, pool);
            wet_time_ = time;
            if (is_foam) foam_time_ = time;
        }
        std::ranges::fill(left, 0.0f);
        pool.for_each_item(static_cast<int>(pieces_->size()), [&](int number, int) {
            const Piece& piece = (*pieces_)[static_cast<std::size_t>(number)];
            for (std::size_t n = 0; n < piece.labels.size(); ++n) {
                const std::size_t i = piece.labels.index[n];
                const float past = before.map == nullptr ? 0.0f : before.fade * before.map[i];
                const float now = is_foam ? piece.breaking[n] : covered_by(piece.depths[n]);
                const float value = std::max(now, past);
                left[i] = value < before.cutoff ? 0.0f : value;
            }
        });
    };
    return {[lifetime](double) { return lifetime; }, tick, std::move(progress)};
}

}  // namespace ocean
