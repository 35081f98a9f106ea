// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/preview/picture.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "angles.hpp"
#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "view_table.hpp"

namespace ocean::preview {
namespace {

constexpr std::span kLooks(kEnumWords<LookKind>);
constexpr std::span kViewWords(kEnumWords<View>);

std::vector<std::string> as_strings(std::span<const std::string_view> words) {
    return {words.begin(), words.end()};
}

/// Returns the error for a word that is no `what`, for example no "view".
Error no_such(const char* what, std::string_view word) {
    return Error(ErrorKind::invalid_value,
                 "there is no " + std::string(what) + " '" + std::string(word) + "'");
}

/// Returns the enumerator of a word. Throws Error invalid_value, which names `what`.
template <typename Enum>
Enum enumerator(std::span<const std::string_view> words, std::string_view word, const char* what) {
    const auto found = std::ranges::find(words, word);
    if (found != words.end()) return static_cast<Enum>(found - words.begin());
    throw no_such(what, word);
}

}  // namespace

void Camera::look_at(const std::array<double, 3>& point) {
    const double x = point[0] - eye[0], y = point[1] - eye[1], z = point[2] - eye[2];
    if (x != 0.0 || y != 0.0) heading = std::atan2(y, x) / kRadians;
    if (x != 0.0 || y != 0.0 || z != 0.0) pitch = std::atan2(z, std::hypot(x, y)) / kRadians;
}

std::optional<std::array<double, 2>> Camera::meet_level(double from_left, double from_top,
                                                        double aspect, double level) const {
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
    return as_strings(kLooks);
}

LookKind look_of(std::string_view name) {
    return enumerator<LookKind>(kLooks, name, "look");
}

std::vector<std::string> view_names() {
    std::vector<std::string> names;
    for (const ViewRow& row : kViews) {
        if (row.use == ViewUse::picture) names.emplace_back(word_of(row.view));
    }
    return names;
}

View view_of(std::string_view name) {
    const View view = enumerator<View>(kViewWords, name, "view");
    if (row_of(view).use == ViewUse::picture) return view;
    throw no_such("view", name);
}

}  // namespace ocean::preview
