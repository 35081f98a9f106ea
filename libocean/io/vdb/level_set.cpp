// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface as a level set, column by column: no mesh, no search. The distance to the tangent
// plane above or below a voxel is exact in the vertical, where the surface is, and to second order
// elsewhere in the band.
#include <openvdb/tools/SignedFloodFill.h>

#include <cmath>

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

/// What is below and above 0 along each axis.
double box_distance(const WorldBox& box, double x, double y, double z) {
    const double q[3] = {std::max(box.low[0] - x, x - box.high[0]),
                         std::max(box.low[1] - y, y - box.high[1]),
                         std::max(box.low[2] - z, z - box.high[2])};
    const double inside = std::max({q[0], q[1], q[2]});
    if (inside <= 0.0) return inside;
    return std::hypot(std::max(q[0], 0.0), std::max(q[1], 0.0), std::max(q[2], 0.0));
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
        openvdb::tools::signedFloodFill(grid->tree(), kThreaded);
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

    double distance(std::size_t column, const Interval& beside, double z) const {
        const auto& [height, normal_z] = columns_[column];
        const double above = z - static_cast<double>(height);
        const double slanted = above * static_cast<double>(normal_z);
        // Where a crest has folded over, columns jump: water and air are never farther apart than
        // the columns, or the level set had a hole.
        if (above > 0.0) return z < beside.high ? std::min(slanted, voxels_.size) : slanted;
        return z > beside.low ? std::max(slanted, -voxels_.size) : slanted;
    }

    void make_leaves(int item, Leaves& leaves) const {
        struct Column {
            int i, j;
            std::size_t at;
            Interval beside;
        };
        std::vector<Column> here;
        Interval surface{1.0, 0.0};
        bool has_wall = false;
        places_.for_each_column(item, [&](int i, int j, std::size_t at) {
            here.push_back({i, j, at, neighbours(at)});
            const Interval band = surface_band(at, here.back().beside);
            surface = here.size() == 1 ? band
                                       : Interval{std::min(surface.low, band.low),
                                                  std::max(surface.high, band.high)};
            const double x = voxels_.size * i;
            const double y = voxels_.size * j;
            has_wall =
                has_wall || box_distance(box_, x, y, 0.5 * (box_.low[2] + box_.high[2])) > -band_;
        });
        const Interval bottom{box_.low[2] - band_, box_.low[2] + band_};
        const Interval wall{bottom.low, has_wall ? surface.high : bottom.high};
        for (int block = places_.first_block(); block <= places_.last_block(); ++block) {
            const double low = voxels_.size * LeafColumns::kSide * block;
            const double high = low + voxels_.size * (LeafColumns::kSide - 1);
            if (!surface.meets(low, high) && !wall.meets(low, high)) continue;
            const auto background = static_cast<float>(band_);
            auto leaf = std::make_unique<Leaf>(places_.corner(item, block), background);
            for (const Column& column : here) {
                for (int k = LeafColumns::kSide * block; k < LeafColumns::kSide * (block + 1);
                     ++k) {
                    const double z = voxels_.size * k;
                    const double d = std::max(
                        distance(column.at, column.beside, z),
                        box_distance(box_, voxels_.size * column.i, voxels_.size * column.j, z));
                    const auto value = std::clamp(static_cast<float>(d), -background, background);
                    const auto offset = Leaf::coordToOffset(axes_.file_of(column.i, column.j, k));
                    if (std::abs(value) < background) {
                        leaf->setValueOn(offset, value);
                    } else {
                        leaf->setValueOff(offset, value);
                    }
                }
            }
            if (!leaf->isEmpty()) leaves.push_back(std::move(leaf));
        }
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
