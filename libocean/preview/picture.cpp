// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/preview/picture.hpp"

#include <cmath>
#include <span>

#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "projection.hpp"
#include "view_table.hpp"

namespace ocean::preview {
namespace {

std::vector<std::string> as_strings(std::span<const std::string_view> words) {
    return {words.begin(), words.end()};
}

/// Returns the error for a word that is no `what`, for example no "view".
Error no_such(const char* what, std::string_view word, std::span<const std::string_view> words) {
    return Error(ErrorKind::invalid_value, "there is no " + std::string(what) + " '" +
                                               std::string(word) + "'" + did_you_mean(word, words));
}

template <typename Enum>
Enum named(std::string_view name, const char* what) {
    if (const auto found = enumerator_of<Enum>(name)) return *found;
    throw no_such(what, name, kEnumWords<Enum>);
}

/// Returns true if a person can choose the view for a scene of that kind.
bool is_choice(const ViewRow& row, SceneKind kind) {
    return row.use == ViewUse::picture && !row.glsl_of(kind).empty();
}

}  // namespace

void Camera::look_at(const std::array<double, 3>& point) {
    const double x = point[0] - eye[0], y = point[1] - eye[1], z = point[2] - eye[2];
    if (x != 0.0 || y != 0.0) heading = std::atan2(y, x) / kRadians;
    if (x != 0.0 || y != 0.0 || z != 0.0) pitch = std::atan2(z, std::hypot(x, y)) / kRadians;
}

std::array<double, 3> Camera::line_of_sight(double from_left, double from_top,
                                            double aspect) const {
    const auto [ahead, right, rise] = sight(from_left, from_top, aspect);
    const double h = kRadians * heading;
    const double scale = 1.0 / std::hypot(ahead, right, rise);
    return {scale * (ahead * std::cos(h) + right * std::sin(h)),
            scale * (ahead * std::sin(h) - right * std::cos(h)), scale * rise};
}

std::optional<std::array<double, 2>> Camera::meet_level(double from_left, double from_top,
                                                        double aspect, double level) const {
    const auto [ahead, right, rise] = sight(from_left, from_top, aspect);
    const double h = kRadians * heading;
    const double distance = (level - eye[2]) / rise;
    if (rise == 0.0 || !(distance > 0.0)) return std::nullopt;
    return std::array{eye[0] + distance * (ahead * std::cos(h) + right * std::sin(h)),
                      eye[1] + distance * (ahead * std::sin(h) - right * std::cos(h))};
}

Camera::Sight Camera::sight(double from_left, double from_top, double aspect) const {
    const double half = std::tan(0.5 * kRadians * field_of_view);
    const double right = half * (2.0 * from_left - 1.0);
    const double up = half / aspect * (1.0 - 2.0 * from_top);
    const double p = kRadians * pitch;
    return {std::cos(p) - up * std::sin(p), right, std::sin(p) + up * std::cos(p)};
}

std::vector<std::string> look_names() {
    return as_strings(kEnumWords<LookKind>);
}

LookKind look_of(std::string_view name) {
    return named<LookKind>(name, "look");
}

std::vector<std::string> land_colour_names() {
    return as_strings(kEnumWords<LandColours>);
}

LandColours land_colours_of(std::string_view name) {
    return named<LandColours>(name, "colours of land");
}

std::vector<std::string> view_names(SceneKind kind) {
    std::vector<std::string> names;
    for (const ViewRow& row : kViews) {
        if (is_choice(row, kind)) names.emplace_back(word_of(row.view));
    }
    return names;
}

View view_of(std::string_view name, SceneKind kind) {
    std::vector<std::string_view> words;
    for (const ViewRow& row : kViews) {
        if (!is_choice(row, kind)) continue;
        if (word_of(row.view) == name) return row.view;
        words.push_back(word_of(row.view));
    }
    throw no_such("view", name, words);
}

}  // namespace ocean::preview
