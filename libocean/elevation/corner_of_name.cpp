// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The corner of an SRTM tile in its name: see ocean/internal/elevation_import.hpp.
#include <algorithm>
#include <charconv>
#include <string_view>

#include "ocean/internal/elevation_import.hpp"

namespace ocean {

std::optional<std::array<double, 2>> corner_of_name(std::string_view name) {
    const auto degrees = [](std::string_view word, std::string_view letters, std::size_t digits,
                            double most) -> std::optional<double> {
        if (word.size() < digits + 1) return std::nullopt;
        const char letter = static_cast<char>(word[0] >= 'a' ? word[0] - 32 : word[0]);
        int value = 0;
        const char* const end = word.data() + 1 + digits;
        const auto [stop, error] = std::from_chars(word.data() + 1, end, value);
        const bool good =
            error == std::errc() && stop == end && letters.find(letter) != letters.npos;
        if (!good || value < 0 || value > most) return std::nullopt;
        return letter == letters[1] ? -value : value;
    };
    const auto north = degrees(name, "NS", 2, 90.0);
    const auto east = degrees(name.substr(std::min<std::size_t>(3, name.size())), "EW", 3, 180.0);
    if (!north || !east) return std::nullopt;
    return std::array{*east, *north};
}

}  // namespace ocean
