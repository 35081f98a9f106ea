// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The thickness of a frame's foam, near and far. Thickness grows faster than cover, so that the
// thickness of a coarser map's mean cover is less than the mean thickness of the frame. Each map
// therefore gets a share of the difference that restores the frame's mean.
#include <algorithm>
#include <cmath>

#include "ocean/internal/io/povray_declarations.hpp"
#include "ocean/internal/text.hpp"
#include "wave/wave.hpp"

namespace ocean::io {
namespace {

/// Returns the mean over a map of cover times the maximum of foam_mean_thickness and
/// `min_thickness`. Cover is bilinear between samples and integrated by Gauss's rule with 2 x 2
/// points.
double thick_cover(const Surface& map, double min_thickness) {
    constexpr double kSpan = 0.35;  // Ocean_Foam_Span_ of ocean.inc
    constexpr double kNear = 0.21132486540518708;
    const auto n = static_cast<std::size_t>(map.resolution());
    const std::span<const float> cover = map.channel(Channel::cover);
    double sum = 0.0;
    for (std::size_t j = 0; j < n; ++j) {
        const std::size_t row = j * n, above = (j + 1) % n * n;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t right = (i + 1) % n;
            const double corner[] = {cover[row + i], cover[row + right], cover[above + i],
                                     cover[above + right]};
            if (corner[0] + corner[1] + corner[2] + corner[3] == 0.0) continue;
            for (const double u : {kNear, 1.0 - kNear}) {
                const double low = std::lerp(corner[0], corner[1], u);
                const double high = std::lerp(corner[2], corner[3], u);
                for (const double v : {kNear, 1.0 - kNear}) {
                    const double c = std::lerp(low, high, v);
                    sum += c * std::max(wave::double_precision::foam_mean_thickness(c, kSpan),
                                        min_thickness);
                }
            }
        }
    }
    return sum / static_cast<double>(4 * n * n);
}

}  // namespace

std::string povray_foam_declarations(std::span<const Surface> maps) {
    if (!maps.front().channels().contains(Channel::cover)) return "";
    // A map that exists once has no coarser ones: pixels read its cover at every distance.
    if (!maps.front().domain().wraps) return "";
    double hidden = 0.0;
    for (const float cover : maps.front().channel(Channel::cover)) hidden += double{cover};
    hidden /= static_cast<double>(maps.front().channel(Channel::cover).size());
    const double whole = thick_cover(maps.front(), 0.0);
    const double mean = hidden > 0.0 ? whole / hidden : 0.0;
    std::string shares;
    for (const Surface& map : maps) {
        const double own = thick_cover(map, 0.0), upper = thick_cover(map, mean);
        const double share =
            upper > own ? std::clamp((whole - own) / (upper - own), 0.0, 1.0) : 0.0;
        shares += (shares.empty() ? "" : ", ") + shortest_text(share);
    }
    return "#declare Ocean_Frame_Thickness_ = " + shortest_text(mean) +
           ";  // of the foam, 0 .. 1\n#declare Ocean_Frame_Thickness_Shares_ = array[" +
           std::to_string(maps.size()) + "] { " + shares + " };\n";
}

}  // namespace ocean::io
