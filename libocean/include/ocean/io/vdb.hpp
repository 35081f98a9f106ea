// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Volumes of the water in a box of the world as OpenVDB grids, for simulations and renderers: its
// surface as a level set, its velocity, the mist above it. Voxel (i, j, k) is the point
// size * (i, j, k) of the world, so that neighbouring boxes have voxels in common.
//
//     const io::WorldBox box{{0.0, 0.0, -6.0}, {200.0, 200.0, 6.0}};
//     const io::VoxelRange voxels = io::voxels_around(box, 0.5, io::kLevelSetBand);
//     std::vector<io::SurfaceColumn> columns = sample_columns(ocean, voxels);  // by queries
//     const io::VdbGrid water = io::make_level_set(box, voxels, columns, {}, ocean.pool());
//     io::write_vdb({&water, 1}, {}, false, "water.vdb");
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ocean/io/mesh.hpp"
#include "ocean/provenance.hpp"

namespace ocean {

class ThreadPool;

namespace io {

/// A box [m], x and y horizontal, z up from still water.
struct WorldBox {
    std::array<double, 3> low;
    std::array<double, 3> high;
};

/// The voxels first .. first + count - 1 along each axis.
struct VoxelRange {
    std::array<int, 3> first;
    std::array<int, 3> count;
    double size = 0.0;  // of a voxel [m]

    double place(int axis, int index) const {
        return size * (first[static_cast<std::size_t>(axis)] + index);
    }
    std::size_t columns() const {
        return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]);
    }
    std::uint64_t voxels() const { return columns() * static_cast<std::uint64_t>(count[2]); }
};

/// Returns the voxels in a box and `beyond` more on each of its sides. Throws Error invalid_value
/// for a box that is empty or has more than 2^30 voxels along an axis.
VoxelRange voxels_around(const WorldBox& box, double size, int beyond);

/// The voxels on either side of the surface for which a level set holds the distance.
inline constexpr int kLevelSetBand = 3;

/// The surface above a column of voxels.
struct SurfaceColumn {
    float height;    // [m]
    float normal_z;  // z of the unit normal, 0 .. 1
};

/// The axes of a volume in its file.
struct VolumeAxes {
    bool y_up = false;  // (x, y, z) of the sea is (x, z, -y) of the file
};

/// A grid of a file. Copies share it.
class VdbGrid {
  public:
    struct Grid;
    explicit VdbGrid(std::shared_ptr<const Grid> grid) : grid_(std::move(grid)) {}
    const Grid& grid() const { return *grid_; }

  private:
    std::shared_ptr<const Grid> grid_;
};

/// Returns the grid `surface`, a level set of the water in the box, negative inside. Distances to
/// the sides and the bottom of the box are exact; the distance to the surface is (z - height)
/// normal_z, measured to the tangent plane. `columns` belong to voxels_around(box, size,
/// kLevelSetBand), row-major [j][i]. The level set is closed even where the heights of neighbouring
/// columns differ by more than the band. The voxels do not depend on the number of threads.
VdbGrid make_level_set(const WorldBox& box, const VoxelRange& voxels,
                       std::span<const SurfaceColumn> columns, VolumeAxes axes, ThreadPool& pool);

/// [m/s].
using Velocity = std::array<float, 3>;
/// Writes the velocity at the voxels of layer k, row-major [j][i].
using VelocityLayer = std::function<void(int k, std::span<Velocity> layer)>;

/// Returns the grid `vel`, the velocity of the water at the voxels up to the band above the
/// surface; voxels above are inactive. `heights` are the surface heights of the columns [m]. Calls
/// `layer` for the layers from the lowest one upwards.
VdbGrid make_velocity(const VoxelRange& voxels, std::span<const float> heights,
                      const VelocityLayer& layer, VolumeAxes axes, ThreadPool& pool);

/// A Gaussian cloud of droplets in the air.
struct DensityPuff {
    std::array<double, 3> place;  // [m]
    double deviation;             // [m]
    double area;                  // total cross-section of the droplets [m^2]
};
/// A puff ends at this many standard deviations from its place, along each axis.
inline constexpr double kPuffReach = 3.0;
/// Returns the distance along each axis beyond which the density of a puff is 0 [m].
double density_reach(const DensityPuff& puff, double voxel);

/// Returns the grid `density`, a fog of the puffs above the water: the droplets' cross-section per
/// volume [m^2 / m^3]. `heights` are the surface heights of the columns [m], row-major [j][i]; a
/// voxel at the surface gets its dry share only. The voxels do not depend on the number of threads.
VdbGrid make_density(const VoxelRange& voxels, std::span<const float> heights,
                     std::span<const DensityPuff> puffs, VolumeAxes axes, ThreadPool& pool);

/// Returns the grid `spray`, points for OpenVDB's own readers, in cells of `cell` [m]: attributes P
/// [m], v [m/s], age, life [s], pscale (the radius) [m] and id, a 64-bit integer. Coordinates are
/// stored as given.
VdbGrid make_points(const Points& points, double cell);
/// Returns an upper bound of the size of a file with `count` points in `leaves` leaves of 8^3
/// cells, without its header [bytes].
std::uint64_t points_vdb_bytes(std::uint64_t count, std::uint64_t leaves);

/// Writes grids so that the same grids and strings make the same bytes; files that OpenVDB writes
/// itself have a random number in their header. Throws Error output.
void write_vdb(std::span<const VdbGrid> grids, std::span<const HeaderString> strings,
               bool half_floats, const std::string& path);

/// Returns the header strings of a file without reading its grids. Throws Error bad_file.
std::vector<HeaderString> read_vdb_header(const std::string& path);

}  // namespace io
}  // namespace ocean
