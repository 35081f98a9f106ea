// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "sky.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "projection.hpp"

namespace ocean::preview {
namespace {

/// Returns the thickness of the air on the way to the sun, in units of the zenith's [Kasten and
/// Young 1989] eq. 3.
double air_mass(double altitude) {
    const double h = std::max(0.0, altitude);
    return 1.0 / (std::sin(kRadians * h) + 0.50572 * std::pow(h + 6.07995, -1.6364));
}

/// Returns the light of the sky with the sun at an altitude [degrees], over that with the sun on
/// the horizon: 1 by day, the ratio of illuminances below the horizon. log10 of an illuminance [lx]
/// is a cubic polynomial of the altitude in right angles [Seidelmann 1992] p. 491.
double twilight(double altitude) {
    struct Piece {
        double above;
        std::array<double, 4> of;
    };
    static constexpr std::array<Piece, 4> kPieces{{
        {-0.8, {2.88, 22.26, -207.64, 1034.30}},
        {-5.0, {2.88, 21.81, -258.11, -858.36}},
        {-12.0, {2.70, 12.17, -431.69, -1899.83}},
        {-1e9, {13.84, 262.72, 1447.42, 2797.93}},
    }};
    if (altitude >= 0.0) return 1.0;
    const Piece& piece =
        *std::ranges::find_if(kPieces, [&](const Piece& p) { return altitude > p.above; });
    const double h = std::max(altitude, -18.0) / 90.0;
    const auto& [a, b, c, d] = piece.of;
    return std::pow(10.0, a + h * (b + h * (c + h * d)) - 2.88);
}

/// Returns the sky of an environment that is turned about the zenith [degrees].
Sky environment_sky(const Environment& environment, double turn) {
    Sky sky{};
    const double turned = turn / 360.0;
    sky.mapped = 1.0f;
    sky.turn = static_cast<float>(turned - std::floor(turned));
    sky.light = glm::vec3(environment.light[0], environment.light[1], environment.light[2]);
    sky.sun_direction = glm::vec3(0.0f, 0.0f, 1.0f);
    if (environment.sun) {
        const auto& [direction, colour] = *environment.sun;
        const double c = std::cos(kRadians * turn), s = std::sin(kRadians * turn);
        sky.sun_direction = glm::vec3(c * direction[0] - s * direction[1],
                                      s * direction[0] + c * direction[1], direction[2]);
        sky.sun_colour = glm::vec3(colour[0], colour[1], colour[2]);
        sky.sun_shown = 1.0f;
    }
    return sky;
}

/// Returns the radiance of the computed sky above the horizon, as sky() of
/// shaders/preview/sky.glsl, without the aureole of a few degrees about the sun, which is less than
/// 1 % of the light.
glm::vec3 radiance(const Sky& sky, const glm::vec3& direction) {
    const auto part = [&](float from, float width) {
        return std::clamp((direction.z - from) / width, 0.0f, 1.0f);
    };
    glm::vec3 colour = glm::mix(sky.low, 0.5f * (sky.low + sky.middle), part(0.0f, 0.0667f));
    colour = glm::mix(colour, 0.75f * sky.middle + 0.25f * sky.high, part(0.0667f, 0.2f));
    colour = glm::mix(colour, sky.high, part(0.2667f, 0.3444f));
    colour = glm::mix(colour, 0.7f * sky.high, part(0.6111f, 0.3889f));
    const float toward = glm::dot(direction, sky.sun_direction);
    colour = glm::mix(colour, sky.shadow, 0.85f * sky.dusk * (0.5f - 0.5f * toward));
    const float glow = 0.3f * std::pow(std::max(toward, 0.0f), 16.0f);
    return glm::mix(colour, (1.0f + 0.6f * glow) * sky.sun_colour, glow);
}

/// Returns the radiance of a level white surface under the sky: the mean over directions weighted
/// by their cosine, so that squares of the sine of the elevation are uniform.
glm::vec3 light_of(const Sky& sky) {
    constexpr int kUp = 16, kAround = 24;
    glm::vec3 sum(0.0f);
    for (int i = 0; i < kUp; ++i) {
        const float up = std::sqrt((static_cast<float>(i) + 0.5f) / kUp);
        const float level = std::sqrt(1.0f - up * up);
        for (int k = 0; k < kAround; ++k) {
            const float around =
                2.0f * static_cast<float>(kPi) * (static_cast<float>(k) + 0.5f) / kAround;
            sum += radiance(sky, {level * std::cos(around), level * std::sin(around), up});
        }
    }
    return sum / static_cast<float>(kUp * kAround);
}

Sky computed_sky(double sun_altitude, double sun_bearing) {
    const double up = kRadians * sun_altitude;
    const double around = kRadians * sun_bearing;
    const auto day = static_cast<float>(std::clamp(sun_altitude / 25.0, 0.0, 1.0));
    const auto dim = static_cast<float>(twilight(sun_altitude));
    const double air = air_mass(sun_altitude);
    const auto between = [&](glm::vec3 dusk, glm::vec3 noon) {
        return dim * glm::mix(dusk, noon, day);
    };
    Sky sky{};
    sky.sun_direction =
        glm::vec3(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up));
    sky.sun_colour =
        glm::vec3(std::exp(-0.09 * air), std::exp(-0.14 * air), std::exp(-0.27 * air)) * 2.2f * dim;
    sky.sun_shown = static_cast<float>(std::clamp((sun_altitude + 0.83) / 0.53, 0.0, 1.0));
    sky.low = between({0.80f, 0.52f, 0.34f}, {0.64f, 0.73f, 0.80f});
    sky.middle = between({0.42f, 0.40f, 0.46f}, {0.36f, 0.53f, 0.74f});
    sky.high = between({0.10f, 0.15f, 0.30f}, {0.10f, 0.23f, 0.52f});
    sky.shadow = dim * glm::vec3(0.20f, 0.22f, 0.30f);
    sky.dusk = static_cast<float>(std::clamp(1.0 - sun_altitude / 6.0, 0.0, 1.0));
    sky.light = light_of(sky);
    return sky;
}

}  // namespace

Sky make_sky(const Look& look) {
    return look.environment ? environment_sky(*look.environment, look.environment_turn)
                            : computed_sky(look.sun_altitude, look.sun_bearing);
}

}  // namespace ocean::preview
