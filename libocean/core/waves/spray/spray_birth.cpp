// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Births of spray; see spray_birth.hpp.
#include "waves/spray/spray_birth.hpp"

#include <algorithm>
#include <cmath>

#include "wave/wave.hpp"

namespace ocean {
namespace {

constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15u;

/// The random numbers of one particle: SplitMix64 from its id on.
class Draws {
  public:
    explicit Draws(std::uint64_t id) : state_(id) {}

    /// Returns a number of [0, 1).
    double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
    /// Two standard normal numbers, of [Box and Muller 1958] eq. 1.
    struct Normals {
        double first, second;
    };
    Normals normals() {
        namespace formula = wave::double_precision;
        const std::uint64_t bits = next();
        const double radius =
            std::sqrt(2.0 * formula::minus_log_uniform(static_cast<std::uint32_t>(bits >> 32)));
        const auto angle =
            formula::sin_cos_turns(static_cast<double>(static_cast<std::uint32_t>(bits)) * 0x1p-32);
        return {radius * angle.cosine, radius * angle.sine};
    }

  private:
    std::uint64_t next() { return scramble(state_ += kGolden); }

    std::uint64_t state_;
};

/// Interpolation of maps between the four samples around a place.
class Place {
  public:
    /// Interpolates in a cell, at an offset from its centre of -1/2 .. 1/2 cells.
    Place(const Surface& map, std::size_t cell, double x, double y) : map_(map) {
        const Domain& domain = map.domain();
        const auto columns = static_cast<std::size_t>(domain.samples[0]);
        const auto rows = static_cast<std::size_t>(domain.samples[1]);
        const std::size_t i = cell % columns;
        const std::size_t j = cell / columns;
        const auto neighbour = [&](std::size_t k, double offset, std::size_t count) {
            if (domain.wraps) return (k + (offset < 0.0 ? count - 1 : 1)) % count;
            if (offset < 0.0) return k - std::min<std::size_t>(k, 1);
            return std::min(k + 1, count - 1);
        };
        const std::size_t i2 = neighbour(i, x, columns);
        const std::size_t j2 = neighbour(j, y, rows);
        corner_ = {j * columns + i, j * columns + i2, j2 * columns + i, j2 * columns + i2};
        const double u = std::abs(x);
        const double v = std::abs(y);
        weight_ = {(1.0 - u) * (1.0 - v), u * (1.0 - v), (1.0 - u) * v, u * v};
    }

    double operator()(Channel channel) const {
        const std::span<const float> values = map_.channel(channel);
        double sum = 0.0;
        for (std::size_t c = 0; c < 4; ++c) {
            sum += weight_[c] * static_cast<double>(values[corner_[c]]);
        }
        return sum;
    }

  private:
    const Surface& map_;
    std::array<std::size_t, 4> corner_;
    std::array<double, 4> weight_;
};

constexpr double kVerticalGust = 1.25;

/// Draws the gust that tears drops off forwards and upwards and then carries them. The deviation of
/// each component is that of neutral air near the ground, 2.39, 1.92 and 1.25 u* along, across and
/// up [Panofsky and Dutton 1984]; Gaussian and, along and up, its positive half. (The speed at
/// which spume leaves a crest has not been measured; it is thought to follow the wind [Veron 2015].
/// In a tank, drops in a wind of 10 m/s had -3 to 6 m/s upwards [Erinin 2022].)
Vector3 gust(const SprayAir& air, Draws& draws) {
    const double friction = friction_velocity(air.wind_speed);
    const Draws::Normals level = draws.normals();
    const double along = 2.39 * friction * std::abs(level.first);
    const double across = 1.92 * friction * level.second;
    const double up = kVerticalGust * friction * std::abs(draws.normals().first);
    const double c = std::cos(air.direction);
    const double s = std::sin(air.direction);
    return {along * c - across * s, along * s + across * c, up};
}

SprayBirth birth_of(const SprayTick& tick, const Surface& map, std::size_t cell, std::uint64_t id) {
    Draws draws(id);
    SprayBirth birth{};
    birth.id = id;
    birth.since = tick.step * draws.uniform();
    const double x = draws.uniform() - 0.5;
    const double y = draws.uniform() - 0.5;
    birth.radius = spume_radius(draws.uniform());
    birth.response = response_time(birth.radius, tick.air.gravity);

    // For a part of a step, the surface continues as at the tick.
    const Place place(map, cell, x, y);
    const Domain& domain = map.domain();
    const auto columns = static_cast<std::size_t>(domain.samples[0]);
    const auto along = [&](std::size_t axis, std::size_t index, double offset) {
        return domain.origin[axis] + (static_cast<double>(index) + offset) * domain.step(axis);
    };
    birth.velocity = {place(Channel::vx), place(Channel::vy), place(Channel::vz)};
    birth.place = {along(0, cell % columns, x) + place(Channel::dx),
                   along(1, cell / columns, y) + place(Channel::dy), place(Channel::height)};
    const Vector3 torn = gust(tick.air, draws);
    const double mean = crest_wind(tick.air.wind_speed);
    birth.gust = {mean * std::cos(tick.air.direction) + torn[0],
                  mean * std::sin(tick.air.direction) + torn[1], torn[2]};
    birth.mixing = kVerticalGust * friction_velocity(tick.air.wind_speed);
    birth.drift = birth.gust;
    birth.drift[2] -= tick.air.gravity * birth.response;
    for (std::size_t c = 0; c < 3; ++c) {
        birth.place[c] += birth.velocity[c] * birth.since;
        birth.velocity[c] += torn[c];
    }
    birth.life = life_of(birth, tick.lifetime);
    return birth;
}

/// Returns the mean number of particles of an event, so that on average a tick does not exceed its
/// share.
double wanted_of(const SprayTick& tick, double cell_area, std::size_t events) {
    const double each = tick.density * cell_area * spume_onset(tick.air.wind_speed);
    const double all = each * static_cast<double>(events);
    return all > tick.most ? each * tick.most / all : each;
}

}  // namespace

std::uint64_t scramble(std::uint64_t value) {
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9u;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBu;
    return value ^ (value >> 31);
}

std::uint64_t spray_id(std::uint32_t seed, std::int64_t tick, std::uint32_t cell,
                       std::uint32_t number) {
    const std::uint64_t moment =
        scramble(scramble(seed + kGolden) + static_cast<std::uint64_t>(tick) * kGolden);
    return scramble(moment ^ (std::uint64_t{cell} << 32 | number));
}

std::vector<std::uint8_t> white_cells(const Surface& map) {
    const std::span<const float> whitecap = map.channel(Channel::whitecap);
    std::vector<std::uint8_t> white(whitecap.size());
    std::ranges::transform(whitecap, white.begin(),
                           [](float w) { return static_cast<std::uint8_t>(w > kWhite); });
    return white;
}

std::vector<SprayBirth> births_of(const SprayTick& tick, const Surface& map,
                                  std::span<const std::uint8_t> white_before) {
    const std::span<const float> whitecap = map.channel(Channel::whitecap);
    std::vector<std::uint32_t> events;
    for (std::size_t cell = 0; cell < whitecap.size(); ++cell) {
        if (whitecap[cell] > kWhite && white_before[cell] == 0) {
            events.push_back(static_cast<std::uint32_t>(cell));
        }
    }
    const double cell_area = map.domain().step(0) * map.domain().step(1);
    const double wanted = wanted_of(tick, cell_area, events.size());
    constexpr std::uint32_t kNobody = 0xFFFFFFFFu;  // stands for no particle
    std::vector<SprayBirth> births;
    for (const std::uint32_t cell : events) {
        Draws draws(spray_id(tick.seed, tick.number, cell, kNobody));
        const auto count = static_cast<std::uint32_t>(wanted + draws.uniform());
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint64_t id = spray_id(tick.seed, tick.number, cell, k);
            const SprayBirth birth = birth_of(tick, map, cell, id);
            if (birth.life > 0.0) births.push_back(birth);
        }
    }
    births.shrink_to_fit();
    return births;
}

}  // namespace ocean
