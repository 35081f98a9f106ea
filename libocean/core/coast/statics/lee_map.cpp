// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Calm water behind narrow walls: see lee_map.hpp.
#include "lee_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>

#include "march_land.hpp"
#include "shore_blend.hpp"

namespace ocean {
namespace {

constexpr int kStencil = 4;  // samples along a side from which QuadGrid reads a place

/// One axis of a square: the sample before a place, and the weight of the sample behind it.
struct Axis {
    int first;
    float share, slope;

    Axis(double place, int samples, double per_metre)
        : first(std::clamp(static_cast<int>(place), 0, std::max(samples - 2, 0))) {
        const auto t = static_cast<float>(std::clamp(place - first, 0.0, 1.0));
        share = t * t * (3.0f - 2.0f * t);
        slope = static_cast<float>(per_metre) * 6.0f * t * (1.0f - t);
    }
};

/// The maps of energy as seen from places beside walls.
class Surroundings {
  public:
    Surroundings(const MarchLand& land, const EnergyMaps& maps, const QuadGrid& heights)
        : land_(land), maps_(maps), heights_(heights), has_shore_(maps.domain.count()) {
        const Domain& bed = land.domain();
        for (int j = 0; j < bed.samples[1]; ++j) {
            for (int i = 0; i < bed.samples[0]; ++i) {
                if (land.is_shore(i, j)) {
                    has_shore_[nearest_sample(maps.domain, bed.place(i, j))] = 1;
                }
            }
        }
    }

    /// Returns true if land separates the water among the samples about a cell of the maps.
    bool is_parted(int i, int j) const {
        std::array<int, kStencil * kStencil> group{};
        bool has_shore = false;
        for (int n = 0; n < kStencil * kStencil; ++n) {
            has_shore = has_shore || has_shore_[index(i, j, n)] != 0;
        }
        if (!has_shore) return false;
        for (int n = 0; n < kStencil * kStencil; ++n) {
            const std::size_t own = index(i, j, n);
            group[at(n)] = is_land(own) ? -1 : n;
        }
        // Neighbouring samples that see each other belong to one group.
        for (bool changed = true; changed;) {
            changed = false;
            for (int n = 0; n < kStencil * kStencil; ++n) {
                for (const int step : {1, kStencil, kStencil + 1, kStencil - 1}) {
                    changed = join(i, j, n, step, group) || changed;
                }
            }
        }
        int first = -1;
        for (const int g : group) {
            if (g < 0) continue;
            if (first >= 0 && g != first) return true;
            first = g;
        }
        return false;
    }

    /// Returns the factor by which the waves at a place in water are lower than in the maps. The
    /// place has the waves of the samples about it that no land separates from it; without such
    /// samples it is calm.
    float height_share(const std::array<double, 2>& place) const {
        const Domain& domain = maps_.domain;
        const double u = (place[0] - domain.origin[0]) / domain.step(0);
        const double v = (place[1] - domain.origin[1]) / domain.step(1);
        const int i = std::clamp(static_cast<int>(u), 0, std::max(domain.samples[0] - 2, 0));
        const int j = std::clamp(static_cast<int>(v), 0, std::max(domain.samples[1] - 2, 0));
        double sum = 0.0, heights = 0.0;
        bool is_parted = false;
        for (int n = 0; n < kStencil * kStencil; ++n) {
            const std::size_t sample = index(i, j, n);
            const std::size_t source = maps_.source.empty() ? sample : maps_.source[sample];
            if (land_.parts(place, place_of(source))) {
                is_parted = true;
                continue;
            }
            const double x = u - (i + n % kStencil - 1), y = v - (j + n / kStencil - 1);
            const double weight = std::max(2.0 - std::hypot(x, y), 1e-3);
            sum += weight;
            heights += weight * double{maps_.rms_height[sample]};
        }
        if (!is_parted) return 1.0f;
        const double shown = std::abs(double{heights_.read(place[0], place[1]).value[0]});
        const double seen = sum > 0.0 ? heights / sum : 0.0;
        return shown > seen ? static_cast<float>(seen / shown) : 1.0f;
    }

  private:
    static std::size_t at(int n) { return static_cast<std::size_t>(n); }
    std::size_t index(int i, int j, int n) const {
        const Domain& domain = maps_.domain;
        const int x = std::clamp(i + n % kStencil - 1, 0, domain.samples[0] - 1);
        const int y = std::clamp(j + n / kStencil - 1, 0, domain.samples[1] - 1);
        return at(y) * at(domain.samples[0]) + at(x);
    }
    std::array<double, 2> place_of(std::size_t sample) const {
        const int columns = maps_.domain.samples[0];
        return maps_.domain.place(static_cast<int>(sample) % columns,
                                  static_cast<int>(sample) / columns);
    }
    bool is_land(std::size_t sample) const { return land_.is_land(place_of(sample)); }
    bool join(int i, int j, int n, int step, std::array<int, kStencil * kStencil>& group) const {
        const int other = n + step;
        if (other >= kStencil * kStencil) return false;
        if (std::abs(other % kStencil - n % kStencil) > 1) return false;  // sample of another row
        if (group[at(n)] < 0 || group[at(other)] < 0 || group[at(n)] == group[at(other)]) {
            return false;
        }
        const std::size_t a = index(i, j, n), b = index(i, j, other);
        if (a != b && land_.parts(place_of(a), place_of(b))) return false;
        group[at(n)] = group[at(other)] = std::min(group[at(n)], group[at(other)]);
        return true;
    }

    const MarchLand& land_;
    const EnergyMaps& maps_;
    const QuadGrid& heights_;
    std::vector<std::uint8_t> has_shore_;  // shore in the bed nearest to each sample
};

using Samples = std::vector<std::array<float, 2>>;

/// Writes the factor of the heights for water in the cells of the maps that land divides.
void write_heights(const MarchLand& land, const EnergyMaps& maps, const QuadGrid& heights,
                   Samples& samples) {
    const Surroundings around(land, maps, heights);
    const Domain& bed = land.domain();
    const Domain& domain = maps.domain;
    const auto first_in = [&](int cell, std::size_t axis) {
        const double sample = cell * domain.step(axis) / bed.step(axis);
        return std::min(static_cast<int>(std::ceil(sample - 1e-9)), bed.samples[axis]);
    };
    for (int j = 0; j + 1 < domain.samples[1]; ++j) {
        for (int i = 0; i + 1 < domain.samples[0]; ++i) {
            if (!around.is_parted(i, j)) continue;
            for (int y = first_in(j, 1); y < first_in(j + 1, 1); ++y) {
                for (int x = first_in(i, 0); x < first_in(i + 1, 0); ++x) {
                    const std::array<double, 2> place = bed.place(x, y);
                    if (land.is_land(place)) continue;
                    samples[nearest_sample(bed, place)][0] = around.height_share(place);
                }
            }
        }
    }
}

/// Writes the min share of the coast's surface for water near the border of the bed that is farther
/// from the border through the water than in a straight line.
void write_inside(const BedGrid& bed_height, double margin, Samples& samples) {
    const Domain& domain = bed_height.domain;
    const int columns = domain.samples[0], rows = domain.samples[1];
    const double cell = bed_height.cell();
    const auto index = [&](int i, int j) {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(i);
    };
    const auto is_water = [&](std::size_t n) {
        return passing(double{bed_height.values[n]}) > 0.0f;
    };
    using Reached = std::pair<float, std::uint32_t>;  // distance [m], sample
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
    std::vector<float> distance(domain.count(), std::numeric_limits<float>::infinity());
    const auto reach = [&](std::size_t n, float at) {
        if (at >= distance[n] || at >= static_cast<float>(margin) || !is_water(n)) return;
        distance[n] = at;
        next.emplace(at, static_cast<std::uint32_t>(n));
    };
    for (int j = 0; j < rows; ++j) {
        const int step = j == 0 || j == rows - 1 ? 1 : std::max(columns - 1, 1);
        for (int i = 0; i < columns; i += step) reach(index(i, j), 0.0f);
    }
    while (!next.empty()) {
        const auto [at, n] = next.top();
        next.pop();
        if (at > distance[n]) continue;
        const int i = static_cast<int>(n) % columns, j = static_cast<int>(n) / columns;
        for (int dj = -1; dj <= 1; ++dj) {
            for (int di = -1; di <= 1; ++di) {
                const int x = i + di, y = j + dj;
                if (x < 0 || x >= columns || y < 0 || y >= rows) continue;
                // Water connects by the sides of samples alone.
                if (di != 0 && dj != 0 && !is_water(index(x, j)) && !is_water(index(i, y))) {
                    continue;
                }
                const double way = cell * std::sqrt(static_cast<double>(di * di + dj * dj));
                reach(index(x, y), at + static_cast<float>(way));
            }
        }
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const std::size_t n = index(i, j);
            const double straight = cell * std::min({i, j, columns - 1 - i, rows - 1 - j});
            if (straight >= margin + 2.0 * cell || !is_water(n)) continue;
            const double way = double{distance[n]};
            if (way <= 1.1 * straight + 1.5 * cell) continue;
            samples[n][1] = shore_step(Plain(static_cast<float>(way / margin))).value();
        }
    }
}

/// Continues the numbers onto the land beside water: the lowest factor of waves, the highest share
/// of the coast.
void continue_beside_water(const BedGrid& bed_height, Samples& samples) {
    const Samples water = samples;
    const int columns = bed_height.domain.samples[0], rows = bed_height.domain.samples[1];
    const auto index = [&](int i, int j) {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(i);
    };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const std::size_t n = index(i, j);
            if (passing(double{bed_height.values[n]}) > 0.0f) continue;
            for (int y = std::max(j - 1, 0); y <= std::min(j + 1, rows - 1); ++y) {
                for (int x = std::max(i - 1, 0); x <= std::min(i + 1, columns - 1); ++x) {
                    samples[n][0] = std::min(samples[n][0], water[index(x, y)][0]);
                    samples[n][1] = std::max(samples[n][1], water[index(x, y)][1]);
                }
            }
        }
    }
}

}  // namespace

LeeSample LeeMap::at(double x, double y) const {
    LeeSample result;
    if (is_empty()) return result;
    const double per_metre = 1.0 / domain_.step(0);
    const double u = (x - domain_.origin[0]) * per_metre;
    const double v = (y - domain_.origin[1]) * per_metre;
    if (!(u >= 0.0 && v >= 0.0 && u <= domain_.samples[0] - 1 && v <= domain_.samples[1] - 1)) {
        return result;
    }
    const Axis along_x(u, domain_.samples[0], per_metre);
    const Axis along_y(v, domain_.samples[1], per_metre);
    const auto columns = static_cast<std::size_t>(domain_.samples[0]);
    const std::size_t low =
        static_cast<std::size_t>(along_y.first) * columns + static_cast<std::size_t>(along_x.first);
    const auto field = [&](std::size_t f) {
        const float a = samples_[low][f], b = samples_[low + 1][f];
        const float c = samples_[low + columns][f], d = samples_[low + columns + 1][f];
        const float bottom = a + along_x.share * (b - a), top = c + along_x.share * (d - c);
        const float by_x = along_x.slope * ((b - a) + along_y.share * ((d - c) - (b - a)));
        return Jet(bottom + along_y.share * (top - bottom), by_x, along_y.slope * (top - bottom));
    };
    result.height = field(0);
    result.inside = field(1);
    return result;
}

LeeMap make_lee_map(const BedGrid& bed_height, const EnergyMaps& maps, const QuadGrid& heights,
                    double margin) {
    const MarchLand land(bed_height, maps.still);
    const Domain& domain = bed_height.domain;
    if (land.is_empty() || domain.samples[0] < 2 || domain.samples[1] < 2) return {};
    Samples samples(domain.count(), {1.0f, 0.0f});
    write_heights(land, maps, heights, samples);
    for (std::size_t n = 0; n < samples.size(); ++n) {
        if (maps.still.is_still(n)) samples[n][0] = 0.0f;
    }
    if (land.is_at_border()) write_inside(bed_height, margin, samples);
    continue_beside_water(bed_height, samples);
    const auto is_plain = [](const std::array<float, 2>& s) {
        return s[0] == 1.0f && s[1] == 0.0f;
    };
    if (std::ranges::all_of(samples, is_plain)) return {};
    return LeeMap(domain, std::move(samples));
}

}  // namespace ocean
