// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "bed_points.hpp"

#include <algorithm>

#include "ocean/sea_bed.hpp"
#include "text.hpp"

namespace ocean::app {

std::vector<std::string> bed_point_warnings(const Sea& sea, std::span<const WaterPoint> points,
                                            bool in_water) {
    const SeaBed* const bed = sea.parameters.water.bed.get();
    if (bed == nullptr) return {};
    std::vector<std::string> warnings;
    const auto warn = [&](const auto& is_affected, const char* text) {
        const auto count = std::ranges::count_if(points, is_affected);
        if (count == 0) return;
        const auto first = *std::ranges::find_if(points, is_affected);
        warnings.push_back(format_text("%zu of %zu points lie %s, the first at x = %g, y = %g m",
                                       static_cast<std::size_t>(count), points.size(), text,
                                       first.x, first.y));
    };
    warn([&](const WaterPoint& p) { return !is_over(*bed, p.x, p.y); },
         "beyond the bed (water.seabed), where the sea is open");
    if (!in_water) return warnings;
    warn(
        [&](const WaterPoint& p) {
            return is_over(*bed, p.x, p.y) && p.z <= double{bed_height(*bed, p.x, p.y)};
        },
        "in the ground of the bed (water.seabed), where no water moves");
    return warnings;
}

}  // namespace ocean::app
