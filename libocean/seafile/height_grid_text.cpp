// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Heights inside a file of parameters; see height_grid_text.hpp.
#include "height_grid_text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/elevation.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Returns the heights as lines of base 64 [RFC 4648], 72 bytes each.
std::vector<std::string> encoded(std::span<const float> heights) {
    constexpr std::size_t kBytesOfLine = 72;
    const std::vector<std::byte> bytes = bytes_of_heights(heights);
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        if (i % kBytesOfLine == 0) lines.emplace_back();
        std::uint32_t group = 0;
        for (std::size_t b = 0; b < 3; ++b) {
            const std::byte byte = i + b < bytes.size() ? bytes[i + b] : std::byte{};
            group = (group << 8) | std::to_integer<std::uint32_t>(byte);
        }
        for (std::size_t d = 0; d < 4; ++d) {
            const bool filled = d <= bytes.size() - i;
            lines.back() += filled ? kDigits[(group >> (18 - 6 * d)) & 63u] : '=';
        }
    }
    return lines;
}

/// Returns the floats of lines of base 64; nothing if the lines are not `count` finite heights.
std::optional<PageVector<float>> decoded(const toml::array& lines, std::size_t count) {
    PageVector<float> heights(count);
    std::size_t filled = 0;
    std::uint32_t bits = 0, float_bits = 0;
    int bit_count = 0, byte_count = 0;
    for (const toml::node& node : lines) {
        const auto* line = node.as_string();
        if (line == nullptr) return std::nullopt;
        for (const char c : line->get()) {
            if (c == '=') continue;
            const std::size_t digit = kDigits.find(c);
            if (digit == std::string_view::npos) return std::nullopt;
            bits = (bits << 6) | static_cast<std::uint32_t>(digit);
            bit_count += 6;
            if (bit_count < 8) continue;
            bit_count -= 8;
            float_bits |= ((bits >> bit_count) & 255u) << (8 * byte_count);
            if (++byte_count < 4) continue;
            const auto height = std::bit_cast<float>(float_bits);
            if (filled == count || !(std::abs(static_cast<double>(height)) <= kMaxElevation)) {
                return std::nullopt;
            }
            heights[filled++] = height;
            float_bits = 0;
            byte_count = 0;
        }
    }
    if (filled != count || byte_count != 0) return std::nullopt;
    return heights;
}

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw Error(ErrorKind::invalid_value, {.what = what,
                                           .parameter = name,
                                           .value = "{...}",
                                           .allowed = "the table that libocean writes"});
}

/// Returns two finite numbers above 0.
std::array<double, 2> positive_pair(const toml::table& table, const std::string& name,
                                    std::string_view key) {
    const toml::node* node = table.get(key);
    const auto pair = node != nullptr ? numbers_of(*node) : std::nullopt;
    const auto is_good = [](double number) { return number > 0.0 && std::isfinite(number); };
    if (!pair || pair->size() != 2 || !std::ranges::all_of(*pair, is_good)) {
        refuse(name, "has no " + std::string(key) + " of two numbers above 0");
    }
    return {(*pair)[0], (*pair)[1]};
}

}  // namespace

std::string height_grid_text(const HeightGridView& grid) {
    std::string text = "sha256 = \"" + grid.hash + "\"\n";
    if (sizeof(float) * grid.heights.size() > kMaxInlinedHeights) return text;
    const Domain& domain = grid.grid;
    text += "samples = [" + std::to_string(domain.samples[0]) + ", " +
            std::to_string(domain.samples[1]) + "]\n";
    text +=
        "cell = [" + shortest_text(domain.step(0)) + ", " + shortest_text(domain.step(1)) + "]\n";
    text += "heights = [\n";
    for (const std::string& line : encoded(grid.heights)) text += "    \"" + line + "\",\n";
    return text + "]\n";
}

HeightGridText read_height_grid(const toml::table& table, const std::string& name, int max_side) {
    HeightGridText found;
    if (const auto* hash = table.get_as<std::string>("sha256")) found.hash = hash->get();
    if (found.hash.size() != 64) refuse(name, "has no sha256 of 64 digits");
    const toml::array* lines = table.get_as<toml::array>("heights");
    if (lines == nullptr) {
        if (table.size() != 1) refuse(name, "has other keys than sha256, but no heights");
        return found;
    }
    if (table.size() != 4) refuse(name, "has other keys than sha256, samples, cell and heights");
    const auto samples = positive_pair(table, name, "samples");
    const auto cell = positive_pair(table, name, "cell");
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (samples[axis] != std::floor(samples[axis]) || samples[axis] > max_side) {
            refuse(name, "has no whole samples of at most " + std::to_string(max_side) + " a side");
        }
        found.grid.samples[axis] = static_cast<int>(samples[axis]);
        found.grid.size[axis] = cell[axis] * (samples[axis] - 1.0);
    }
    if (sizeof(float) * found.grid.count() > kMaxInlinedHeights)
        refuse(name, "is larger than 1 MB");
    auto heights = decoded(*lines, found.grid.count());
    if (!heights) refuse(name, "does not hold its number of finite heights in base 64");
    found.heights = *std::move(heights);
    return found;
}

void require_stated_hash(const std::string& hash, const std::string& stated,
                         const std::string& name) {
    if (hash == stated) return;
    refuse(name, "has the hash " + hash + ", not the one that it states, " + stated);
}

}  // namespace ocean
