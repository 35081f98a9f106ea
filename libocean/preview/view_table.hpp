// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The views of the water and of land, a row each: its word, its range of values, the maps that it
// needs and the GLSL that draws it. A new view is an enumerator of View and a row here; a row that
// is missing, in the wrong place or not complete does not compile.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "ocean/enum_words.hpp"
#include "ocean/internal/preview/picture.hpp"

namespace ocean::preview {

/// picture: a person can choose it by its word, and the sky is drawn behind the water.
/// numbers: a probe reads its values, and pixels without water stay 0.
enum class ViewUse { picture, numbers };

/// The values from the darkest to the brightest colour if DrawOptions give none.
enum class ViewRange {
    height,    // of water -Hs .. Hs, of land two rms about the mean [m]
    slope,     // four standard deviations of the slope along an axis to either side
    jacobian,  // 0 .. 2
};

/// The view shows slopes of the waves too short for the cascades' maps, or does not.
enum class NearDetail { no, yes };

/// The view shows the pattern of the foam never, always, or if the sea has foam and the look shows
/// some.
enum class FoamPattern { never, if_visible, always };

class ViewRow {
  public:
    /// All arguments are required. glsl: for each kind of scene an expression of type vec4 in
    /// shown_view() of shaders/preview/water.frag, where `state` is the Water of the fragment, and
    /// of ground.frag, where `ground` is its Ground; "": a scene of that kind has no such view.
    constexpr ViewRow(View view, ViewUse use, ViewRange range, NearDetail detail,
                      FoamPattern pattern, std::string_view of_sea, std::string_view of_land)
        : view(view),
          use(use),
          range(range),
          detail(detail),
          pattern(pattern),
          glsl{of_sea, of_land} {}

    constexpr std::string_view glsl_of(SceneKind kind) const {
        return glsl[static_cast<std::size_t>(kind)];
    }

    View view;
    ViewUse use;
    ViewRange range;
    NearDetail detail;
    FoamPattern pattern;
    std::array<std::string_view, enum_count<SceneKind>()> glsl;  // by the number of the kind
};

inline constexpr std::array<ViewRow, enum_count<View>()> kViews = {{
    {View::shaded, ViewUse::picture, ViewRange::height, NearDetail::yes, FoamPattern::if_visible,
     "shaded_view(state)", "vec4(drawn_colour(shaded(ground)), 1.0)"},
    {View::height, ViewUse::picture, ViewRange::height, NearDetail::no, FoamPattern::never,
     "two_sided(state.displacement.z)", "two_sided(ground.height)"},
    {View::displacement_x, ViewUse::picture, ViewRange::height, NearDetail::no, FoamPattern::never,
     "two_sided(-waves.x * state.displacement.x)", ""},
    {View::displacement_y, ViewUse::picture, ViewRange::height, NearDetail::no, FoamPattern::never,
     "two_sided(-waves.x * state.displacement.y)", ""},
    {View::normal, ViewUse::picture, ViewRange::height, NearDetail::yes, FoamPattern::never,
     "vec4(0.5 + 0.5 * detailed_normal_of(state), 1.0)",
     "vec4(0.5 + 0.5 * normal_of(ground), 1.0)"},
    {View::slope, ViewUse::picture, ViewRange::slope, NearDetail::yes, FoamPattern::never,
     "vec4(clamp(0.5 + slope_of(state) / range_width(), 0.0, 1.0), 0.5, 1.0)",
     "vec4(clamp(0.5 + ground.slope / range_width(), 0.0, 1.0), 0.5, 1.0)"},
    {View::jacobian, ViewUse::picture, ViewRange::jacobian, NearDetail::no, FoamPattern::never,
     "two_sided(jacobian_of(state))", ""},
    {View::whitecap, ViewUse::picture, ViewRange::height, NearDetail::no, FoamPattern::never,
     "vec4(vec3(surface_whitecap(jacobian_of(state), foam.x, foam.y)), 1.0)", ""},
    {View::foam, ViewUse::picture, ViewRange::height, NearDetail::no, FoamPattern::never,
     "vec4(vec3(cover_of(state)), 1.0)", ""},
    // Height of the mesh and of the maps [m], mean square slope shown and handed on to the light;
    // of land that in the footprint beside the shown one.
    {View::numbers, ViewUse::numbers, ViewRange::height, NearDetail::yes, FoamPattern::never,
     "vec4(position.z + drop_at(label), state.displacement.z, dot(slope_of(state), "
     "slope_of(state)), state.variance.x + state.variance.y)",
     "vec4(position.z + drop_at(label), patch_height(label), dot(ground.slope, ground.slope), "
     "ground.steepness * ground.steepness - dot(ground.slope, ground.slope))"},
    {View::foam_numbers, ViewUse::numbers, ViewRange::height, NearDetail::no, FoamPattern::always,
     "foam_numbers(state)", ""},
}};

static_assert(
    [] {
        std::size_t number = 0;
        for (const ViewRow& row : kViews) {
            if (row.view != static_cast<View>(number++) || row.glsl_of(SceneKind::sea).empty())
                return false;
        }
        return true;
    }(),
    "a row for each view, in the order of the enumerators");

/// Returns the row of a view. Throws Error invalid_value for a number that no enumerator has.
const ViewRow& row_of(View view);

/// Returns `#define VIEW_CASES`, the cases of a switch over the number of a view.
std::string view_defines(SceneKind kind);

}  // namespace ocean::preview
