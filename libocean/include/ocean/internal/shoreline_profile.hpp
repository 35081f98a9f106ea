// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The coast of a land that exists once: a shore line, a beach with a gentle bed where the shore is
// sheltered, a steep bed and the land's own cliffs where it is exposed, a shelf. It is the last
// step that changes heights, because it decides where water is.
//
// The shore line is the zero line of height - level after a Gaussian of deviation `smooth`; seas
// that then have no connection to the border of the grid become land. Symbols: D signed distance to
// the shore line [m], + on land; B shelter at the nearest point of it, 0 .. 1.
//   sea   depth = B bed(beach_slope to closure, then 1:90) + (1 - B) bed(0.16 to 7 m, then 1:40),
//         both flattened to `shelf`; from 900 to 2600 m off the shore the land's own depth takes
//         over, where it is deeper than 0.8 shelf
//   land  a beach of slope `face` up to `berm`, then 0.012, as wide as `width`, where B is 1; else
//         the land's own height, of at least 0.25 min(D, 12 m)
//   B     0 .. 1 as the share of land around the shore, a Gaussian of deviation `shelter`, goes
//         from 0.46 to 0.60, both less `beaches`: it is 1/2 at a straight shore and more within a
//         bay
// The water line of the result lies within half a cell of the shore line: up to 3/4 of a cell
// inland the land continues the slope of the bed, up to 9/4 it goes over into the law above.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "ocean/domain.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/terrain_model.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

/// The distance to the shore in a grid without any shore: + on land, - at sea [m].
inline constexpr float kNoShore = 1e9f;

/// Maps on the domain of the heights, row-major from the south.
struct ShorelineMaps {
    PageVector<float> beach;     // sand, from the back of the berm to the closure depth, 0 .. 1
    PageVector<float> cliff;     // a steep exposed shore, about 60 m wide on land, 0 .. 1
    PageVector<float> shelter;   // B, 0 .. 1
    PageVector<float> distance;  // D [m]
};

/// Shapes a row-major array of heights [m] in place and returns the maps. Afterwards a height is
/// above the level where D > 0 and below it elsewhere, without exception, and every sea reaches the
/// border. Beyond the border the land continues with the heights of its edge. Gaussians have a
/// deviation of at least one cell: with cells larger than `smooth` the shore is smoothed over one
/// cell.
///
/// A grid without any shore keeps its heights, and has D = +-kNoShore and 0 in the other maps; but
/// if it has lakes alone, they are filled, and if it has only rocks that are too small to be land,
/// they are sunk.
///
/// `progress` is called with the share that is done, 0 .. 1, from the calling thread; it may throw
/// to stop, the heights are then unchanged. Equal inputs give equal bits for any number of threads.
/// Blocks until the pool is done. Throws Error invalid_value, before it changes anything, for a
/// domain that wraps, has less than 2 or more than 65535 samples along a side or cells that are not
/// square, for another number of heights, for a height that is not finite and for settings out of
/// range; out_of_memory.
ShorelineMaps shape_shoreline(std::span<float> heights, const Domain& domain,
                              const ShorelineSettings& settings, ThreadPool& pool,
                              const std::function<void(double share)>& progress = {});

/// Returns the bytes that shape_shoreline allocates for a grid, maps included.
std::uint64_t shoreline_bytes(std::size_t cells);

}  // namespace ocean
