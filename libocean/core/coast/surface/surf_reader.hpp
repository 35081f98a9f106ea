// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The traces that waves leave on a coast at labels: foam where they break, and wet ground where
// they run up. The labels that waves reach are found once, and both traces share the reads of a
// time.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "coast/loops/band_signals.hpp"
#include "coast/surface/surf_labels.hpp"
#include "ocean/domain.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/query.hpp"

namespace ocean {

class ShoreSurface;
class ThreadPool;

enum class SurfTrace { foam, wet_ground };

/// Reads the waves in the surf and in the swash, for the foam clocks of both traces.
class SurfReader {
  public:
    /// `labels` returns the labels; called when the labels that waves reach are first needed.
    explicit SurfReader(std::function<std::vector<WorldPoint>()> labels)
        : labels_(std::move(labels)) {}

    /// Returns the surface of a time. cells: those that the reader reads, see
    /// ShoreSurface::move_to.
    using SurfaceAt = std::function<const ShoreSurface&(double time, const SignalCells* cells)>;
    /// Returns the source of a trace with a lifetime [s] that does not change. `surface_at` is
    /// called unless its time was read last. The reader must outlive the source.
    FoamSource source(SurfTrace trace, double lifetime, SurfaceAt surface_at, ThreadPool& pool,
                      std::function<void(std::int64_t, std::int64_t)> progress);

    /// A piece of the labels, with its reads of one time.
    struct Piece {
        SurfLabels labels;
        std::vector<float> breaking;  // source of foam, 0 .. 1
        std::vector<float> depths;    // [m]
    };
    /// Returns the labels that waves reach, as a surface has them. Valid until the next read.
    const std::vector<Piece>& read(const ShoreSurface& surface, ThreadPool& pool);

  private:
    /// Reads the labels that a trace needs: wet ground changes in the swash alone.
    void read(const ShoreSurface& surface, SurfTrace trace, ThreadPool& pool);
    /// Returns the cells of the labels that a trace needs, once it was read.
    SignalCells cells(const ShoreSurface& surface, SurfTrace trace, ThreadPool& pool) const;

    std::function<std::vector<WorldPoint>()> labels_;
    std::optional<std::vector<Piece>> pieces_;
    std::array<std::optional<SignalCells>, 2> cells_;  // of each trace
    std::optional<double> foam_time_, wet_time_;       // for which the pieces hold a trace [s]
};

/// The traces on a region, followed from call to call.
struct RegionTraces {
    explicit RegionTraces(const Domain& of);

    Domain domain;
    SurfReader reader;
    std::optional<FoamState> foam;  // foam of breaking waves
    std::optional<FoamState> wet;   // wetness of the ground
};

}  // namespace ocean
