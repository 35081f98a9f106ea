// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Queries of one time, made from its modes. The displacement is inverted: a sample belongs to the
// label that is displayed at the point.
//
// Fields are interpolated by cubic splines on maps twice as fine as the displayed one. This is
// exact except for aliases of the shortest waves: a wave of length l has an error of (s / (l -
// s))^4 of its height, at most 1/81, with the spacing s of the fine samples. For a sea that its
// grid resolves, the rms error is below 2e-3 of the rms height, and below 1e-4 with refine = 2; the
// errors of slopes are at most 1/27 and 1/343 of the slopes of the shortest waves. Tests:
// query_test.cpp, for the presets preset_query_test.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ocean/internal/modes.hpp"
#include "ocean/query.hpp"

namespace ocean {

class ThreadPool;

/// Foam by label, over one period.
struct FoamMap {
    std::vector<float> values;  // resolution^2, row-major [j][i]
    int resolution = 0;         // 0 = no foam
};

/// Returns true if the surface of these modes may fold over itself: if six times the rms of the
/// gradient of its displacement reaches 1.
bool may_fold(const Modes& modes, double choppiness);

/// The surface of one time at any points. Computes only the parts of its maps near the requested
/// points, and keeps them. Several threads may sample at once. Keeps no reference to its arguments.
class SurfaceQuery {
  public:
    /// Packs the modes; maps follow with the first samples. Throws Error invalid_value for a refine
    /// that is not a power of two or that needs maps of more than 8192 samples. (refine = 1 is
    /// always allowed: a map of 8192 samples is not refined.)
    SurfaceQuery(const Modes& modes, const SurfaceSettings& settings, const Water& water,
                 double time, const QueryOptions& options, ThreadPool& pool, FoamMap foam = {});
    ~SurfaceQuery();
    SurfaceQuery(SurfaceQuery&&) noexcept;
    SurfaceQuery& operator=(SurfaceQuery&&) noexcept;

    /// Moves the query to another time and to these modes. Reuses what modes of the same revision,
    /// or of the same lattice, have in common. No thread may sample meanwhile.
    void move_to(const Modes& modes, const SurfaceSettings& settings, const Water& water,
                 double time, ThreadPool& pool, FoamMap foam = {});

    /// Writes one sample for each point. The bits are the same for any number of threads. Throws
    /// Error invalid_value for a point that is not finite, before any sample is written.
    void sample(std::span<const WorldPoint> points, std::span<QuerySample> samples,
                ThreadPool& pool) const;
    /// Returns the sample of one point, on the calling thread.
    QuerySample sample(WorldPoint point) const;

    double time() const;
    /// Returns the distance of the samples of the displayed map [m].
    double spacing() const;
    /// Returns the max distance between a label and the point where it is displayed [m]: eight
    /// times the rms of the displacement, or the sum of all waves' displacements if that is less.
    double reach() const;
    /// Returns the rms error of the samples' heights against the sum over all modes [m]: the waves
    /// that the displayed map does not hold and, without `exact`, the aliases of the others.
    double height_error() const;
    /// Returns the point where the interpolated surface displays a label. sample() inverts this to
    /// 2e-6 of reach().
    WorldPoint shown(WorldPoint label) const;

    /// Returns an upper bound of the bytes that the constructor needs for such modes.
    static std::uint64_t bytes(const Modes& modes, const QueryOptions& options);
    /// Returns the bound of bytes() from the resolution of the grid alone, without the bytes of
    /// `exact`.
    static std::uint64_t map_bytes(int grid_resolution, const QueryOptions& options);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The motion of the water at points fixed in the world, by linear theory, without displacement. It
/// decays with depth as cosh k(z + d) / sinh kd. Above z = 0 it equals the motion at z = 0; below
/// the bottom it is 0. [Dean and Dalrymple 1991] sections 4.2, 4.3. Several threads may sample at
/// once. Keeps no reference to its arguments.
class OrbitalMotion {
  public:
    /// Packs the modes for the height z [m], up from still water. Throws Error invalid_value if z
    /// is not finite, and for the options that SurfaceQuery refuses.
    OrbitalMotion(const Modes& modes, const Water& water, double time, double z,
                  const QueryOptions& options, ThreadPool& pool);
    ~OrbitalMotion();
    OrbitalMotion(OrbitalMotion&&) noexcept;
    OrbitalMotion& operator=(OrbitalMotion&&) noexcept;

    /// Moves the object to another time or depth, or to other modes. Reuses what both have in
    /// common. No thread may sample meanwhile.
    void move_to(const Modes& modes, const Water& water, double time, double z, ThreadPool& pool);

    /// Writes the motion at each point. Throws as SurfaceQuery::sample.
    void sample(std::span<const WorldPoint> points, std::span<WaterMotion> motions,
                ThreadPool& pool) const;
    /// Returns the motion at one point, on the calling thread.
    WaterMotion sample(WorldPoint point) const;

    /// Returns an upper bound of the bytes that the constructor needs for such modes.
    static std::uint64_t bytes(const Modes& modes, const QueryOptions& options);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean
