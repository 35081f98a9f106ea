// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface as a level set, column by column: no mesh, no search. The distance to the tangent
// plane above or below a voxel is exact in the vertical, where the surface is, and to second order
// elsewhere in the band.
#include <openvdb/tools/SignedFloodFill.h>

#include <array>
#include <cmath>
#include <limits>

#include "vdb_grids.hpp"

namespace ocean::io {
namespace {

using Leaf = openvdb::FloatTree::LeafNodeType;
using Leaves = std::vector<std::unique_ptr<Leaf>>;

/// From low to high; none if that is the wrong way round.
struct Interval {
    double low;
    double high;

    bool meets(double a, double b) const { return low <= b && a <= high; }
};

/// Distance to a side of the box from inside it, and from outside, where that is above 0.
double side_distance(const WorldBox& box, std::size_t axis, double at) {
    return std::max(box.low[axis] - at, at - box.high[axis]);
}

/// To the box, of the distances to its sides along x, y and z.
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
        constexpr bool kThreaded = false;  // the pool's threads are those that the user allows
        constexpr openvdb::Index kAboveLeaves = 1;  // which have their signs
        openvdb::tools::signedFloodFill(grid->tree(), kThreaded, 1, kAboveLeaves);
        return grid;
    }

  private:
    /// Where the surface of the columns beside one is.
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

    /// The heights between which the band around the surface may lie.
    Interval surface_band(std::size_t column, const Interval& beside) const {
        constexpr double kLeastSlope = 1e-3;  // of a normal that lies
        const auto& [height, normal_z] = columns_[column];
        const double reach = band_ / std::max(static_cast<double>(normal_z), kLeastSlope);
        const double low = std::min(static_cast<double>(height) - reach, beside.low);
        const double high = std::max(static_cast<double>(height) + reach, beside.high);
        // The surface of a box that it rises out of is the box's top.
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

    /// Of the voxels from `first` up.
    void surface_distances(const Column& column, int first, Distances& d) const {
        const auto size = static_cast<float>(voxels_.size);
        const auto& [height, normal_z] = columns_[column.at];
        const double base = voxels_.size * first;
        const auto above = static_cast<float>(base - static_cast<double>(height));
        // Where a crest has folded over, columns jump: water and air are never farther apart than
        // the columns, or the level set had a hole.
        const auto highest = static_cast<float>(column.beside.high - base);
        const auto lowest = static_cast<float>(column.beside.low - base);
        constexpr float kFar = std::numeric_limits<float>::max();
        for (std::size_t k = 0; k < d.size(); ++k) {
            const float rise = size * static_cast<float>(k);
            const float slanted = (above + rise) * normal_z;
            const float most = rise < highest ? size : kFar;
            const float least = rise >= lowest ? -size : -kFar;
            d[k] = std::clamp(slanted, least, most);
        }
    }

    /// The intersection with the box.
    void box_distances(const Column& column, int first, Distances& d) const {
        const double low = voxels_.size * first;
        const double high = low + voxels_.size * (LeafColumns::kSide - 1);
        const double side = std::max(column.side_x, column.side_y);
        const double end = std::max(box_.low[2] - low, high - box_.high[2]);
        if (std::max(side, end) <= -band_) return;  // nothing of the box is near
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

VdbGrid make_level_set(const WorldBox& box, const VoxelRange& voxels,
                       std::span<const SurfaceColumn> columns, VolumeAxes axes, ThreadPool& pool) {
    openvdb::FloatGrid::Ptr grid = LevelSet(box, voxels, columns, {axes.y_up}).make(pool);
    grid->setName("surface");
    grid->setGridClass(openvdb::GRID_LEVEL_SET);
    grid->setTransform(openvdb::math::Transform::createLinearTransform(voxels.size));
    return VdbGrid(std::make_shared<VdbGrid::Grid>(VdbGrid::Grid{grid}));
}

}  // namespace ocean::io
