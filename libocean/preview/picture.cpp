// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/preview/picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/nearest_name.hpp"

namespace ocean::preview {
namespace {

constexpr std::pair<std::string_view, View> kViews[] = {
    {"shaded", View::shaded},
    {"height", View::height},
    {"displacement_x", View::displacement_x},
    {"displacement_y", View::displacement_y},
    {"normal", View::normal},
    {"slope", View::slope},
    {"jacobian", View::jacobian},
    {"whitecap", View::whitecap},
    {"foam", View::foam},
};

}  // namespace

void Camera::look_at(const std::array<double, 3>& point) {
    const double x = point[0] - eye[0], y = point[1] - eye[1], z = point[2] - eye[2];
    constexpr double kDegrees = 57.29577951308232;
    if (x != 0.0 || y != 0.0) heading = kDegrees * std::atan2(y, x);
    if (x != 0.0 || y != 0.0 || z != 0.0) pitch = kDegrees * std::atan2(z, std::hypot(x, y));
}

std::optional<std::array<double, 2>> Camera::meet_level(double from_left, double from_top,
                                                        double aspect, double level) const {
    constexpr double kRadians = 0.017453292519943295;
    const double half = std::tan(0.5 * kRadians * field_of_view);
    const double right = half * (2.0 * from_left - 1.0);
    const double up = half / aspect * (1.0 - 2.0 * from_top);
    const double h = kRadians * heading, p = kRadians * pitch;
    const double ahead = std::cos(p) - up * std::sin(p);
    const double rise = std::sin(p) + up * std::cos(p);
    const double distance = (level - eye[2]) / rise;
    if (rise == 0.0 || !(distance > 0.0)) return std::nullopt;
    return std::array{eye[0] + distance * (ahead * std::cos(h) + right * std::sin(h)),
                      eye[1] + distance * (ahead * std::sin(h) - right * std::cos(h))};
}

std::vector<std::string> look_names() {
    return {kEnumWords<LookKind>.begin(), kEnumWords<LookKind>.end()};
}

LookKind look_of(std::string_view name) {
    const auto& words = kEnumWords<LookKind>;
    const auto found = std::ranges::find(words, name);
    if (found != words.end()) return static_cast<LookKind>(found - words.begin());
    throw Error(ErrorKind::invalid_value, "there is no look '" + std::string(name) + "'");
}

std::vector<std::string> view_names() {
    std::vector<std::string> names;
    for (const auto& [name, view] : kViews) names.emplace_back(name);
    return names;
}

View view_of(std::string_view name) {
    for (const auto& [known, view] : kViews) {
        if (known == name) return view;
    }
    throw Error(ErrorKind::invalid_value, "there is no view '" + std::string(name) + "'");
}

}  // namespace ocean::preview
