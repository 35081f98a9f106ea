// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The traces that waves leave on a coast at labels: foam where they break, and wet ground where
// they run up. The labels that waves reach are found once, and both traces share the reads of a
// time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

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

    /// Returns the source of a trace with a lifetime [s] that does not change. `surface_at` returns
    /// the surface of a time, and is called unless that time was read last. The reader must outlive
    /// the source.
    FoamSource source(SurfTrace trace, double lifetime,
                      std::function<const ShoreSurface&(double time)> surface_at, ThreadPool& pool,
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

    std::function<std::vector<WorldPoint>()> labels_;
    std::optional<std::vector<Piece>> pieces_;
    std::optional<double> foam_time_, wet_time_;  // for which the pieces hold a trace [s]
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
