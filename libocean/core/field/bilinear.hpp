// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bilinear values within a cell, for all maps that must keep the range of their samples.
#pragma once

namespace ocean {

/// Returns the bilinear value at the shares u and v, 0 .. 1, of the two sides of a cell. `origin`
/// is the cell's value at (0, 0), `along` at (1, 0), `across` at (0, 1), `opposite` at (1, 1).
template <typename Value, typename Share>
auto bilinear(Value origin, Value along, Value across, Value opposite, Share u, Share v) {
    const auto first = origin + u * (along - origin);
    const auto last = across + u * (opposite - across);
    return first + v * (last - first);
}

}  // namespace ocean
