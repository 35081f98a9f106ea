// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Land that rivers have carved: uplift against erosion by stream power, on a grid that exists once.
//
//   dz/dt = U - K A^m S,   S = dz/dx downstream, A the drainage area [Whipple and Tucker 1999]
//
// Its steady state has the slope S = U / (K A^m) along every stream. Slope, outlets and areas
// belong to a drainage tree, and the tree to the heights: both are found in turn, from a grid of
// about 64 x 64 cells to the finest one, so that the trunk valleys are the same at every
// resolution. Areas are in square metres and never below `hillslope_area`, so that the cell drops
// out. Soil creep rounds the crests, and at last every cell drains to an outlet. Tests:
// stream_power_test.cpp, stream_grid_test.cpp.
//
// This is no simulation of time: there is one solution for each `age`, found without time steps.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "ocean/page_vector.hpp"
#include "ocean/terrain_model.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

/// The land of one level, row-major from the south-west.
struct StreamLevel {
    std::vector<float> start;   // heights before erosion [m]
    std::vector<float> uplift;  // relative, 0 .. 1; smaller values than 0.001 count as 0.001
    /// 1: water leaves here, and the height stays `start`. Creep carries the land's soil into
    /// outlets, down to the outlets' heights: outlets along a coast are at sea level, not at its
    /// bed.
    std::vector<std::uint8_t> outlet;
};

/// Returns the land of columns x rows cells of side `cell` [m], from the south-west corner of the
/// finest level on. Coarser levels have half as many cells a side, rounded up, of twice the side,
/// so that they may reach beyond finer ones by a part of a cell. Called once for each level, from
/// the coarsest, by the calling thread.
using StreamSource = std::function<StreamLevel(int columns, int rows, double cell)>;

/// Receives the share of the work done, 0 .. 1. Called by the calling thread at least five times a
/// second, except while the source works. If it throws, the call ends with that exception.
using StreamProgress = std::function<void(double share)>;

/// The steady land and its drainage, from which the land of any age follows. Never modified.
struct StreamTree;

/// Carved land. All maps are row-major from the south-west, columns x rows cells.
struct StreamLand {
    int columns = 0;
    int rows = 0;
    double cell = 0.0;         // [m]
    PageVector<float> height;  // [m]; every cell but an outlet has a lower neighbour
    PageVector<float> area;    // drained by the cell, its own area included [m2]
    /// 0 .. 1: A^2 / (A^2 + a^2), the drainage area A, a = kChannelArea; 0 in outlets.
    PageVector<float> channel;
    /// 0 .. 1: ln(A / (w S)) [Beven and Kirkby 1979] from kDryIndex to kWetIndex, the width w of a
    /// cell [m], the slope S of the surface, at least 0.001; 1 in outlets.
    PageVector<float> wetness;
    /// 0 .. 1: loose ground, the greater of soil and alluvium; 0 in outlets. Soil is d / (d +
    /// kSoilDepth), with the thickness d by which creep and the last flood cover the carved bed.
    /// Alluvium is 1 - h / f where this is positive, h the height above the nearest channel
    /// downstream, of kChannelArea at least [Nobre 2011], and f the depth of its floods,
    /// kFloodDepth (A / 1 km2)^0.4 [Leopold and Maddock 1953].
    PageVector<float> deposit;
    StreamSettings settings;
    std::shared_ptr<const StreamTree> tree;
};

inline constexpr double kChannelArea = 6e4;  // [m2]
inline constexpr double kDryIndex = 4.0;
inline constexpr double kWetIndex = 13.0;
inline constexpr double kFloodDepth = 3.0;  // at 1 km2 [m]
inline constexpr double kSoilDepth = 4.0;   // [m]

/// Limits of the sides of the finest level, and of its number of cells: indices of cells have 31
/// bits.
inline constexpr int kMinStreamSide = 2;
inline constexpr std::int64_t kMaxStreamCells = std::int64_t{1} << 31;

/// Carves the land of a source. If a level has no outlet, the lowest cell of its border, the first
/// of several, becomes one. The bits are the same for any number of threads. Throws Error
/// invalid_value for settings or sides out of range, and for a level of another size and for NaN
/// among its heights or uplifts; std::bad_alloc.
StreamLand carve(const StreamSettings& settings, int columns, int rows, double cell,
                 const StreamSource& source, ThreadPool& pool, const StreamProgress& progress = {});

/// Changes the age of carved land, 0 .. 1: heights, wetness and deposit, without another solution
/// of the tree. The result equals the result of carve with this age, bit by bit. Throws Error
/// invalid_value; if progress throws, the land is unchanged.
///
/// Young land is flat at the height of its outlet, and rises by U t until the slopes that travel
/// upstream from the outlet pass: with the time tau that they take from the outlet,
///   z(p, t) = Z(p) - Z(q) + Z(outlet),   tau(q) = tau(p) - t on the way down from p,
/// the exact solution for any uplift, Z the steady heights [Royden and Perron 2013].
void set_age(StreamLand& land, double age, ThreadPool& pool, const StreamProgress& progress = {});

/// Returns an upper bound of the bytes that carve or a later set_age needs, with the finest level
/// of the source and the land included: 54 a cell. The land alone has 30 a cell, and 2 for its
/// stems.
std::uint64_t stream_bytes(int columns, int rows);

}  // namespace ocean
