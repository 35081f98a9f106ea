// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface as a level set, column by column, without a mesh or a search. The distance to the
// tangent plane above or below a voxel is exact at the surface and of second order elsewhere in the
// band.
#include <openvdb/tools/SignedFloodFill.h>

#include <array>
#include <cmath>
#include <limits>

#include "vdb_grids.hpp"

namespace ocean::io {
namespace {

using Leaf = openvdb::FloatTree::LeafNodeType;
using Leaves = std::vector<std::unique_ptr<Leaf>>;

/// A range from low to high, empty if high < low.
struct Interval {
    double low;
    double high;

    bool meets(double a, double b) const { return low <= b && a <= high; }
};

/// Returns the signed distance to the sides of the box along an axis, negative inside.
double side_distance(const WorldBox& box, std::size_t axis, double at) {
    return std::max(box.low[axis] - at, at - box.high[axis]);
}

/// Returns the signed distance to the box from the distances along x, y and z.
double box_distance(double x, double y, double z) {
    const double inside = std::max({x, y, z});
    if (inside <= 0.0) return inside;
    return std::hypot(std::max(x, 0.0), std::max(y, 0.0), std::max(z, 0.0));
}

class LevelSet {
  public:
    LevelSet(const WorldBox& box, const VoxelRange& voxels, std::span<const SurfaceColumn> columns,
             FileAxes axes)
        : box_(box),
          voxels_(voxels),
          columns_(columns),
          axes_(axes),
          band_(kLevelSetBand * voxels.size),
          places_(voxels_, axes) {}

    openvdb::FloatGrid::Ptr make(ThreadPool& pool) const {
        auto grid = openvdb::FloatGrid::create(static_cast<float>(band_));
        add_leaves(grid->tree(), places_.count(), pool,
                   [this](int item, Leaves& leaves) { make_leaves(item, leaves); });
        constexpr bool kThreaded =
            false;  // only the pool's threads, which the user limits, are used
        constexpr openvdb::Index kAboveLeaves = 1;  // nodes above leaves get the signs
        openvdb::tools::signedFloodFill(grid->tree(), kThreaded, 1, kAboveLeaves);
        return grid;
    }

  private:
    /// Returns the range of the surface in the neighbouring columns.
    Interval neighbours(std::size_t column) const {
        const auto width = static_cast<std::size_t>(voxels_.count[0]);
        const std::size_t i = column % width;
        const auto height = [this](std::size_t at) {
            return static_cast<double>(columns_[at].height);
        };
        Interval range{height(column), height(column)};
        const auto add = [&](bool is_there, std::size_t at) {
            if (!is_there) return;
            range.low = std::min(range.low, height(at));
            range.high = std::max(range.high, height(at));
        };
        add(i > 0, column - 1);
        add(i + 1 < width, column + 1);
        add(column >= width, column - width);
        add(column + width < columns_.size(), column + width);
        return range;
    }

    /// Returns the heights between which the band around the surface may lie.
    Interval surface_band(std::size_t column, const Interval& beside) const {
        constexpr double kMinSlope = 1e-3;  // z of a horizontal normal
        const auto& [height, normal_z] = columns_[column];
        const double reach = band_ / std::max(static_cast<double>(normal_z), kMinSlope);
        const double low = std::min(static_cast<double>(height) - reach, beside.low);
        const double high = std::max(static_cast<double>(height) + reach, beside.high);
        // Where the water rises out of the box, the surface is the box's top.
        return {std::min(low, box_.high[2] - band_), std::min(high, box_.high[2] + band_)};
    }

    struct Column {
        int i, j;
        std::size_t at;
        Interval beside;
        double side_x, side_y;  // side_distance
    };

    void make_leaves(int item, Leaves& leaves) const {
        std::vector<Column> here;
        Interval surface{1.0, 0.0};
        bool has_wall = false;
        places_.for_each_column(item, [&](int i, int j, std::size_t at) {
            here.push_back({i, j, at, neighbours(at), side_distance(box_, 0, voxels_.size * i),
                            side_distance(box_, 1, voxels_.size * j)});
            const Interval band = surface_band(at, here.back().beside);
            surface = here.size() == 1 ? band
                                       : Interval{std::min(surface.low, band.low),
                                                  std::max(surface.high, band.high)};
            has_wall = has_wall || std::max(here.back().side_x, here.back().side_y) > -band_;
        });
        const Interval bottom{box_.low[2] - band_, box_.low[2] + band_};
        const Interval wall{bottom.low, has_wall ? surface.high : bottom.high};
        for (int block = places_.first_block(); block <= places_.last_block(); ++block) {
            const double low = voxels_.size * LeafColumns::kSide * block;
            const double high = low + voxels_.size * (LeafColumns::kSide - 1);
            if (!surface.meets(low, high) && !wall.meets(low, high)) continue;
            auto leaf = make_leaf(item, block, here);
            if (!leaf->isEmpty()) leaves.push_back(std::move(leaf));
        }
    }

    using Distances = std::array<float, LeafColumns::kSide>;

    /// Writes the distances of the voxels from `first` upwards.
    void surface_distances(const Column& column, int first, Distances& d) const {
        const auto size = static_cast<float>(voxels_.size);
        const auto& [height, normal_z] = columns_[column.at];
        const double base = voxels_.size * first;
        const auto above = static_cast<float>(base - static_cast<double>(height));
        // Where a crest has folded over, heights jump between columns: the distance is limited to
        // the distance to the neighbouring columns, or the level set would have a hole.
        const auto highest = static_cast<float>(column.beside.high - base);
        const auto lowest = static_cast<float>(column.beside.low - base);
        constexpr float kFar = std::numeric_limits<float>::max();
        for (std::size_t k = 0; k < d.size(); ++k) {
            const float rise = size * static_cast<float>(k);
            const float slanted = (above + rise) * normal_z;
            const float upper = rise < highest ? size : kFar;
            const float lower = rise >= lowest ? -size : -kFar;
            d[k] = std::clamp(slanted, lower, upper);
        }
    }

    /// Intersects the column with the box.
    void box_distances(const Column& column, int first, Distances& d) const {
        const double low = voxels_.size * first;
        const double high = low + voxels_.size * (LeafColumns::kSide - 1);
        const double side = std::max(column.side_x, column.side_y);
        const double end = std::max(box_.low[2] - low, high - box_.high[2]);
        if (std::max(side, end) <= -band_) return;  // the box is farther away than the band
        for (std::size_t k = 0; k < d.size(); ++k) {
            const double z = voxels_.size * (first + static_cast<int>(k));
            const double box =
                box_distance(column.side_x, column.side_y, side_distance(box_, 2, z));
            d[k] = std::max(d[k], static_cast<float>(box));
        }
    }

    std::unique_ptr<Leaf> make_leaf(int item, int block, const std::vector<Column>& here) const {
        const auto background = static_cast<float>(band_);
        auto leaf = std::make_unique<Leaf>(places_.corner(item, block), background);
        float* const values = leaf->buffer().data();
        Leaf::NodeMaskType active;
        const int first = LeafColumns::kSide * block;
        const auto step = Leaf::coordToOffset(axes_.file_of(0, 0, 1));
        for (const Column& column : here) {
            std::array<float, LeafColumns::kSide> d{};
            surface_distances(column, first, d);
            box_distances(column, first, d);
            auto offset = Leaf::coordToOffset(axes_.file_of(column.i, column.j, first));
            for (const float distance : d) {
                values[offset] = std::clamp(distance, -background, background);
                if (std::abs(distance) < background) active.setOn(offset);
                offset += step;
            }
        }
        leaf->setValueMask(active);
        return leaf;
    }

    const WorldBox& box_;
    const VoxelRange& voxels_;
    std::span<const SurfaceColumn> columns_;
    FileAxes axes_;
    double band_;
    LeafColumns places_;
};

}  // namespace

VdbGrid vdb::make_level_set(const WorldBox& box, const VoxelRange& voxels,
                            std::span<const SurfaceColumn> columns, VolumeAxes axes,
                            ThreadPool& pool) {
    openvdb::FloatGrid::Ptr grid = LevelSet(box, voxels, columns, {axes.y_up}).make(pool);
    grid->setGridClass(openvdb::GRID_LEVEL_SET);
    return finished(grid, "surface", voxels.size);
}

}  // namespace ocean::io
