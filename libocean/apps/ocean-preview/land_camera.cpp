// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "land_camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ocean/internal/text.hpp"

namespace ocean::app {
namespace {

constexpr int kBearings = 24;

/// The view along one bearing.
struct Sight {
    bool is_open = true;     // no ground near the eye rises to its height
    bool has_water = false;  // beyond the ground near the eye
    double skyline = -1.0;   // slope of the highest line of sight that meets ground
};

Sight sight_along(const CameraGround& ground, const std::array<double, 3>& eye, double bearing,
                  double side) {
    constexpr double kLevel = -0.04;  // slopes above it hide the middle of the picture
    const double east = std::cos(bearing), north = std::sin(bearing);
    Sight seen;
    for (double away = 2.0; away < 1.5 * side; away *= 1.2) {
        const double height = ground.height(eye[0] + away * east, eye[1] + away * north);
        const double slope = (height - eye[2]) / away;
        if (slope <= seen.skyline) continue;  // hidden
        seen.skyline = slope;
        if (away < 0.05 * side) {
            if (slope > kLevel) seen.is_open = false;
        } else if (ground.water_level && height <= *ground.water_level) {
            seen.has_water = true;
        }
    }
    return seen;
}

/// Returns how much there is to see in 60 degrees about a bearing: open ground before the eye,
/// water in a part of the picture, and relief against the sky.
double worth(const std::vector<Sight>& sights, int bearing) {
    constexpr int kHalf = kBearings / 12;
    constexpr double kSteep = 0.1;  // slope of a skyline that needs no more relief
    double open = 0.0, water = 0.0, relief = 0.0;
    for (int i = -kHalf; i <= kHalf; ++i) {
        const Sight& seen = sights[static_cast<std::size_t>((bearing + i + kBearings) % kBearings)];
        open += seen.is_open;
        water += seen.has_water;
        relief += std::clamp(seen.skyline / kSteep, 0.0, 1.0);
    }
    constexpr double kWidth = 2 * kHalf + 1;
    return (2.0 * open + std::min(2.0 * water, kWidth) + relief) / kWidth;
}

/// Puts a camera where it sees most of land that exists once, with its own heading if it keeps
/// that.
void choose_outlook(const CameraGround& ground, const Domain& domain, bool keeps_heading,
                    preview::Camera& camera) {
    constexpr int kPlaces = 12;  // along a side
    constexpr double kTurn = 2.0 * std::numbers::pi / kBearings;
    const double side = std::min(domain.size[0], domain.size[1]);
    const auto given = static_cast<int>(std::lround(camera.heading * kBearings / 360.0));
    const int kept = (given % kBearings + kBearings) % kBearings;
    const int first = keeps_heading ? kept : 0, last = keeps_heading ? kept : kBearings - 1;
    double best = -1.0;
    std::vector<Sight> sights(kBearings);
    for (int place = 0; place < kPlaces * kPlaces; ++place) {
        const double u = (place % kPlaces + 0.5) / kPlaces, v = (place / kPlaces + 0.5) / kPlaces;
        std::array eye = {domain.origin[0] + u * domain.size[0],
                          domain.origin[1] + v * domain.size[1], 0.0};
        const double surface = ground.height(eye[0], eye[1]);
        if (ground.water_level && surface <= *ground.water_level) continue;
        eye[2] = surface + ground.rise;
        for (int i = 0; i < kBearings; ++i) {
            sights[static_cast<std::size_t>(i)] = sight_along(ground, eye, i * kTurn, side);
        }
        for (int bearing = first; bearing <= last; ++bearing) {
            const double found = worth(sights, bearing);
            if (found <= best) continue;
            best = found;
            std::ranges::copy(eye, camera.eye.begin());
            if (!keeps_heading) camera.heading = 360.0 * bearing / kBearings;
        }
    }
}

}  // namespace

std::string place_on_ground(const PreviewOptions& options, const CameraGround& ground,
                            preview::Camera& camera) {
    if (!ground.is_solid) return "";
    if (options.eye_place == EyePlace::not_given && ground.middle) {
        std::ranges::copy(*ground.middle, camera.eye.begin());
        if (ground.outlook && !options.look_at) {
            choose_outlook(ground, *ground.outlook, options.has_heading, camera);
        }
    }
    const double surface = ground.height(camera.eye[0], camera.eye[1]);
    const double wanted = camera.eye[2];
    switch (options.eye_place) {
        case EyePlace::not_given:
            camera.eye[2] = surface + ground.rise;
            break;
        case EyePlace::on_ground:
            camera.eye[2] = surface + kEyeHeight;
            break;
        case EyePlace::at:
            camera.eye[2] = std::max(wanted, surface + ground.clearance);
            break;
    }
    if (options.look_at) camera.look_at(*options.look_at);
    if (options.eye_place != EyePlace::at || camera.eye[2] == wanted) return "";
    return format_text(
        "--eye: Z = %g is in the ground, which is %.2f m high there; it was raised "
        "to %.2f",
        wanted, surface, camera.eye[2]);
}

std::optional<std::array<double, 2>> middle_of(const Domain& domain) {
    if (domain.wraps) return std::nullopt;
    return std::array{domain.origin[0] + 0.5 * domain.size[0],
                      domain.origin[1] + 0.5 * domain.size[1]};
}

}  // namespace ocean::app
