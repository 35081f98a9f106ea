// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A photographed sun has the light of the whole sky in a few texels. Single facets would mirror
// them as sparks that come and go; so they become a direction and an irradiance, from which the
// glitter of all facets is computed, and the sky keeps the brightness of their surroundings.
#include "ocean/internal/preview/environment.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <string>

#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "projection.hpp"

namespace ocean::preview {
namespace {

constexpr double kDisc = 4.0 * kRadians;  // radius of a sun with the glare of a lens
constexpr double kSurroundings = 2.0;     // radius of the surroundings, in radii of the disc
constexpr double kCeiling = 4.0;          // brightness that is kept, in means of the surroundings
constexpr double kMinShare = 0.01;        // of all light, for a sun

/// Directions and solid angles of the texels.
class Texels {
  public:
    explicit Texels(const Environment& map)
        : width_(map.width),
          around_(kTwoPi / map.width),
          up_(0.5 * kPi / map.height),
          size_(std::max(around_, up_)) {}

    double size() const { return size_; }  // [rad], at the horizon
    glm::dvec3 direction(int i, int j) const {
        const double bearing = (0.5 * width_ - (i + 0.5)) * around_;
        const double elevation = (j + 0.5) * up_;
        return {std::cos(elevation) * std::cos(bearing), std::cos(elevation) * std::sin(bearing),
                std::sin(elevation)};
    }
    double solid_angle(int j) const {
        return around_ * (std::sin((j + 1) * up_) - std::sin(j * up_));
    }
    /// Returns the exact integral of the solid angle projected on the level.
    double level_solid_angle(int j) const {
        return solid_angle(j) * 0.5 * (std::sin((j + 1) * up_) + std::sin(j * up_));
    }

  private:
    int width_;
    double around_, up_, size_;
};

std::size_t texel(const Environment& map, int i, int j) {
    return 3 * (static_cast<std::size_t>(j) * static_cast<std::size_t>(map.width) +
                static_cast<std::size_t>(i));
}

glm::dvec3 colour(const Environment& map, int i, int j) {
    const std::size_t at = texel(map, i, j);
    return {map.rgb[at], map.rgb[at + 1], map.rgb[at + 2]};
}

const glm::dvec3 kLuminance(0.2126, 0.7152, 0.0722);  // of Rec. 709

double luminance(const glm::dvec3& rgb) {
    return glm::dot(rgb, kLuminance);
}

std::array<double, 3> as_array(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

glm::dvec3 level_light(const Environment& map, const Texels& texels) {
    glm::dvec3 sum(0.0);
    for (int j = 0; j < map.height; ++j) {
        glm::dvec3 row(0.0);
        for (int i = 0; i < map.width; ++i) row += colour(map, i, j);
        sum += texels.level_solid_angle(j) * row;
    }
    return sum / kPi;
}

glm::dvec3 brightest_direction(const Environment& map, const Texels& texels) {
    double most = -1.0;
    int at_i = 0, at_j = 0;
    for (int j = 0; j < map.height; ++j) {
        for (int i = 0; i < map.width; ++i) {
            const double here = luminance(colour(map, i, j));
            if (here <= most) continue;
            most = here;
            at_i = i;
            at_j = j;
        }
    }
    return texels.direction(at_i, at_j);
}

/// Calls `visit` for each texel between two angles [rad] from a direction.
template <typename Visit>
void visit_around(const Environment& map, const Texels& texels, const glm::dvec3& middle,
                  double from, double to, Visit&& visit) {
    for (int j = 0; j < map.height; ++j) {
        const double elevation = (j + 0.5) * 0.5 * kPi / map.height;
        if (std::abs(elevation - std::asin(middle.z)) > to) continue;
        for (int i = 0; i < map.width; ++i) {
            const glm::dvec3 direction = texels.direction(i, j);
            const double angle = std::acos(std::clamp(glm::dot(direction, middle), -1.0, 1.0));
            if (angle >= from && angle < to) visit(i, j, direction);
        }
    }
}

/// Cuts the brightest place of the map off and returns it as a sun, if it is bright enough for one.
std::optional<EnvironmentSun> extract_sun(Environment& map, const Texels& texels) {
    const glm::dvec3 middle = brightest_direction(map, texels);
    const double disc = std::max(kDisc, 1.5 * texels.size());

    double around = 0.0, solid_angle = 0.0;
    visit_around(map, texels, middle, disc, kSurroundings * disc,
                 [&](int i, int j, const glm::dvec3&) {
                     around += texels.solid_angle(j) * luminance(colour(map, i, j));
                     solid_angle += texels.solid_angle(j);
                 });
    const double ceiling = kCeiling * around / solid_angle;

    // The removed light as vectors of irradiance, a column for each colour.
    glm::dmat3 lost(0.0);
    visit_around(map, texels, middle, 0.0, disc, [&](int i, int j, const glm::dvec3& direction) {
        const glm::dvec3 here = colour(map, i, j);
        if (luminance(here) <= ceiling) return;
        const double kept = ceiling / luminance(here);
        for (int c = 0; c < 3; ++c) {
            lost[c] += (1.0 - kept) * here[c] * texels.solid_angle(j) * direction;
            map.rgb[texel(map, i, j) + static_cast<std::size_t>(c)] =
                static_cast<float>(kept * here[c]);
        }
    });
    const glm::dvec3 all = lost * kLuminance;
    const double rest = luminance(level_light(map, texels));
    if (!(glm::length(all) / kPi > kMinShare * (rest + all.z / kPi))) return std::nullopt;
    const glm::dvec3 direction = glm::normalize(all);
    return EnvironmentSun{as_array(direction), as_array(direction * lost / kPi)};
}

}  // namespace

Environment make_environment(int width, int height, std::span<const float> rgb) {
    const bool fits =
        width >= 8 && width == 2 * height && height % 2 == 0 &&
        rgb.size() == 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (!fits) {
        throw Error(ErrorKind::invalid_value,
                    "an environment of " + std::to_string(width) + " x " + std::to_string(height) +
                        " texels; one is twice as wide as high, of even height, 8 x 4 or more");
    }
    if (!std::ranges::all_of(rgb, [](float x) { return x >= 0.0f && std::isfinite(x); })) {
        throw Error(ErrorKind::invalid_value,
                    "an environment has light that is negative or not finite");
    }
    Environment map;
    map.width = width;
    map.height = height / 2;
    const auto upper = rgb.subspan(rgb.size() / 2);
    map.rgb.assign(upper.begin(), upper.end());
    const Texels texels(map);
    map.sun = extract_sun(map, texels);
    map.light = as_array(level_light(map, texels));
    return map;
}

}  // namespace ocean::preview
