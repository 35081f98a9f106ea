// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rows of places; see land_row.hpp.
#include "land/function/land_row.hpp"

namespace ocean {
namespace {

void add(const GroundJet& jet, double share, std::size_t i, LandRow& row) {
    row.height[i] += share * jet.height;
    row.slope_x[i] += share * jet.slope_x;
    row.slope_y[i] += share * jet.slope_y;
}

void set_base(const LandFunctionParts& parts, double cell, bool with_slopes, LandRow& row) {
    const SplineGrid& base = parts.base->level(cell);
    if (with_slopes) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const GroundJet jet = base.at(row.x[i], row.y[i]);
            row.height[i] = jet.height;
            row.slope_x[i] = jet.slope_x;
            row.slope_y[i] = jet.slope_y;
        }
    } else {
        base.values_at(row.x, row.y, row.height);
    }
    for (double& height : row.height) height += parts.offset;
}

void add_gullies(const GullyFilter& gullies, double cell, bool with_masks, LandRow& row) {
    const std::size_t n = row.size();
    row.part_height.assign(n, 0.0f);
    row.part_x.assign(row.slope_x.begin(), row.slope_x.end());
    row.part_y.assign(row.slope_y.begin(), row.slope_y.end());
    for (auto& mask : row.masks) mask.resize(with_masks ? n : 0);
    gullies.apply({.x = row.x,
                   .y = row.y,
                   .height = row.part_height,
                   .slope_x = row.part_x,
                   .slope_y = row.part_y,
                   .wear = row.masks[0],
                   .gully = row.masks[1],
                   .ridge = row.masks[2]},
                  cell);
    for (std::size_t i = 0; i < n; ++i) row.height[i] += static_cast<double>(row.part_height[i]);
}

/// Replaces the ground by the shore's ground where the shore reaches.
void set_shore(const ShoreGround& shore, double cell, bool with_slopes, LandRow& row) {
    const ShoreGround::Level level = shore.level(cell);
    for (std::size_t i = 0; i < row.size(); ++i) {
        const double x = row.x[i], y = row.y[i];
        if (!level.reaches(x, y)) continue;
        if (!with_slopes) {
            row.height[i] = level.heights().value_at(x, y);
            continue;
        }
        const GroundJet jet = level.heights().at(x, y);
        row.height[i] = jet.height;
        row.slope_x[i] = jet.slope_x;
        row.slope_y[i] = jet.slope_y;
    }
}

}  // namespace

void compute(const LandFunctionParts& parts, double cell, ChannelSet wanted, LandRow& row) {
    // Gullies follow the slopes of the base.
    const bool is_base_alone = !parts.gullies && !parts.fine && !parts.detail;
    const bool with_slopes = !is_base_alone || wanted.intersects(kSlopes);
    set_base(parts, cell, with_slopes, row);
    if (parts.gullies) add_gullies(*parts.gullies, cell, wanted.intersects(kEveryMask), row);
    if (parts.fine) {
        const SplineGrid& fine = parts.fine->level(cell);
        for (std::size_t i = 0; i < row.size(); ++i) add(fine.at(row.x[i], row.y[i]), 1.0, i, row);
    }
    if (parts.shore) set_shore(*parts.shore, cell, with_slopes, row);
    if (!parts.detail) return;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const double x = row.x[i], y = row.y[i];
        const double share =
            parts.detail_share ? static_cast<double>(parts.detail_share->at(x, y)) : 1.0;
        if (share > 0.0) add(parts.detail->at(x, y, cell), share, i, row);
    }
}

}  // namespace ocean
