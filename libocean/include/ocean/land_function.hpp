// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A land as a function of the place: its heights, slopes and masks anywhere, for maps of any region
// and cell. Every host reads the same function, so that neighbouring regions join without a seam.
//
//   h(x) = g(b(x)) + f(x) + d(x)
//
// b is the base: a spline through the waves of a tile, an elevation model, or the grid that streams
// have shaped. g adds gullies to it, f the waves that are finer than gullies, d the waves below the
// cells of a placed land. Where a shore has changed the land, a spline through the shore's grid
// replaces g(b(x)) + f(x); all other land has the same bits as without a shore. `cell` is the
// spacing of a map: waves shorter than two cells fade out, in g and d by their formulas, in b and f
// by the levels of a pyramid.
//
// Slopes are derivatives of h; with gullies, whose formula has no exact gradient, central
// differences over one cell.
//
//     const std::shared_ptr<const LandFunction> land = terrain.function();
//     const WorldPoint foot{120.0, 80.0};
//     QuerySample ground;
//     land->query({&foot, 1}, {&ground, 1}, 0.5, terrain.pool());
//     const Domain square{.origin = {100.0, 60.0}, .size = {40.0, 40.0}, .samples = {81, 81},
//                         .wraps = false};
//     const Surface map = land->surface(square, land->channels(), terrain.pool());
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "ocean/domain.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/query.hpp"
#include "ocean/surface.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

struct LandFunctionParts;

/// Immutable; several threads may read it at once.
class LandFunction {
  public:
    explicit LandFunction(LandFunctionParts parts);
    ~LandFunction();
    LandFunction(LandFunction&&) noexcept;

    /// Returns the tile after which the land repeats, or the rectangle of land that exists once,
    /// with the samples of the land's own grid.
    const Domain& domain() const;
    /// Returns the spacing of the land's own grid [m].
    double cell() const;
    /// Returns height, slopes, normal and the masks of the land.
    ChannelSet channels() const;

    /// Writes maps of samples `cell` apart [m], sample (i, j) at region.place(i, j); region.step()
    /// is `cell`. Places outside a land that exists once are clamped to it. A place has the same
    /// bits in every region whose origin is a whole number of cells from (0, 0) or that begins
    /// where the land does. Throws Error unsupported for channels that the land does not have.
    void write(const Domain& region, std::span<const MapOutput> outputs, ThreadPool& pool) const;
    Surface surface(const Domain& region, ChannelSet channels, ThreadPool& pool) const;

    /// Writes height and normal at each point, for maps of `cell` [m]. Throws Error invalid_value
    /// for a point that is not finite.
    void query(std::span<const WorldPoint> points, std::span<QuerySample> samples, double cell,
               ThreadPool& pool) const;

    std::uint64_t bytes() const;

  private:
    struct Impl;
    std::unique_ptr<const Impl> impl_;
};

}  // namespace ocean
