// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The highest crest that a sea has by itself, in a window of place and time: what a user tries
// before asking for one.
//
//     Ocean ocean(sea);
//     const FoundCrest crest = find_highest_crest(ocean, {.from = 0.0, .to = 600.0});
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

namespace ocean {

class Ocean;

struct CrestWindow {
    double from = 0.0;  // [s]
    double to = 0.0;    // [s], not before `from`
    /// West, south, east, north [m]; the sea repeats beyond its period. Absent: all of the period.
    std::optional<std::array<double, 4>> place = {};
};

struct FoundCrest {
    double time = 0.0;    // [s]
    double x = 0.0;       // of the displayed point [m], in the window
    double y = 0.0;       // [m]
    double height = 0.0;  // over still water [m]
};

/// Returns the number of maps that a search of the window computes: one for each 24th of the peak
/// period.
std::size_t crest_search_maps(Ocean& ocean, const CrestWindow& window);

/// The max of crest_search_maps: hours of a sea.
inline constexpr std::size_t kMaxCrestSearch = 20000;

/// Returns the highest point of the displayed surface in the window: of the maps' highest points,
/// the best of the eight highest waves, each followed to a millimetre. progress: called with the
/// number of maps that are done; may throw. Throws Error invalid_value for a window without a place
/// or a time, or with more than kMaxCrestSearch maps, unsupported for a sea over a bed, and as
/// Ocean::evaluate.
FoundCrest find_highest_crest(Ocean& ocean, const CrestWindow& window,
                              const std::function<void(std::size_t done)>& progress = {});

}  // namespace ocean
