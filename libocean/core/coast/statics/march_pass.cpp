// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One march: see march_pass.hpp. The unknown is the flux F = E c_g cos(theta) along the march, by
// tag, bin of directions theta and row y. From column to column it solves
//   dF/dx + d(F tan(theta))/dy + d(F theta')/dtheta = - loss,
//   theta' = tan(theta) c_x / c - c_y / c,
// the balance of energy along rays [Dean and Dalrymple 1991]: a shift of each bin across the march,
// exact for a bed without depth changes; a shift of the distribution over directions that keeps its
// sum; and the loss, which takes the same share of all tags. The unit of a flux is the open sea's
// variance of its tag times the tag's group speed.
#include "march_pass.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "breaking.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

constexpr double kFadingAngle = 61.0 * kTwoPi / 360.0;
constexpr double kFadingLength = 76.0;    // length over which waves turned too far fall to 1/e [m]
constexpr double kLargestTurn = 3.0;      // in one column [bins]
constexpr double kMadeGood = 1.0 + 1e-5;  // factor on the open sea's breaking; allows for rounding
constexpr float kNothing = 1e-25f;        // less energy counts as 0, to avoid subnormals

std::size_t at(int n) {
    return static_cast<std::size_t>(n);
}

/// The constants of a march: the shift of each bin across it in rows, and turns.
struct BinShift {
    int rows;     // the row from which waves come lies `rows` to `rows + 1` rows back
    float share;  // weight of the farther row
    float fading;
    float over_cosine;  // 1 / cos(theta)
};

std::vector<BinShift> bin_shifts(const DirectionBins& bins, double cell) {
    std::vector<BinShift> result;
    for (int n = 0; n < bins.count; ++n) {
        const double theta = bins.centre(n), back = std::tan(theta);
        const double fading =
            std::abs(theta) > kFadingAngle ? std::exp(-cell / kFadingLength) : 1.0;
        result.push_back({static_cast<int>(std::floor(back)),
                          static_cast<float>(back - std::floor(back)), static_cast<float>(fading),
                          static_cast<float>(1.0 / std::cos(theta))});
    }
    return result;
}

/// One tag during its march.
struct TagState {
    std::vector<float> flux{};    // [bin][row]
    std::vector<float> next{};    // the same in the next column
    std::vector<float> energy{};  // [row] at this column, unshoaled, over the open sea's
    std::vector<float> along{};   // [row] flux along the march, over the open sea's energy
    float open_energy = 0.0f;     // sum over bins in the open sea
};

/// Shifts each bin across the march into state.next, times each row's `kept`.
void shift_across(TagState& state, const std::vector<BinShift>& shifts,
                  const std::vector<float>& kept) {
    const int rows = static_cast<int>(kept.size());
    for (std::size_t n = 0; n < shifts.size(); ++n) {
        const BinShift& shift = shifts[n];
        float* const from = &state.flux[n * kept.size()];
        float* const to = &state.next[n * kept.size()];
        for (int j = 0; j < rows; ++j) {
            const float f = from[j] * kept[at(j)];
            from[j] = f < kNothing ? 0.0f : f;
        }
        const auto read = [&](int j) {
            const float near = from[std::clamp(j - shift.rows, 0, rows - 1)];
            const float far = from[std::clamp(j - shift.rows - 1, 0, rows - 1)];
            return shift.fading * (near + shift.share * (far - near));
        };
        const int first = std::clamp(shift.rows + 1, 0, rows);
        const int end = std::clamp(rows + shift.rows, first, rows);
        for (int j = 0; j < first; ++j) to[j] = read(j);
        for (int j = first; j < end; ++j) {
            const float near = from[j - shift.rows], far = from[j - shift.rows - 1];
            to[j] = shift.fading * (near + shift.share * (far - near));
        }
        for (int j = end; j < rows; ++j) to[j] = read(j);
    }
}

/// A row of a column, and the shares that the bed lets through on the ways to it.
struct RowWays {
    int row;
    const MarchWays& ways;
};

std::vector<RowWays> rows_beside_land(const MarchBed& bed, int i) {
    std::vector<RowWays> result;
    for (int j = 0; j < bed.grid.rows && !bed.way.empty(); ++j) {
        const std::uint32_t way = bed.way[bed.grid.index(i, j)];
        if (way != MarchBed::kOpen) result.push_back({j, bed.ways[way]});
    }
    return result;
}

/// Rewrites the energy that comes to rows beside land. Each of the two rows that a bin comes from
/// contributes only what the land on its way lets through, so that no energy passes round a wall
/// between them.
void shift_past_land(TagState& state, const std::vector<BinShift>& shifts,
                     const std::vector<RowWays>& beside_land) {
    const std::size_t rows = state.energy.size();
    const int last = static_cast<int>(rows) - 1;
    for (std::size_t n = 0; n < shifts.size(); ++n) {
        const BinShift& shift = shifts[n];
        const float* const from = &state.flux[n * rows];
        float* const to = &state.next[n * rows];
        for (const auto& [j, ways] : beside_land) {
            const float near =
                ways.share[at(kWayRows + shift.rows)] * from[std::clamp(j - shift.rows, 0, last)];
            const float far = ways.share[at(kWayRows + shift.rows + 1)] *
                              from[std::clamp(j - shift.rows - 1, 0, last)];
            to[j] = shift.fading * (near + shift.share * (far - near));
        }
    }
}

/// Turns the waves of one row: the energy up to each edge of a bin is the energy up to the
/// direction from which waves at the edge came. along, across: the changes of ln c over one cell.
void turn_row(float* flux, std::size_t stride, const DirectionBins& bins, float along, float across,
              const std::vector<float>& edge_tangents) {
    constexpr int most_bins = 152;  // of 1 degree
    std::array<float, most_bins + 1> sums;
    const int count = bins.count;
    sums[0] = 0.0f;
    for (int n = 0; n < count; ++n) sums[at(n + 1)] = sums[at(n)] + flux[at(n) * stride];
    if (sums[at(count)] == 0.0f) return;
    const float per_bin = static_cast<float>(1.0 / bins.width);
    const float most = static_cast<float>(kLargestTurn);
    float below = 0.0f;
    for (int n = 0; n <= count; ++n) {
        const float turn =
            std::clamp((edge_tangents[at(n)] * along - across) * per_bin, -most, most);
        const float from =
            std::clamp(static_cast<float>(n) - turn, 0.0f, static_cast<float>(count));
        const int low = std::min(static_cast<int>(from), count - 1);
        const float sum =
            sums[at(low)] + (from - static_cast<float>(low)) * (sums[at(low + 1)] - sums[at(low)]);
        if (n > 0) flux[at(n - 1) * stride] = std::max(sum - below, 0.0f);
        below = sum;
    }
}

/// Turns the waves of a tag in column i.
void turn(TagState& state, const MarchBed& bed, int i, const std::vector<float>& log_speed,
          const DirectionBins& bins, const std::vector<float>& edge_tangents,
          const std::vector<RowWays>& beside_land) {
    const int rows = bed.grid.rows;
    const auto speed = [&](int column, int j) {
        return read_table(log_speed, bed.refracting[bed.grid.index(column, j)]);
    };
    auto land = beside_land.begin();
    for (int j = 0; j < rows; ++j) {
        int before = i - 1, low = std::max(j - 1, 0), high = std::min(j + 1, rows - 1);
        if (land != beside_land.end() && land->row == j) {
            if (!land->ways.before) before = i;
            if (!land->ways.below) low = j;
            if (!land->ways.above) high = j;
            ++land;
        }
        const float along = speed(i, j) - speed(before, j);
        const float across =
            high > low ? (speed(i, high) - speed(i, low)) / static_cast<float>(high - low) : 0.0f;
        if (along == 0.0f && across == 0.0f) continue;
        turn_row(&state.next[at(j)], at(rows), bins, along, across, edge_tangents);
    }
}

/// Sums the bins of each row.
void sum_bins(TagState& state, const std::vector<BinShift>& shifts) {
    const std::size_t rows = state.energy.size();
    std::fill(state.energy.begin(), state.energy.end(), 0.0f);
    std::fill(state.along.begin(), state.along.end(), 0.0f);
    for (std::size_t n = 0; n < shifts.size(); ++n) {
        const float* const flux = &state.flux[n * rows];
        for (std::size_t j = 0; j < rows; ++j) {
            state.energy[j] += flux[j] * shifts[n].over_cosine;
            state.along[j] += flux[j];
        }
    }
    for (float& energy : state.energy) energy /= state.open_energy;
}

TagState open_sea(const MarchWave& wave, const std::vector<BinShift>& shifts, const MarchBed& bed) {
    const int rows = bed.grid.rows;
    TagState state;
    const std::size_t size = shifts.size() * at(rows);
    state.flux.resize(size);
    state.next.resize(size);
    state.energy.resize(at(rows));
    state.along.resize(at(rows));
    for (std::size_t n = 0; n < shifts.size(); ++n) {
        const float flux = wave.bin_share[n] / shifts[n].over_cosine;
        std::fill_n(&state.flux[n * at(rows)], rows, flux);
        state.open_energy += flux * shifts[n].over_cosine;
    }
    for (std::size_t n = 0; n < bed.inflow.size(); ++n) state.flux[n] *= bed.inflow[n];
    return state;
}

/// The waves of one cell by band, before breaking: variance at the open sea's speed, and flux.
struct CellWaves {
    std::array<double, kShoreBands> variance{};
    double flux = 0.0;
};

/// Returns the share of the energy that breaking leaves on the way through a cell. The open sea's
/// own breaking, which its wind compensates, does not count. In each part of the way energy decays
/// as in saturated surf, dF/dx = -a F^(5/2), which has a closed form and stays positive for any a.
double left_by_breaking(const CellWaves& waves, double share, double open_dissipation,
                        const MarchBed& bed, std::size_t cell, const DepthTables& depths) {
    const double step = bed.grid.cell / kMarchParts;
    double left = 1.0;
    for (std::size_t part = 0; part < kMarchParts; ++part) {
        double own = 0.0;
        for (int b = 0; b < kShoreBands; ++b) {
            own += waves.variance[at(b)] *
                   double{read_table(depths.band(b).shoaling, bed.position[cell][part])};
        }
        own *= left;
        if (!(own > 1e-12)) return left;
        const double dissipation =
            breaking_dissipation(std::sqrt(8.0 * own / share), double{bed.depth[cell][part]},
                                 depths.peak_frequency()) -
            open_dissipation;
        const double loss = std::max(dissipation, 0.0) * share * step / (waves.flux * left);
        left *= std::pow(1.0 + 1.5 * loss, -2.0 / 3.0);
    }
    return left;
}

/// The state of a march between two columns.
struct March {
    const MarchGroup& group;
    const DirectionBins& bins;
    const MarchBed& bed;
    const DepthTables& depths;
    std::vector<BinShift> shifts{};
    std::vector<float> edge_tangents{};  // tan(theta) at the edges of bins
    std::vector<TagState> states{};
    std::vector<float> kept{};  // share of each row's energy that leaves the column

    const std::vector<float>& shoaling(int tag) const {
        return depths.band(group.waves[at(tag)].band).shoaling;
    }
};

March start(const MarchGroup& group, const DirectionBins& bins, const MarchBed& bed,
            const DepthTables& depths) {
    March march{group, bins, bed, depths};
    march.shifts = bin_shifts(bins, bed.grid.cell);
    for (int n = 0; n <= bins.count; ++n) {
        march.edge_tangents.push_back(static_cast<float>(std::tan(bins.edge(n))));
    }
    for (const MarchWave& wave : group.waves) {
        march.states.push_back(open_sea(wave, march.shifts, bed));
    }
    march.kept.assign(at(bed.grid.rows), 1.0f);
    return march;
}

/// Moves one tag to column i; column 0 has the open sea's waves.
void advance(March& march, int tag, int i, const std::vector<RowWays>& beside_land) {
    TagState& state = march.states[at(tag)];
    if (i > 0) {
        shift_across(state, march.shifts, march.kept);
        shift_past_land(state, march.shifts, beside_land);
        turn(state, march.bed, i, march.depths.band(march.group.waves[at(tag)].band).log_speed,
             march.bins, march.edge_tangents, beside_land);
        std::swap(state.flux, state.next);
    }
    sum_bins(state, march.shifts);
}

/// Returns the waves that arrive at row j of a column.
CellWaves waves_of(const March& march, int j) {
    CellWaves waves;
    for (std::size_t tag = 0; tag < march.states.size(); ++tag) {
        const MarchWave& wave = march.group.waves[tag];
        waves.variance[at(wave.band)] += wave.variance * double{march.states[tag].energy[at(j)]};
        waves.flux += wave.variance * double{march.states[tag].along[at(j)]} *
                      march.depths.band(wave.band).open_group_speed;
    }
    return waves;
}

}  // namespace

MarchField march_group(const MarchGroup& group, const DirectionBins& bins, const MarchBed& bed,
                       const DepthTables& depths, const MarchLoss& loss, ThreadPool& pool,
                       const std::function<void()>& column_done) {
    const MarchGrid& grid = bed.grid;
    const int tags = static_cast<int>(group.waves.size());
    March march = start(group, bins, bed, depths);
    MarchField field;
    field.unshoaled.resize(grid.size());
    field.energy.assign(at(tags), std::vector<float>(grid.size()));
    double open_variance = 0.0;
    for (const MarchWave& wave : group.waves) open_variance += wave.variance;
    const double open_dissipation =
        kMadeGood * breaking_dissipation(std::sqrt(8.0 * loss.open_variance), depths.max_depth(),
                                         depths.peak_frequency());
    for (int i = 0; i < grid.columns; ++i) {
        const std::vector<RowWays> beside_land = rows_beside_land(bed, i);
        pool.for_each_item(tags, [&](int tag, int) { advance(march, tag, i, beside_land); });
        for (int j = 0; j < grid.rows; ++j) {
            const std::size_t cell = grid.index(i, j);
            const CellWaves waves = waves_of(march, j);
            const double share = loss.own_share.empty() ? 1.0 : double{loss.own_share[cell]};
            const double left =
                loss.breaking && i > 0
                    ? left_by_breaking(waves, share, open_dissipation, bed, cell, depths)
                    : 1.0;
            const double unshoaled =
                std::accumulate(waves.variance.begin(), waves.variance.end(), 0.0);
            field.unshoaled[cell] = static_cast<float>(unshoaled * left / open_variance);
            const auto here = static_cast<float>(left);
            for (int tag = 0; tag < tags; ++tag) {
                field.energy[at(tag)][cell] = march.states[at(tag)].energy[at(j)] * here *
                                              read_table(march.shoaling(tag), bed.place[cell]);
            }
            march.kept[at(j)] = here;
        }
        column_done();
    }
    return field;
}

}  // namespace ocean
