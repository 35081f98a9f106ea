// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "vdb_grids.hpp"

namespace ocean::io {
namespace {

using VectorLeaf = openvdb::Vec3STree::LeafNodeType;
using VectorLeaves = std::vector<std::unique_ptr<VectorLeaf>>;

}  // namespace

VdbGrid vdb::make_velocity(const VoxelRange& voxels, std::span<const float> heights,
                           const VelocityLayer& layer, VolumeAxes axes, ThreadPool& pool) {
    const FileAxes file{axes.y_up};
    const LeafColumns places(voxels, file);
    auto grid = openvdb::Vec3SGrid::create();
    const double above = kLevelSetBand * voxels.size;
    float highest = std::numeric_limits<float>::lowest();
    for (const float height : heights) highest = std::max(highest, height);

    constexpr int kSide = LeafColumns::kSide;
    const int last = voxels.first[2] + voxels.count[2] - 1;
    std::vector<std::vector<Velocity>> layers(kSide, std::vector<Velocity>(voxels.columns()));
    for (int block = places.first_block(); block <= places.last_block(); ++block) {
        const int first_k = std::max(kSide * block, voxels.first[2]);
        const int last_k = std::min(kSide * block + kSide - 1, last);
        if (voxels.size * first_k > static_cast<double>(highest) + above) break;
        for (int k = first_k; k <= last_k; ++k) {
            layer(k, layers[static_cast<std::size_t>(k - kSide * block)]);
        }
        add_leaves(grid->tree(), places.count(), pool, [&](int item, VectorLeaves& leaves) {
            auto leaf = std::make_unique<VectorLeaf>(places.corner(item, block));
            places.for_each_column(item, [&](int i, int j, std::size_t at) {
                const double top = static_cast<double>(heights[at]) + above;
                for (int k = first_k; k <= last_k && voxels.size * k <= top; ++k) {
                    const Velocity v =
                        file.file_of(layers[static_cast<std::size_t>(k - kSide * block)][at]);
                    leaf->setValueOn(VectorLeaf::coordToOffset(file.file_of(i, j, k)),
                                     openvdb::Vec3s(v[0], v[1], v[2]));
                }
            });
            if (!leaf->isEmpty()) leaves.push_back(std::move(leaf));
        });
    }
    grid->setVectorType(openvdb::VEC_CONTRAVARIANT_RELATIVE);
    return finished(grid, "vel", voxels.size);  // a name that Blender takes for motion
}

}  // namespace ocean::io
