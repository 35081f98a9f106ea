// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Adds Gaussians leaf by leaf, in the order in which they are given, so that the sums have the same
// bits for any number of threads.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "vdb_grids.hpp"

namespace ocean::io {
namespace {

using Leaf = openvdb::FloatTree::LeafNodeType;
using Leaves = std::vector<std::unique_ptr<Leaf>>;

constexpr double kWithin = 0.9973002;  // share of a Gaussian within kPuffReach, along an axis
constexpr float kMinDensity = 1e-5f;   // [1/m]; thinner voxels are inactive

/// The shares of a Gaussian in the voxels along an axis.
struct Weights {
    int first;  // voxel
    std::vector<float> share;

    int last() const { return first + static_cast<int>(share.size()) - 1; }
};

Weights weights_of(double place, double deviation, double voxel) {
    const double reach = kPuffReach * deviation;
    Weights weights{static_cast<int>(std::ceil((place - reach) / voxel)), {}};
    const int last = static_cast<int>(std::floor((place + reach) / voxel));
    const double factor = 1.0 / (std::sqrt(2.0 * std::numbers::pi) * deviation * kWithin);
    for (int i = weights.first; i <= last; ++i) {
        const double off = (voxel * i - place) / deviation;
        weights.share.push_back(static_cast<float>(factor * std::exp(-0.5 * off * off)));
    }
    return weights;
}

class Density {
  public:
    Density(const VoxelRange& voxels, std::span<const float> heights,
            std::span<const DensityPuff> puffs, FileAxes axes)
        : voxels_(voxels), heights_(heights), puffs_(puffs), axes_(axes), places_(voxels_, axes) {}

    openvdb::FloatGrid::Ptr make(ThreadPool& pool) const {
        const std::vector<std::vector<std::uint32_t>> nearby = sort();
        auto grid = openvdb::FloatGrid::create();
        add_leaves(grid->tree(), places_.count(), pool, [&](int item, Leaves& leaves) {
            make_leaves(item, nearby[static_cast<std::size_t>(item)], leaves);
        });
        return grid;
    }

  private:
    /// Sorts the puffs by the columns of leaves that they reach into.
    std::vector<std::vector<std::uint32_t>> sort() const {
        std::vector<std::vector<std::uint32_t>> nearby(static_cast<std::size_t>(places_.count()));
        for (std::uint32_t at = 0; at < puffs_.size(); ++at) {
            const DensityPuff& puff = puffs_[at];
            const double reach = density_reach(puff, voxels_.size);
            places_.for_each_item(puff.place[0] - reach, puff.place[0] + reach,
                                  puff.place[1] - reach, puff.place[1] + reach, [&](int item) {
                                      nearby[static_cast<std::size_t>(item)].push_back(at);
                                  });
        }
        return nearby;
    }

    void make_leaves(int item, const std::vector<std::uint32_t>& nearby, Leaves& leaves) const {
        constexpr int kSide = LeafColumns::kSide;
        std::vector<std::array<Weights, 3>> weights;
        int lowest = places_.last_block() + 1;
        int highest = places_.first_block() - 1;
        for (const std::uint32_t at : nearby) {
            const DensityPuff& puff = puffs_[at];
            const double deviation = density_reach(puff, voxels_.size) / kPuffReach;
            std::array<Weights, 3>& of = weights.emplace_back();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                of[axis] = weights_of(puff.place[axis], deviation, voxels_.size);
            }
            for (float& share : of[2].share) share *= static_cast<float>(puff.area);
            lowest = std::min(lowest, LeafColumns::block_of(of[2].first));
            highest = std::max(highest, LeafColumns::block_of(of[2].last()));
        }
        const int last_k = voxels_.first[2] + voxels_.count[2] - 1;
        for (int block = std::max(lowest, places_.first_block());
             block <= std::min(highest, places_.last_block()); ++block) {
            const int from = std::max(kSide * block, voxels_.first[2]);
            const int to = std::min(kSide * block + kSide - 1, last_k);
            auto leaf = std::make_unique<Leaf>(places_.corner(item, block), 0.0f);
            places_.for_each_column(item, [&](int i, int j, std::size_t column) {
                std::array<float, kSide> sums{};
                for (const std::array<Weights, 3>& of : weights) add(of, i, j, from, to, sums);
                for (int k = from; k <= to; ++k) {
                    const float density =
                        sums[static_cast<std::size_t>(k - from)] * dry_share(column, k);
                    if (density < kMinDensity) continue;
                    leaf->setValueOn(Leaf::coordToOffset(axes_.file_of(i, j, k)), density);
                }
            });
            if (!leaf->isEmpty()) leaves.push_back(std::move(leaf));
        }
    }

    static void add(const std::array<Weights, 3>& of, int i, int j, int from, int to,
                    std::array<float, LeafColumns::kSide>& sums) {
        if (i < of[0].first || i > of[0].last() || j < of[1].first || j > of[1].last()) return;
        const float across = of[0].share[static_cast<std::size_t>(i - of[0].first)] *
                             of[1].share[static_cast<std::size_t>(j - of[1].first)];
        const int end = std::min(to, of[2].last());
        for (int k = std::max(from, of[2].first); k <= end; ++k) {
            sums[static_cast<std::size_t>(k - from)] +=
                across * of[2].share[static_cast<std::size_t>(k - of[2].first)];
        }
    }

    /// Returns the share of a voxel above the water.
    float dry_share(std::size_t column, int k) const {
        const double above = voxels_.size * k - static_cast<double>(heights_[column]);
        return static_cast<float>(std::clamp(above / voxels_.size + 0.5, 0.0, 1.0));
    }

    const VoxelRange& voxels_;
    std::span<const float> heights_;
    std::span<const DensityPuff> puffs_;
    FileAxes axes_;
    LeafColumns places_;
};

}  // namespace

VdbGrid vdb::make_density(const VoxelRange& voxels, std::span<const float> heights,
                          std::span<const DensityPuff> puffs, VolumeAxes axes, ThreadPool& pool) {
    openvdb::FloatGrid::Ptr grid = Density(voxels, heights, puffs, {axes.y_up}).make(pool);
    grid->setGridClass(openvdb::GRID_FOG_VOLUME);
    return finished(grid, "density", voxels.size);
}

}  // namespace ocean::io
