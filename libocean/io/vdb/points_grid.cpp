// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Spray as an OpenVDB point grid: points are sorted into voxels, with an array for each attribute.
#include <openvdb/points/PointConversion.h>
#include <openvdb/points/PointCount.h>
#include <tbb/task_arena.h>

#include "vdb_grids.hpp"

#ifdef OCEAN_LIBRARY_HAS_GRIDS
extern template class openvdb::tree::Tree<openvdb::points::PointDataTree::RootNodeType>;
extern template class openvdb::tree::Tree<openvdb::tools::PointIndexTree::RootNodeType>;
extern template class openvdb::Grid<openvdb::points::PointDataTree>;
extern template class openvdb::Grid<openvdb::tools::PointIndexTree>;
#endif

namespace ocean::io {
namespace {

namespace points = openvdb::points;
using openvdb::Vec3f;
using Index = openvdb::tools::PointIndexGrid;

/// Positions and attributes of the points in the types that OpenVDB requires.
template <typename Value>
class Values {
  public:
    using PosType = Value;
    using value_type = Value;

    explicit Values(std::span<const Value> values) : values_(values) {}
    std::size_t size() const { return values_.size(); }
    void getPos(std::size_t n, Value& value) const { value = values_[n]; }
    void get(Value& value, std::size_t n) const { value = values_[n]; }
    void get(Value& value, std::size_t n, openvdb::Index) const { value = values_[n]; }

  private:
    std::span<const Value> values_;
};

std::span<const Vec3f> vectors(const std::vector<float>& numbers) {
    static_assert(sizeof(Vec3f) == 3 * sizeof(float));
    return {reinterpret_cast<const Vec3f*>(numbers.data()), numbers.size() / 3};
}

}  // namespace

VdbGrid vdb::make_points(const Points& given, double cell) {
    openvdb::initialize();  // registers the types of attributes by name
    points::PointDataGrid::Ptr grid;
    const auto transform = openvdb::math::Transform::createLinearTransform(cell);
    const auto make = [&] {
        const Values positions(vectors(given.positions));
        const auto index = openvdb::tools::createPointIndexGrid<Index>(positions, *transform);
        grid = points::createPointDataGrid<points::NullCodec, points::PointDataGrid>(
            *index, positions, *transform);
        const auto add = [&]<typename Value>(const char* name, std::span<const Value> values) {
            points::appendAttribute<Value>(grid->tree(), name);
            points::populateAttribute<points::PointDataTree, Index::TreeType, Values<Value>>(
                grid->tree(), index->tree(), name, Values(values));
        };
        add("v", vectors(given.velocities));
        add("age", std::span(std::as_const(given.ages)));
        add("life", std::span(std::as_const(given.lives)));
        add("pscale", std::span(std::as_const(given.radii)));
        add("id",
            std::span(reinterpret_cast<const std::int64_t*>(given.ids.data()), given.ids.size()));
    };
    // OpenVDB would use all cores without regard to the user's limit.
    tbb::task_arena(1).execute(make);
    grid->setName("spray");
    return VdbGrid(std::make_shared<VdbGrid::Grid>(VdbGrid::Grid{grid}));
}

}  // namespace ocean::io
