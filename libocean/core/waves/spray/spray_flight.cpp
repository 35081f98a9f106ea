// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Drops in the air; see spray_flight.hpp.
#include "waves/spray/spray_flight.hpp"

#include <algorithm>
#include <cmath>

#include "ocean/internal/grid.hpp"
#include "waves/spectrum/wave_system_table.hpp"

namespace ocean {

SprayAir spray_air(const Parameters& parameters) {
    SprayAir air{0.0, 0.0, parameters.water.gravity};
    for (const WaveSystem& system : parameters.waves) {
        const double wind = system.wind_above().value_or(0.0);
        if (wind <= air.wind_speed) continue;
        const bool as_measured =
            system.spectrum == SpectrumKind::measured && system.measured && !system.wind_direction;
        const double degrees =
            as_measured ? natural_measured_scale(system).direction : system.direction_degrees();
        air.wind_speed = wind;
        air.direction = degrees * kPi / 180.0;
    }
    return air;
}

// Returns the friction velocity [m/s] by [Large and Pond 1981] eq. 19: 10^3 C_d = 1.2 for 4 <= U10
// < 11 m/s, 0.49 + 0.065 U10 up to 25 m/s. C_d is constant beyond both ends: below there is no
// spume, above the drag is known to saturate.
double friction_velocity(double wind_speed) {
    const double drag = 1e-3 * std::max(1.2, 0.49 + 0.065 * std::min(wind_speed, 25.0));
    return wind_speed * std::sqrt(drag);
}

// The logarithmic profile of neutral air, U(z) = U10 - (u*/kappa) ln(10 m/z), at z = 1 m.
double crest_wind(double wind_speed) {
    constexpr double kKarman = 0.4;
    return wind_speed - friction_velocity(wind_speed) / kKarman * std::log(10.0);
}

// Spume needs a wind above 7 to 11 m/s [Veron 2015].
double spume_onset(double wind_speed) {
    return std::clamp((wind_speed - 7.0) / (11.0 - 7.0), 0.0, 1.0);
}

// Returns the radius at birth [m] of a drop, for a uniform number. [Andreas 1998] eq. 3.5, with r =
// r80 in um: the flux of spume drops is proportional to r^-1 for 10 <= r < 37.5, r^-2.8 up to 100
// and r^-8 up to 250. By volume, times r^3: r^2, r^0.2 and r^-5, whose integral is inverted here.
// r80 = 0.518 r0^0.976 is the radius in air of 80 % humidity, r0 the radius at birth: 21 to 560 um,
// half of the water below 108 um. Test: Spray.TheSizesOfDropsAreThoseOfAndreas.
double spume_radius(double uniform) {
    struct Piece {
        double from, to, factor, power;  // factor r^power, continuous
        double antiderivative(double r) const {
            return factor * std::pow(r, power + 1.0) / (power + 1.0);
        }
        double integral() const { return antiderivative(to) - antiderivative(from); }
    };
    static const Piece kPieces[] = {
        {10.0, 37.5, 1.0, 2.0},
        {37.5, 100.0, std::pow(37.5, 1.8), 0.2},
        {100.0, 250.0, std::pow(37.5, 1.8) * std::pow(100.0, 5.2), -5.0}};
    static const double kTotal =
        kPieces[0].integral() + kPieces[1].integral() + kPieces[2].integral();
    double left = uniform * kTotal;
    double r80 = kPieces[2].to;
    for (const Piece& piece : kPieces) {
        if (left < piece.integral()) {
            const double power = piece.power + 1.0;
            const double value = piece.antiderivative(piece.from) + left;
            r80 = std::clamp(std::pow(value * power / piece.factor, 1.0 / power), piece.from,
                             piece.to);
            break;
        }
        left -= piece.integral();
    }
    return 1e-6 * std::pow(r80 / 0.518, 1.0 / 0.976);
}

// Stokes' tau = 2 rho_w r^2 / (9 mu) over the factor 1 + 0.15 Re^0.687 of [Schiller and Naumann
// 1933] at the speed of the fall itself, v = g tau, Re = 2 r v / nu, valid for Re < 1000: v is 0.70
// m/s at r = 100 um, 3.9 m/s at 500 um, within 5 % of measurements [Gunn and Kinzer 1949]. Proved
// by Spray.DropsFallAsFastAsMeasured.
double response_time(double radius, double gravity) {
    constexpr double kWater = 1000.0;       // kg/m^3
    constexpr double kViscosity = 1.81e-5;  // Pa s, of air at 20 degrees
    constexpr double kAir = 1.204;          // kg/m^3
    const double stokes = 2.0 * kWater * radius * radius / (9.0 * kViscosity);
    double response = stokes;
    for (int i = 0; i < 24; ++i) {  // each step at least halves the error
        const double reynolds = 2.0 * radius * gravity * response * kAir / kViscosity;
        const double next = stokes / (1.0 + 0.15 * std::pow(reynolds, 0.687));
        response = 0.5 * (response + next);
    }
    return response;
}

// The solution of v' = -(v - w)/tau: v = w + (v0 - w) e, x = x0 + w a + (v0 - w) tau (1 - e), e =
// exp(-a/tau), with the drift w. With tau -> infinity the drop is thrown, with tau -> 0 it follows
// the air.
SprayParticle particle_at(const SprayBirth& birth, double age) {
    const double left = std::exp(-age / birth.response);
    const double reach = -birth.response * std::expm1(-age / birth.response);
    Vector3 place, velocity;
    for (std::size_t c = 0; c < 3; ++c) {
        const double excess = birth.velocity[c] - birth.drift[c];
        place[c] = birth.place[c] + birth.drift[c] * age + excess * reach;
        velocity[c] = birth.drift[c] + excess * left;
    }
    return {birth.id,    place[0],    place[1], place[2],   velocity[0],
            velocity[1], velocity[2], age,      birth.life, birth.radius};
}

// Diffusion by continuous movements [Taylor 1922] whose velocity, of deviation s, decorrelates as
// exp(-t/T): the deviation of a puff from one point is s t at first and s sqrt(2 T t) in the end. T
// is the time scale of large eddies at the height where mist hangs, kappa z/s with z = 2.5 m.
MistPuff puff_at(const SprayBirth& birth, double age, double lifetime) {
    constexpr double kEddy = 0.4 * 2.5;  // m
    constexpr double kBornWide = 0.5;    // [m]: size of the water that a gust tears off
    double deviation = kBornWide;
    if (birth.mixing > 0.0) {
        const double memory = kEddy / birth.mixing;
        const double spread = 2.0 * kEddy * kEddy * (age / memory + std::expm1(-age / memory));
        deviation = std::sqrt(kBornWide * kBornWide + spread);
    }
    const double gone = age / lifetime;
    const double left = 1.0 - gone * gone;
    return {birth.place[0] + birth.gust[0] * age, birth.place[1] + birth.gust[1] * age,
            birth.place[2] + birth.gust[2] * age, deviation, left * left};
}

// z is concave or convex for all ages, so that it crosses its level downwards at most once before
// its minimum.
double life_of(const SprayBirth& birth, double lifetime) {
    const double level = std::min(0.0, birth.place[2]);
    const double excess = birth.velocity[2] - birth.drift[2];
    const auto is_above = [&](double age) {
        const double reach = -birth.response * std::expm1(-age / birth.response);
        return birth.place[2] + birth.drift[2] * age + excess * reach >= level;
    };
    double end = lifetime;
    if (excess < 0.0 && birth.drift[2] > 0.0) {
        end = std::clamp(birth.response * std::log(-excess / birth.drift[2]), 0.0, lifetime);
    }
    if (is_above(end)) return lifetime;
    double above = 0.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (above + end);
        (is_above(middle) ? above : end) = middle;
    }
    return above;
}

}  // namespace ocean
