// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The steady land with its drainage tree, and the levels that lead to it.
#pragma once

#include <cstdint>
#include <memory>

#include "land/streams/stream_tree.hpp"
#include "ocean/internal/stream_power.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

/// The solution of the finest level: 10 bytes a cell, and stems.
struct StreamTree {
    explicit StreamTree(const StreamGrid& of)
        : grid(of),
          directions(of.size()),
          donors(of.size()),
          steady(of.size()),
          response(of.size()) {}

    StreamGrid grid;
    PageVector<std::uint8_t> directions;  // direction of the receiver, or kOutlet
    PageVector<std::uint8_t> donors;      // a bit for each direction
    PageVector<float> steady;             // [m]
    PageVector<float> response;           // time from the outlet [m per unit of uplift]
    float last_response = 0.0f;           // the greatest response
    std::unique_ptr<StreamWalk> walk;     // refers to directions and donors
};

/// Returns the work of solve_levels and of finishing the land [ns].
double work_of_levels(const StreamGrid& finest);
double work_of_land(const StreamGrid& grid);

/// Solves all levels. Writes the cells that drain through each cell to `counts`, one for each cell.
std::shared_ptr<StreamTree> solve_levels(const StreamSettings& settings, const StreamGrid& finest,
                                         const StreamSource& source,
                                         PageVector<std::uint32_t>& counts, StreamWork& work);

}  // namespace ocean
