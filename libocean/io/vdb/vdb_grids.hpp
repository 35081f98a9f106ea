// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Builds OpenVDB grids from columns of voxels, one leaf of 8^3 voxels after the other: the tree is
// the same for any number of threads, and no voxel needs a look-up. Only the module includes
// OpenVDB.
#pragma once

#include <openvdb/openvdb.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "ocean/thread_pool.hpp"
#include "vdb_module.hpp"

// The library has all code of the grids whose types it registers: it is not compiled again here. On
// other systems, and in later versions, the library may hide it.
#if defined(__linux__) && OPENVDB_LIBRARY_MAJOR_VERSION_NUMBER <= 10
#define OCEAN_LIBRARY_HAS_GRIDS
#endif
#ifdef OCEAN_LIBRARY_HAS_GRIDS
extern template class openvdb::tree::Tree<openvdb::FloatTree::RootNodeType>;
extern template class openvdb::tree::Tree<openvdb::Vec3STree::RootNodeType>;
extern template class openvdb::Grid<openvdb::FloatTree>;
extern template class openvdb::Grid<openvdb::Vec3STree>;
#endif

namespace ocean::io {

struct VdbGrid::Grid {
    openvdb::GridBase::ConstPtr grid;
};

/// Returns the grid under a name, with voxels of a size [m].
inline VdbGrid finished(const openvdb::GridBase::Ptr& grid, const char* name, double voxel) {
    grid->setName(name);
    grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
    return VdbGrid(std::make_shared<VdbGrid::Grid>(VdbGrid::Grid{grid}));
}

/// Returns the coordinate in the file of the sea's voxel (i, j, k).
struct FileAxes {
    bool y_up;

    openvdb::Coord file_of(int i, int j, int k) const {
        return y_up ? openvdb::Coord(i, k, -j) : openvdb::Coord(i, j, k);
    }
    Velocity file_of(const Velocity& v) const { return y_up ? Velocity{v[0], v[2], -v[1]} : v; }
};

/// The leaves of a tree that share 8 x 8 columns.
class LeafColumns {
  public:
    static constexpr int kSide = 8;
    static_assert(kSide == openvdb::FloatTree::LeafNodeType::DIM);
    static_assert(kSide == openvdb::Vec3STree::LeafNodeType::DIM);

    LeafColumns(const VoxelRange& voxels, FileAxes axes)
        : voxels_(voxels),
          axes_(axes),
          first_x_(block_of(voxels.first[0])),
          first_y_(axes.y_up ? block_of(-last(1)) : block_of(voxels.first[1])),
          count_x_(block_of(last(0)) - first_x_ + 1),
          count_y_((axes.y_up ? block_of(-voxels.first[1]) : block_of(last(1))) - first_y_ + 1) {}

    int count() const { return count_x_ * count_y_; }
    int first_block() const { return block_of(voxels_.first[2]); }
    int last_block() const { return block_of(last(2)); }

    /// Calls body(i, j, column) for the existing columns of an item; `column` is the row-major
    /// index [j][i].
    template <typename Body>
    void for_each_column(int item, const Body& body) const {
        const int x = kSide * (first_x_ + item % count_x_);
        const int y = kSide * (first_y_ + item / count_x_);
        for (int j_file = y; j_file < y + kSide; ++j_file) {
            const int j = axes_.y_up ? -j_file : j_file;
            const int row = j - voxels_.first[1];
            if (row < 0 || row >= voxels_.count[1]) continue;
            for (int i = x; i < x + kSide; ++i) {
                const int at = i - voxels_.first[0];
                if (at < 0 || at >= voxels_.count[0]) continue;
                body(i, j,
                     static_cast<std::size_t>(row) * static_cast<std::size_t>(voxels_.count[0]) +
                         static_cast<std::size_t>(at));
            }
        }
    }
    /// Calls body(item) for the items with columns in a rectangle of the sea [m].
    template <typename Body>
    void for_each_item(double x0, double x1, double y0, double y1, const Body& body) const {
        if (axes_.y_up) std::tie(y0, y1) = std::pair(-y1, -y0);
        const auto block = [this](double at) {
            return static_cast<int>(std::floor(at / (kSide * voxels_.size)));
        };
        const int last_x = std::min(block(x1), first_x_ + count_x_ - 1);
        const int last_y = std::min(block(y1), first_y_ + count_y_ - 1);
        for (int y = std::max(block(y0), first_y_); y <= last_y; ++y) {
            for (int x = std::max(block(x0), first_x_); x <= last_x; ++x) {
                body((y - first_y_) * count_x_ + x - first_x_);
            }
        }
    }
    /// Returns the corner of the leaf of an item and a block in the file.
    openvdb::Coord corner(int item, int block) const {
        const int x = kSide * (first_x_ + item % count_x_);
        const int y = kSide * (first_y_ + item / count_x_);
        const int z = kSide * block;
        return axes_.y_up ? openvdb::Coord(x, z, y) : openvdb::Coord(x, y, z);
    }

    /// Returns the block of 8 voxels that holds a voxel.
    static int block_of(int voxel) { return voxel >> 3; }

  private:
    int last(int axis) const {
        const auto a = static_cast<std::size_t>(axis);
        return voxels_.first[a] + voxels_.count[a] - 1;
    }

    const VoxelRange& voxels_;
    FileAxes axes_;
    int first_x_, first_y_;
    int count_x_, count_y_;
};

/// Calls make(item, leaves) for each item on all threads, and adds the leaves to the tree in the
/// order of the items.
template <typename Tree, typename Make>
void add_leaves(Tree& tree, int items, ThreadPool& pool, const Make& make) {
    using Leaf = typename Tree::LeafNodeType;
    std::vector<std::vector<std::unique_ptr<Leaf>>> leaves(static_cast<std::size_t>(items));
    pool.for_each_item(items,
                       [&](int item, int) { make(item, leaves[static_cast<std::size_t>(item)]); });
    for (auto& column : leaves) {
        for (std::unique_ptr<Leaf>& leaf : column) tree.addLeaf(leaf.release());
    }
}

}  // namespace ocean::io
