// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The shown surface at points of the world: its height, normal, velocity and foam where a buoy, a
// ship or a camera is. The displacement is inverted: a sample is that of the label which is shown
// at the point.
//
// Fields are interpolated by cubic splines on maps twice as fine as the one that is shown. That is
// exact but for the aliases of the shortest waves: a wave of l metres is off by (s / (l - s))^4 of
// its height, s = spacing of the fine samples, at most 1/81. The rms of that is less than 2e-3 of
// the rms height of a sea that its grid resolves, and less than 1e-4 with refine = 2; slopes are
// off by at most 1/27 and 1/343 of those of the shortest waves. Proved in query_test.cpp, for the
// presets in preset_query_test.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ocean/modes.hpp"
#include "ocean/surface.hpp"
#include "ocean/wave_sum.hpp"

namespace ocean {

class ThreadPool;

struct WorldPoint {
    double x;  // m
    double y;
};

/// Below the surface: z in metres up from still water.
struct WaterPoint {
    double x;  // m
    double y;
    double z;
};

struct QuerySample {
    double height;       // m
    double normal[3];    // unit, of the shown surface, on the side seen from above
    double velocity[3];  // m/s, d/dt of the shown point at its label
    double label[2];     // m, the label shown there
    double foam;         // 0 .. 1
    bool folded;         // several labels are shown there: this is the top one
    bool undecided;  // so folded that the search found no label, or not all: perhaps not the top
};

struct QueryOptions {
    bool exact = false;  // add up all modes in double
    int refine = 1;      // 1, 2, 4 ...: maps so many times finer still, for smaller errors
    bool foam = true;    // false: foam is 0 and costs nothing
    int resolution = 0;  // of the map that is shown: waves it does not hold are not there; 0 = the
                         // modes' own

    bool operator==(const QueryOptions&) const = default;
};

/// Foam by label, over one period.
struct FoamMap {
    std::vector<float> values;  // resolution^2, row-major [j][i]
    int resolution = 0;         // 0 = no foam
};

/// Whether the surface of these modes may lie over itself anywhere: where the gradient of its
/// displacement, six times its rms, reaches 1.
bool may_fold(const Modes& modes, double choppiness);

/// The surface of one time, of which only what is near the points asked for is made. Several
/// threads may ask at once. Keeps no reference.
class SurfaceQuery {
  public:
    /// Throws Error invalid_value for a refine that is no power of two or needs maps of more than
    /// 8192 samples. (refine = 1 is always allowed: of a map of 8192 samples there is no finer.)
    SurfaceQuery(const Modes& modes, const SurfaceSettings& settings, const Water& water,
                 double time, const QueryOptions& options, ThreadPool& pool, FoamMap foam = {});
    ~SurfaceQuery();
    SurfaceQuery(SurfaceQuery&&) noexcept;
    SurfaceQuery& operator=(SurfaceQuery&&) noexcept;

    /// From now on of another time, and of those modes: what the same modes (by their revision), or
    /// others of the same lattice, need again is kept. Nobody may ask meanwhile.
    void move_to(const Modes& modes, const SurfaceSettings& settings, const Water& water,
                 double time, ThreadPool& pool, FoamMap foam = {});

    /// As many samples as points; the same bits for any number of threads. Throws Error
    /// invalid_value for a point that is not finite, before any sample is written.
    void sample(std::span<const WorldPoint> points, std::span<QuerySample> samples,
                ThreadPool& pool) const;
    QuerySample sample(WorldPoint point) const;

    double time() const;
    /// Distance of the samples of the shown map, m.
    double spacing() const;
    /// No label is shown farther than this from where it is, m: eight times the rms of the
    /// displacement, or what all waves together may make if that is less.
    double reach() const;
    /// rms of what samples' heights lack of the sum over all modes, m: the waves that the shown map
    /// does not hold, and without `exact` the aliases of the others.
    double height_error() const;
    /// Where the interpolated surface shows a label. sample() finds its inverse to 2e-6 of reach().
    WorldPoint shown(WorldPoint label) const;

    /// Bytes that the constructor needs for such modes, at most.
    static std::uint64_t bytes(const Modes& modes, const QueryOptions& options);
    /// The same before there are modes; without what `exact` needs besides.
    static std::uint64_t map_bytes(int grid_resolution, const QueryOptions& options);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// What moves in the water at points fixed in the world, by linear theory: no displacement. The
/// motion at a depth decays as cosh k(z + d) / sinh kd; above z = 0 it is that of z = 0, below the
/// bottom there is none. [Dean and Dalrymple 1991] sections 4.2, 4.3. Several threads may ask at
/// once. Keeps no reference.
class OrbitalMotion {
  public:
    /// z in metres up from still water. Throws Error invalid_value if it is not finite.
    OrbitalMotion(const Modes& modes, const Water& water, double time, double z,
                  const QueryOptions& options, ThreadPool& pool);
    ~OrbitalMotion();
    OrbitalMotion(OrbitalMotion&&) noexcept;
    OrbitalMotion& operator=(OrbitalMotion&&) noexcept;

    /// From now on of another time or depth, or of other modes: what they need again is kept.
    /// Nobody may ask meanwhile.
    void move_to(const Modes& modes, const Water& water, double time, double z, ThreadPool& pool);

    /// Throws like SurfaceQuery::sample.
    void sample(std::span<const WorldPoint> points, std::span<WaterMotion> motions,
                ThreadPool& pool) const;
    WaterMotion sample(WorldPoint point) const;

    /// Bytes that the constructor needs for such modes, at most.
    static std::uint64_t bytes(const Modes& modes, const QueryOptions& options);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace ocean
