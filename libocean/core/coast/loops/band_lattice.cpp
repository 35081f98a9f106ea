// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Which modes belong to a pair, and how large a map they need; see band_lattice.hpp.
#include "coast/loops/band_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <tuple>

#include "ocean/internal/grid.hpp"

namespace ocean {

namespace {

constexpr int kSmallestSide = 16;
constexpr int kSamplesPerReach = 6;

double eighth_power(double x) {
    const double x4 = x * x * x * x;
    return x4 * x4;
}

double power_of(const BandMode& mode) {
    return std::norm(std::complex<double>(mode.amplitude));
}

/// Calls body(pair, n, m, cascade, index) for each mode that has an amplitude and belongs to a
/// pair; (n, m) on the patch's own lattice.
template <typename Body>
void for_each_mode(const Modes& modes, const ShoreBands& bands, const Body& body) {
    const double step = modes.lattice.wavenumber_step();
    for (const CascadeModes& cascade : modes.cascades) {
        const int size = cascade.lattice.resolution;
        for (int m = -size / 2; m < size / 2; ++m) {
            for (int n = -size / 2; n < size / 2; ++n) {
                const std::size_t at = mode_index(n, m, size);
                if (cascade.h0[at] == 0.0f) continue;
                const int pair =
                    band_sector_of(bands, step, n * cascade.divisor, m * cascade.divisor);
                if (pair >= 0) {
                    body(static_cast<std::size_t>(pair), n * cascade.divisor, m * cascade.divisor,
                         cascade, at);
                }
            }
        }
    }
}

/// The power of the modes of a pair by their index along one axis.
class PowerAlong {
  public:
    PowerAlong(std::span<const BandMode> modes, std::size_t axis) {
        const auto index = [axis](const BandMode& mode) { return axis == 0 ? mode.n : mode.m; };
        const auto [low, high] = std::minmax_element(
            modes.begin(), modes.end(),
            [&](const BandMode& a, const BandMode& b) { return index(a) < index(b); });
        first_ = index(*low);
        power_.resize(static_cast<std::size_t>(index(*high) - first_ + 1));
        for (const BandMode& mode : modes) {
            power_[static_cast<std::size_t>(index(mode) - first_)] += power_of(mode);
        }
    }

    int first() const { return first_; }
    int last() const { return first_ + static_cast<int>(power_.size()) - 1; }

    /// Returns the squared error of a spline of `side` samples through waves about a carrier: the
    /// two largest aliases of n waves, (n / (R - n))^8 + (n / (R + n))^8, see spline_map.hpp.
    double spline_error(int carrier, int side) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < power_.size(); ++i) {
            const double n = std::abs(first_ + static_cast<int>(i) - carrier);
            sum += power_[i] * (eighth_power(n / (side - n)) + eighth_power(n / (side + n)));
        }
        return sum;
    }

    /// Returns the carrier about which spline_error is least on a side much longer than the waves
    /// reach. The sum of |n|^8 is convex: it falls up to that carrier and rises beyond it.
    int best_carrier() const {
        int low = first();
        int high = last();
        while (low < high) {
            const int middle = low + (high - low) / 2;
            (eighth_moment(middle + 1) < eighth_moment(middle) ? low = middle + 1 : high = middle);
        }
        return low;
    }

  private:
    double eighth_moment(int carrier) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < power_.size(); ++i) {
            sum += power_[i] * eighth_power(first_ + static_cast<int>(i) - carrier);
        }
        return sum;
    }

    int first_ = 0;
    std::vector<double> power_;
};

void set_carrier(BandLattice& band) {
    if (band.modes.empty()) return;
    for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
        const PowerAlong power(band.modes, axis);
        const int carrier = power.best_carrier();
        band.carrier[axis] = carrier;
        band.reach[axis] = std::max(power.last() - carrier, carrier - power.first());
    }
    for (BandMode& mode : band.modes) {
        mode.n -= band.carrier[0];
        mode.m -= band.carrier[1];
    }
}

/// If all modes lie on a coarser lattice, as a cascade's do, switches to that lattice.
void make_coarse(BandLattice& band) {
    int divisor = 0;
    for (const BandMode& mode : band.modes) divisor = std::gcd(std::gcd(divisor, mode.n), mode.m);
    if (divisor <= 1) return;
    band.period /= divisor;
    for (BandMode& mode : band.modes) {
        mode.n /= divisor;
        mode.m /= divisor;
    }
}

}  // namespace

int band_sector_of(const ShoreBands& bands, double step, int n, int m) {
    const double x = n;
    const double y = m;
    const int band = bands.band_of(step * std::sqrt(x * x + y * y));
    return band < 0 ? -1 : bands.find(band, ShoreBands::sector_of(std::atan2(y, x)));
}

std::vector<BandLattice> gather_bands(const Modes& modes, const ShoreBands& bands) {
    std::vector<BandLattice> lattices(bands.waves.size());
    for_each_mode(modes, bands,
                  [&](std::size_t pair, int n, int m, const CascadeModes& cascade, std::size_t at) {
                      const double rate = static_cast<double>(cascade.rate_high[at]) +
                                          static_cast<double>(cascade.rate_low[at]);
                      lattices[pair].modes.push_back({n, m, 2.0f * cascade.h0[at], rate});
                  });
    for (BandLattice& band : lattices) {
        band.period = modes.lattice.period;
        make_coarse(band);
        set_carrier(band);
        std::stable_sort(band.modes.begin(), band.modes.end(),
                         [](const BandMode& a, const BandMode& b) {
                             return std::tie(a.m, a.n) < std::tie(b.m, b.n);
                         });
    }
    return lattices;
}

double spline_gain(int n, int side) {
    if (n == 0) return 1.0;
    const double half = kPi * n / side;
    return std::pow(half / std::sin(half), 4.0);
}

namespace {

/// One side of the map of a pair on its way to its final size.
struct GrowingSide {
    PowerAlong power;
    int side;
    double error;       // squared error [m^2]
    double next_error;  // squared error with twice the samples

    GrowingSide(const BandLattice& band, std::size_t axis)
        : power(band.modes, axis), side(kSmallestSide) {
        while (side < kSamplesPerReach * band.reach[axis] && side < kMaxResolution) side *= 2;
        measure();
    }
    void grow() {
        side *= 2;
        measure();
    }

  private:
    void measure() {
        error = power.spline_error(0, side);
        next_error = power.spline_error(0, 2 * side);
    }
};

}  // namespace

std::vector<std::array<int, 2>> choose_sides(std::span<const BandLattice> bands, double tolerance) {
    struct Growing {
        std::size_t pair;
        std::array<GrowingSide, 2> along;
    };
    std::vector<Growing> maps;
    double power = 0.0;
    double error = 0.0;
    for (std::size_t i = 0; i < bands.size(); ++i) {
        if (bands[i].modes.empty()) continue;
        for (const BandMode& mode : bands[i].modes) power += power_of(mode);
        maps.push_back({i, {GrowingSide(bands[i], 0), GrowingSide(bands[i], 1)}});
        error += maps.back().along[0].error + maps.back().along[1].error;
    }
    // The next side to be doubled is the one whose error falls most per added sample.
    while (error > tolerance * tolerance * power) {
        GrowingSide* best = nullptr;
        double best_gain = 0.0;
        for (Growing& map : maps) {
            const double samples = static_cast<double>(map.along[0].side) * map.along[1].side;
            for (GrowingSide& side : map.along) {
                const double gain = (side.error - side.next_error) / samples;
                if (side.side >= kMaxResolution || gain <= best_gain) continue;
                best = &side;
                best_gain = gain;
            }
        }
        if (best == nullptr) break;
        error += best->next_error - best->error;
        best->grow();
    }
    std::vector<std::array<int, 2>> sides(bands.size(), {kSmallestSide, kSmallestSide});
    for (const Growing& map : maps) sides[map.pair] = {map.along[0].side, map.along[1].side};
    return sides;
}

}  // namespace ocean
