// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Volumes of the water in a box of the world as OpenVDB grids, for simulations and renderers: its
// surface as a level set, its velocity, the mist above it. Voxel (i, j, k) is the point size * (i,
// j, k) of the world, so that the voxels of neighbouring boxes are the same.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ocean/io/points.hpp"
#include "ocean/io/provenance.hpp"

namespace ocean {

class ThreadPool;

namespace io {

/// In metres, x and y horizontal, z up from still water.
struct WorldBox {
    std::array<double, 3> low;
    std::array<double, 3> high;
};

/// Voxels first .. first + count - 1 of each axis.
struct VoxelRange {
    std::array<int, 3> first;
    std::array<int, 3> count;
    double size = 0.0;  // m

    double place(int axis, int index) const {
        return size * (first[static_cast<std::size_t>(axis)] + index);
    }
    std::size_t columns() const {
        return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]);
    }
    std::uint64_t voxels() const { return columns() * static_cast<std::uint64_t>(count[2]); }
};

/// The voxels in a box, and so many beyond each of its sides. Throws Error invalid_value for a box
/// that is empty or has more than 2^30 voxels along an axis.
VoxelRange voxels_around(const WorldBox& box, double size, int beyond);

/// Voxels on either side of the surface that a level set knows the distance of.
inline constexpr int kLevelSetBand = 3;

/// The surface above a column of voxels.
struct SurfaceColumn {
    float height;    // m
    float normal_z;  // of its unit normal, 0 .. 1
};

/// How a volume lies in its file.
struct VolumeAxes {
    bool y_up = false;  // (x, y, z) of the sea is (x, z, -y) of the file
};

/// A grid of a file; copies share it.
class VdbGrid {
  public:
    struct Grid;
    explicit VdbGrid(std::shared_ptr<const Grid> grid) : grid_(std::move(grid)) {}
    const Grid& grid() const { return *grid_; }

  private:
    std::shared_ptr<const Grid> grid_;
};

/// `surface`, a level set of the water in the box: negative inside, exact distances to the box's
/// sides and bottom, and (z - height) normal_z to the surface, the distance to its tangent plane.
/// Columns are those of voxels_around(box, size, kLevelSetBand), row-major [j][i]. Closed also
/// where neighbouring columns are more than the band apart. The same voxels for any number of
/// threads.
VdbGrid make_level_set(const WorldBox& box, const VoxelRange& voxels,
                       std::span<const SurfaceColumn> columns, VolumeAxes axes, ThreadPool& pool);

/// m/s.
using Velocity = std::array<float, 3>;
/// Writes the velocity at the voxels of layer k, row-major [j][i].
using VelocityLayer = std::function<void(int k, std::span<Velocity> layer)>;

/// `vel`, the velocity of the water at the voxels up to the band above the surface; what lies
/// higher is not there. `heights` are those of the columns. Layers are asked for from below.
VdbGrid make_velocity(const VoxelRange& voxels, std::span<const float> heights,
                      const VelocityLayer& layer, VolumeAxes axes, ThreadPool& pool);

/// Something thin in the air, a Gaussian.
struct DensityPuff {
    std::array<double, 3> place;  // m
    double deviation;             // m
    double area;                  // m^2, the cross-section of all of it
};
/// How far its density goes along each axis, m.
double density_reach(const DensityPuff& puff, double voxel);

/// `density`, a fog: 1/m, the cross-section in a cubic metre, of puffs above the water. `heights`
/// are those of the columns, row-major [j][i]; of a voxel at the surface its dry part counts. The
/// same voxels for any number of threads.
VdbGrid make_density(const VoxelRange& voxels, std::span<const float> heights,
                     std::span<const DensityPuff> puffs, VolumeAxes axes, ThreadPool& pool);

/// `spray`, points for OpenVDB's own readers: attributes P, v (m/s), age, life (s), pscale (the
/// radius, m) and id, a 64-bit integer; cells of so many metres. They lie as they are given.
VdbGrid make_points(const Points& points, double cell);
/// Bytes of a file of so many in so many leaves of 8^3 cells, at most, without its header.
std::uint64_t points_vdb_bytes(std::uint64_t count, std::uint64_t leaves);

/// The same grids and strings make the same bytes, which the library's own files do not: theirs
/// have a random number in their header. Throws Error output.
void write_vdb(std::span<const VdbGrid> grids, std::span<const HeaderString> strings,
               bool half_floats, const std::string& path);

/// What the file says of itself, without a look at its grids. Throws Error bad_file.
std::vector<HeaderString> read_vdb_header(const std::string& path);

}  // namespace io
}  // namespace ocean
