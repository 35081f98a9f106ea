// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The maps of energy: see energy_march.hpp. Marches run in turned grids (march_pass.hpp); this file
// reads them back into the world.
#include "energy_march.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "breaking.hpp"
#include "march_pass.hpp"
#include "march_waves.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

constexpr double kLargestArrival = 2.0;  // limit where a bed focuses waves
constexpr int kReportedColumns = 8;
constexpr float kFloorShare = 1e-6f;

void require(bool valid, const char* name, double value, const char* allowed) {
    if (valid) return;
    throw Error(ErrorKind::invalid_value, {.what = "is out of range",
                                           .parameter = name,
                                           .value = plain_text(value),
                                           .allowed = allowed});
}

void require_settings(const MarchSettings& settings) {
    require(settings.cell >= 4.0 && settings.cell <= 64.0, "cell", settings.cell, "4 .. 64 m");
    require(settings.direction_bin >= 0.999 * kDegree && settings.direction_bin <= 15.001 * kDegree,
            "direction_bin", settings.direction_bin, "1 .. 15 degrees");
    require(settings.min_depth > 0.0 && settings.min_depth <= 10.0, "min_depth", settings.min_depth,
            "0 .. 10 m, not 0");
}

/// Returns the domain of cells that covers another from its origin on.
Domain coarse_domain(const Domain& bed, double cell) {
    Domain domain{.origin = bed.origin, .wraps = false};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const int cells = std::max(static_cast<int>(std::ceil(bed.size[axis] / cell - 1e-9)), 1);
        domain.samples[axis] = cells + 1;
        domain.size[axis] = cells * cell;
    }
    return domain;
}

/// The read of a place beside land from the four places of a march about it: places that land
/// separates from it have no weight; the others have a total weight of 1, or 0 if there are none.
struct ReadPastLand {
    std::size_t place;  // index in the world
    std::array<std::size_t, 4> from;
    std::array<float, 4> weight;

    float value(const std::vector<float>& map) const {
        float sum = 0.0f;
        for (std::size_t n = 0; n < 4; ++n) sum += weight[n] * map[from[n]];
        return sum;
    }
};

/// One group and its march over the bed.
struct GroupMarch {
    MarchGroup group;
    MarchBed bed;
    std::vector<ReadPastLand> past_land;
};

/// The inputs that all marches of a sea share.
struct MarchInputs {
    const DirectionBins& bins;
    const DepthTables& depths;
    const Domain& world;
    double open_variance;  // of all waves [m^2]
    ThreadPool& pool;
};

/// Calls a host's progress after every few columns.
class ColumnCount {
  public:
    ColumnCount(const ShoreProgress& progress, long columns)
        : progress_(progress), columns_(columns) {}
    void add_one() {
        ++done_;
        if (!progress_ || (done_ % kReportedColumns != 0 && done_ != columns_)) return;
        progress_(static_cast<double>(done_) / static_cast<double>(columns_));
    }

  private:
    const ShoreProgress& progress_;
    long columns_;
    long done_ = 0;
};

/// Calls use(index, place) for each sample of the world.
template <typename Use>
void for_each_place(const MarchInputs& inputs, const Use& use) {
    const int columns = inputs.world.samples[0];
    inputs.pool.for_each_range(inputs.world.samples[1], [&](int first, int end) {
        for (int j = first; j < end; ++j) {
            for (int i = 0; i < columns; ++i) {
                use(static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                        static_cast<std::size_t>(i),
                    inputs.world.place(i, j));
            }
        }
    });
}

/// Returns the reads of a march at those places of the world that land separates from some of the
/// march's places about them. Land in the column before has let no energy through to the place;
/// land in the column behind has the energy of the water before it.
std::vector<ReadPastLand> reads_past_land(const MarchLand& land, const MarchBed& bed,
                                          const Domain& world) {
    std::vector<ReadPastLand> result;
    if (land.is_empty()) return result;
    const MarchGrid& grid = bed.grid;
    for (int place_j = 0, n = 0; place_j < world.samples[1]; ++place_j) {
        for (int place_i = 0; place_i < world.samples[0]; ++place_i, ++n) {
            const auto place = world.place(place_i, place_j);
            const auto [u, v] = grid.position(place);
            const int i = std::clamp(static_cast<int>(u), 0, grid.columns - 2);
            const int j = std::clamp(static_cast<int>(v), 0, grid.rows - 2);
            const bool is_open = bed.way[grid.index(i + 1, j)] == MarchBed::kOpen &&
                                 bed.way[grid.index(i + 1, j + 1)] == MarchBed::kOpen;
            if (is_open || land.is_land(place)) continue;
            ReadPastLand read{static_cast<std::size_t>(n), {}, {}};
            float sum = 0.0f;
            bool is_parted = false;
            for (std::size_t corner = 0; corner < 4; ++corner) {
                const int behind = static_cast<int>(corner / 2),
                          above = static_cast<int>(corner % 2);
                const auto from = grid.place(i + behind, j + above);
                const float seen =
                    behind == 0 && land.is_land(from) ? 0.0f : land.through(place, from);
                const double share_u = behind == 1 ? u - i : 1.0 - (u - i);
                const double share_v = above == 1 ? v - j : 1.0 - (v - j);
                read.from[corner] = grid.index(i + behind, j + above);
                read.weight[corner] = seen * static_cast<float>(share_u * share_v);
                sum += read.weight[corner];
                is_parted = is_parted || seen < 1.0f;
            }
            if (!is_parted) continue;
            for (float& weight : read.weight) weight = sum > 0.0f ? weight / sum : 0.0f;
            result.push_back(read);
        }
    }
    return result;
}

double variance_in_open_sea(const MarchGroup& group) {
    double sum = 0.0;
    for (const MarchWave& wave : group.waves) sum += wave.variance;
    return sum;
}

/// Returns a map of a march at the samples of the world.
std::vector<float> read_march(const MarchInputs& inputs, const GroupMarch& march,
                              const std::vector<float>& map) {
    std::vector<float> values(inputs.world.count());
    for_each_place(inputs, [&](std::size_t n, const std::array<double, 2>& place) {
        values[n] = march.bed.grid.read(map, place);
    });
    for (const ReadPastLand& read : march.past_land) values[read.place] = read.value(map);
    return values;
}

/// Returns the variance of a march's waves in its own grid [m^2].
std::vector<float> variance_of(const MarchGroup& group, const MarchField& field) {
    std::vector<float> sum(field.unshoaled.size(), 0.0f);
    for (std::size_t tag = 0; tag < group.waves.size(); ++tag) {
        const auto variance = static_cast<float>(group.waves[tag].variance);
        for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += variance * field.energy[tag][n];
    }
    return sum;
}

/// Marches all groups without breaking. Adds up the share of energy that arrives, and returns the
/// variance of each group in its own grid [m^2].
std::vector<std::vector<float>> march_without_breaking(const std::vector<GroupMarch>& marches,
                                                       const MarchInputs& inputs,
                                                       ColumnCount& count,
                                                       std::vector<float>& arrival) {
    std::vector<std::vector<float>> variances;
    for (const GroupMarch& march : marches) {
        const MarchGroup group = without_sectors(march.group);
        const MarchField field =
            march_group(group, inputs.bins, march.bed, inputs.depths, {.breaking = false},
                        inputs.pool, [&count] { count.add_one(); });
        const auto share = static_cast<float>(variance_in_open_sea(group) / inputs.open_variance);
        const std::vector<float> k = read_march(inputs, march, field.unshoaled);
        for (std::size_t n = 0; n < k.size(); ++n) arrival[n] += share * k[n];
        variances.push_back(variance_of(group, field));
    }
    for (float& k : arrival) k = std::min(k, static_cast<float>(kLargestArrival));
    return variances;
}

/// Returns the share of one group in the variance of all, in its grid. Breaking takes the same
/// share of all waves that meet, so that the shares are the same as without breaking.
std::vector<float> share_of(std::size_t own, const std::vector<GroupMarch>& marches,
                            const std::vector<std::vector<float>>& variances, ThreadPool& pool) {
    const MarchGrid& grid = marches[own].bed.grid;
    std::vector<float> shares(grid.size(), 1.0f);
    pool.for_each_range(grid.columns, [&](int first, int end) {
        for (int i = first; i < end; ++i) {
            for (int j = 0; j < grid.rows; ++j) {
                const std::size_t n = grid.index(i, j);
                float sum = variances[own][n];
                for (std::size_t other = 0; other < marches.size(); ++other) {
                    if (other == own) continue;
                    sum += marches[other].bed.grid.read(variances[other], grid.place(i, j));
                }
                if (sum > 0.0f) shares[n] = std::max(variances[own][n] / sum, kFloorShare);
            }
        }
    });
    return shares;
}

/// Marches all groups with breaking and writes their amplitudes.
void march_with_breaking(const std::vector<GroupMarch>& marches,
                         const std::vector<std::vector<float>>& variances,
                         const MarchInputs& inputs, ColumnCount& count, EnergyMaps& maps) {
    for (std::size_t m = 0; m < marches.size(); ++m) {
        const GroupMarch& march = marches[m];
        MarchLoss loss{.breaking = true, .open_variance = inputs.open_variance};
        if (marches.size() > 1) loss.own_share = share_of(m, marches, variances, inputs.pool);
        const MarchField field = march_group(march.group, inputs.bins, march.bed, inputs.depths,
                                             loss, inputs.pool, [&count] { count.add_one(); });
        for (std::size_t tag = 0; tag < march.group.members.size(); ++tag) {
            std::vector<float>& amplitude = maps.amplitude[march.group.members[tag]];
            amplitude = read_march(inputs, march, field.energy[tag]);
            for (float& a : amplitude) a = std::sqrt(a);
        }
    }
}

/// Sets the waves to 0 where none reaches the nearest sample of the bed.
void leave_still(const BedGrid& bed_height, EnergyMaps& maps) {
    if (maps.still.still.empty()) return;
    const Domain& domain = maps.domain;
    std::size_t n = 0;
    for (int j = 0; j < domain.samples[1]; ++j) {
        for (int i = 0; i < domain.samples[0]; ++i, ++n) {
            if (!maps.still.is_still(nearest_sample(bed_height.domain, domain.place(i, j))))
                continue;
            for (std::vector<float>& amplitude : maps.amplitude) amplitude[n] = 0.0f;
            maps.arrival[n] = 0.0f;
        }
    }
}

/// Writes the maps that follow from the amplitudes: height, breaking share, width of the groups.
void write_sums(const BedGrid& bed_height, const ShoreBands& bands, const MarchInputs& inputs,
                EnergyMaps& maps) {
    for_each_place(inputs, [&](std::size_t n, const std::array<double, 2>& place) {
        double variance = 0.0, squares = 0.0;
        for (std::size_t w = 0; w < bands.waves.size(); ++w) {
            const double a = double{maps.amplitude[w][n]};
            const double v = bands.waves[w].variance * a * a;
            variance += v;
            squares += v * v;
        }
        const double height = std::sqrt(8.0 * variance);
        const double depth = std::clamp(-bed_at(bed_height, place), inputs.depths.min_depth(),
                                        inputs.depths.max_depth());
        maps.rms_height[n] = static_cast<float>(height);
        maps.breaking_share[n] = static_cast<float>(share_that_breaks(height, depth));
        maps.group_width[n] =
            variance > 0.0 ? static_cast<float>(std::sqrt(squares) / variance) : 1.0f;
    });
}

}  // namespace

EnergyMaps march_energy(const BedGrid& bed_height, const ShoreBands& bands,
                        const DirectionalSpectrum& spectrum, const Water& water,
                        const MarchSettings& settings, ThreadPool& pool,
                        const ShoreProgress& progress) {
    require_settings(settings);
    EnergyMaps maps;
    maps.domain = coarse_domain(bed_height.domain, settings.cell);
    maps.amplitude.assign(bands.waves.size(), std::vector<float>(maps.domain.count()));
    maps.rms_height.resize(maps.domain.count());
    maps.breaking_share.resize(maps.domain.count());
    maps.arrival.resize(maps.domain.count());
    maps.group_width.resize(maps.domain.count());
    if (bands.waves.empty()) return maps;

    const DirectionBins bins = DirectionBins::of_width(settings.direction_bin);
    const DepthTables depths(bands, spectrum, water, settings.min_depth);
    double open_variance = 0.0;
    for (const ShoreWaves& waves : bands.waves) open_variance += waves.variance;
    const MarchInputs inputs{bins, depths, maps.domain, open_variance, pool};
    MarchSea sea = make_march_sea(bands, spectrum, water, bins);
    maps.still = find_still_water(bed_height, sea.incoming);
    const MarchLand land(bed_height, maps.still);
    std::vector<GroupMarch> marches;
    long columns = 0;
    for (MarchGroup& group : sea.groups) {
        const MarchGrid grid = MarchGrid::over(maps.domain, group.direction, settings.cell);
        columns += grid.columns;
        MarchBed bed = make_march_bed(bed_height, land, grid, bins, depths, pool);
        std::vector<ReadPastLand> past_land = reads_past_land(land, bed, maps.domain);
        marches.push_back({std::move(group), std::move(bed), std::move(past_land)});
    }
    ColumnCount count(progress, 2 * columns);
    const std::vector<std::vector<float>> variances =
        march_without_breaking(marches, inputs, count, maps.arrival);
    march_with_breaking(marches, variances, inputs, count, maps);
    leave_still(bed_height, maps);
    write_sums(bed_height, bands, inputs, maps);
    return maps;
}

}  // namespace ocean
