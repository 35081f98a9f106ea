// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The grids of a volume: the memory that they need, and the way from a frame's columns and puffs to
// a level set, a velocity and a fog.
#include <algorithm>
#include <array>
#include <cmath>

#include "formats/spray_points.hpp"
#include "formats/volumes.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"

namespace ocean {
namespace {

/// Counts of voxels, columns and puffs of the box, with room for the highest possible crests.
struct GridCounts {
    std::uint64_t surface = 0;
    std::uint64_t velocity = 0;
    std::uint64_t density = 0;
    std::uint64_t columns = 0;
    std::uint64_t puffs = 0;

    std::uint64_t voxels() const { return surface + velocity + density; }
};

GridCounts max_counts(const BakePlan& plan, const VolumeSettings& settings) {
    const double crest = settings.to_the_crest() ? settings.heights.top : 0.0;
    const io::WorldBox box = settings.world_box(crest);
    constexpr int kLeaf = 8;
    GridCounts counts;
    if (settings.surface) {
        const auto voxels = io::voxels_around(box, settings.voxel, io::kLevelSetBand + kLeaf);
        counts.surface = voxels.voxels();
        counts.columns = voxels.columns();
    }
    if (settings.velocity) {
        const auto voxels = io::voxels_around(box, settings.velocity_voxel, kLeaf);
        counts.velocity = 3 * voxels.voxels();
        counts.columns = std::max(counts.columns, voxels.columns());
    }
    if (settings.density) {
        constexpr double kUpwards = 5.0;  // [m/s]; mist spreads at this speed
        const double reach = 2.0 * kUpwards * settings.spray.lifetime;
        const auto voxels =
            io::voxels_around(settings.world_box(crest + reach), settings.velocity_voxel, kLeaf);
        counts.density = voxels.voxels();
        counts.columns = std::max(counts.columns, voxels.columns());
        const double period = plan.domain().size[0];
        double copies = 1.0;
        for (std::size_t axis = 0; axis < 2 && plan.domain().wraps; ++axis) {
            copies *= (box.high[axis] - box.low[axis] + 2.0 * reach) / period + 1.0;
        }
        counts.puffs = static_cast<std::uint64_t>(
            copies * static_cast<double>(max_spray_points(plan, settings.spray)));
    }
    return counts;
}

/// Returns a query of the map's waves, or of all waves over a bed, where maps do not repeat.
QueryOptions height_query(const BakePlan& plan) {
    return {.foam = false, .resolution = plan.domain().wraps ? plan.resolution : 0};
}

/// Returns a query of the waves that the velocity's voxels resolve, which are at least two voxels
/// long; over a bed, of all waves.
QueryOptions velocity_query(const BakePlan& plan, const VolumeSettings& settings) {
    if (!plan.domain().wraps) return {.foam = false};
    const double voxel = settings.velocity_voxel;
    const double period = plan.domain().size[0];
    int resolution = kMinResolution;
    while (2 * resolution <= plan.resolution && 2 * resolution * voxel <= period * (1.0 + 1e-9)) {
        resolution *= 2;
    }
    return {.foam = false, .resolution = resolution};
}

/// Returns the bytes of the mist's puffs and of the spray that makes them.
std::uint64_t mist_bytes(const BakePlan& plan, const SpraySettings& spray, std::uint64_t puffs) {
    return spray_bytes(max_spray_points(plan, spray)) +
           puffs * (sizeof(io::DensityPuff) + 2 * sizeof(std::uint32_t)) + spray_map_bytes(plan);
}

}  // namespace

std::uint64_t volume_frame_bytes(const BakePlan& plan, const VolumeSettings& settings) {
    const GridCounts counts = max_counts(plan, settings);
    const Costs costs = plan.subject->costs();
    constexpr std::uint64_t kColumnBytes = sizeof(io::SurfaceColumn) + sizeof(float) +
                                           8 * sizeof(io::Velocity);  // the layers of a leaf
    const std::uint64_t mist =
        settings.density ? mist_bytes(plan, settings.spray, counts.puffs) : std::uint64_t{0};
    // A voxel has a value and a share of its leaf's mask.
    return mist + counts.voxels() * (sizeof(float) + 1) + counts.columns * kColumnBytes +
           costs.query(height_query(plan)) + 2 * costs.query(velocity_query(plan, settings));
}

std::uint64_t max_volume_bytes(const BakePlan& plan, const VolumeSettings& settings) {
    const GridCounts counts = max_counts(plan, settings);
    const std::uint64_t size = settings.half_floats ? 2 : sizeof(float);
    return 2 * plan.subject_text.size() + 8192 + counts.voxels() * size;
}

namespace {

/// Calls receive(first, samples) for each piece of the columns in turn.
template <typename Receive>
void query_columns(const FrameWork& work, const io::VoxelRange& voxels, const QueryOptions& options,
                   const Receive& receive) {
    constexpr std::size_t kPiece = 1 << 16;
    const auto width = static_cast<std::size_t>(voxels.count[0]);
    std::vector<WorldPoint> points;
    std::vector<QuerySample> samples;
    for (std::size_t first = 0; first < voxels.columns(); first += kPiece) {
        points.clear();
        for (std::size_t at = first; at < std::min(first + kPiece, voxels.columns()); ++at) {
            points.push_back({voxels.place(0, static_cast<int>(at % width)),
                              voxels.place(1, static_cast<int>(at / width))});
        }
        samples.resize(points.size());
        work.source.query(work.time(), points, samples, options);
        receive(first, samples);
    }
}

/// The surface at the columns of a range, with its highest crest [m] and a count of the folds.
struct Columns {
    std::vector<io::SurfaceColumn> surface;
    double crest = -kMaxVolumeCoordinate;
    std::size_t folded = 0;

    std::vector<float> heights() const {
        std::vector<float> heights;
        heights.reserve(surface.size());
        for (const io::SurfaceColumn& column : surface) heights.push_back(column.height);
        return heights;
    }
};

Columns columns_of(const FrameWork& work, const io::VoxelRange& voxels) {
    Columns columns{std::vector<io::SurfaceColumn>(voxels.columns())};
    query_columns(work, voxels, height_query(work.plan),
                  [&](std::size_t first, const std::vector<QuerySample>& samples) {
                      for (std::size_t i = 0; i < samples.size(); ++i) {
                          const QuerySample& sample = samples[i];
                          columns.surface[first + i] = {static_cast<float>(sample.height),
                                                        static_cast<float>(sample.normal[2])};
                          columns.crest = std::max(columns.crest, sample.height);
                          columns.folded += sample.folded ? 1 : 0;
                      }
                  });
    return columns;
}

/// Returns the voxels of the box, up to a level-set band above `crest` [m] and `beyond` voxels
/// around it.
io::VoxelRange range_to(const VolumeSettings& settings, double voxel, int beyond, double crest) {
    return io::voxels_around(settings.world_box(crest + io::kLevelSetBand * voxel), voxel, beyond);
}

io::VdbGrid make_surface(const FrameWork& work, const VolumeSettings& settings,
                         io::VolumeAxes axes) {
    const Columns columns =
        columns_of(work, range_to(settings, settings.voxel, io::kLevelSetBand, 0.0));
    if (columns.folded > 0) {
        work.warn(format_text(
            "at %g s %zu of %zu columns lie where the crests have folded over: they take the top "
            "sheet",
            work.time(), columns.folded, columns.surface.size()));
    }
    const io::WorldBox box = settings.world_box(columns.crest + io::kLevelSetBand * settings.voxel);
    if (columns.crest < box.low[2]) {
        work.warn(work.plan.subject->kind() == kSeaKind
                      ? format_text("at %g s no water reaches the box, and its surface is empty",
                                    work.time())
                      : "the surface lies below the box, and its volume is empty");
    }
    return io::make_level_set(box, io::voxels_around(box, settings.voxel, io::kLevelSetBand),
                              columns.surface, axes, work.source.pool());
}

io::VdbGrid make_velocity(const FrameWork& work, const VolumeSettings& settings,
                          io::VolumeAxes axes) {
    constexpr int kBeyond = 1;  // interpolation at the sides of the box needs neighbours
    const double size = settings.velocity_voxel;
    const Columns columns = columns_of(work, range_to(settings, size, kBeyond, 0.0));
    const io::VoxelRange voxels = range_to(settings, size, kBeyond, columns.crest);
    const std::vector<float> heights = columns.heights();

    const QueryOptions query = velocity_query(work.plan, settings);
    const auto width = static_cast<std::size_t>(voxels.count[0]);
    std::vector<WaterPoint> points(voxels.columns());
    std::vector<WaterMotion> motions(voxels.columns());
    double motion_depth = -kMaxVolumeCoordinate;  // z of `motions` [m]
    const auto layer = [&](int k, std::span<io::Velocity> out) {
        const double z = std::min(size * k, 0.0);  // above still water: the motion at its level
        if (z != motion_depth) {
            for (std::size_t at = 0; at < points.size(); ++at) {
                points[at] = {voxels.place(0, static_cast<int>(at % width)),
                              voxels.place(1, static_cast<int>(at / width)), z};
            }
            ocean_of(work.source).water_motion(work.time(), points, motions, query);
            motion_depth = z;
        }
        for (std::size_t at = 0; at < out.size(); ++at) {
            out[at] = {static_cast<float>(motions[at].velocity_x),
                       static_cast<float>(motions[at].velocity_y),
                       static_cast<float>(motions[at].velocity_z)};
        }
    };
    return io::make_velocity(voxels, heights, layer, axes, work.source.pool());
}

/// Returns the puffs that reach into the box; for a sea that repeats, from all copies of the
/// period.
std::vector<io::DensityPuff> puffs_around(const FrameWork& work, const VolumeSettings& settings) {
    const double period = work.plan.domain().size[0];
    const bool wraps = work.plan.domain().wraps;
    const std::array<double, 6>& box = *settings.box;
    const double area = settings.spray.density > 0.0 ? settings.mist / settings.spray.density : 0.0;
    std::vector<io::DensityPuff> puffs;
    for (const MistPuff& mist :
         ocean_of(work.source).mist(work.time(), settings.spray, spray_region(work.plan))) {
        io::DensityPuff puff{{mist.x, mist.y, mist.z}, mist.deviation, area * mist.share};
        const double reach = io::density_reach(puff, settings.velocity_voxel);
        const auto first = [&](std::size_t axis) {
            const double copy = std::ceil((box[axis] - reach - puff.place[axis]) / period);
            return wraps ? copy : std::max(copy, 0.0);
        };
        const auto last = [&](std::size_t axis) {
            const double copy = std::floor((box[axis + 3] + reach - puff.place[axis]) / period);
            return wraps ? copy : std::min(copy, 0.0);
        };
        const double first_x = first(0), last_x = last(0), first_y = first(1), last_y = last(1);
        for (double ny = first_y; ny <= last_y; ++ny) {
            for (double nx = first_x; nx <= last_x; ++nx) {
                puff.place = {mist.x + nx * period, mist.y + ny * period, mist.z};
                puffs.push_back(puff);
            }
        }
    }
    return puffs;
}

io::VdbGrid make_mist(const FrameWork& work, const VolumeSettings& settings, io::VolumeAxes axes) {
    const double voxel = settings.velocity_voxel;
    const std::vector<io::DensityPuff> puffs = puffs_around(work, settings);
    if (puffs.empty()) {
        work.warn(
            format_text("at %g s the sea makes no spray, and its mist is empty", work.time()));
    }
    double highest = settings.box->at(2) + voxel;
    for (const io::DensityPuff& puff : puffs) {
        highest = std::max(highest, puff.place[2] + io::density_reach(puff, voxel));
    }
    const io::VoxelRange voxels = io::voxels_around(settings.world_box(highest), voxel, 0);
    const std::vector<float> heights = columns_of(work, voxels).heights();
    return io::make_density(voxels, heights, puffs, axes, work.source.pool());
}

}  // namespace

void write_volumes(const FrameWork& work, const VolumeSettings& settings,
                   std::span<const BakeFile> files) {
    const io::VolumeAxes axes{settings.axes == io::Axes::yup};
    std::vector<io::VdbGrid> grids;
    if (settings.surface) grids.push_back(make_surface(work, settings, axes));
    if (settings.velocity) grids.push_back(make_velocity(work, settings, axes));
    if (settings.density) grids.push_back(make_mist(work, settings, axes));
    work.write_and_verify(files.front(), [&] {
        io::write_vdb(grids, volume_strings(work.plan, settings, work.frame), settings.half_floats,
                      files.front().path);
    });
}

}  // namespace ocean
