// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The elevation model of a terrain; see base_file.hpp.
#include "base_file.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ocean/elevation_file.hpp"
#include "ocean/error.hpp"
#include "ocean/ring_spectrum.hpp"
#include "ocean/text.hpp"
#include "ocean/thread_pool.hpp"
#include "sha256.hpp"
#include "toml_text.hpp"

namespace ocean {
namespace {

constexpr std::size_t kMaxInlined = std::size_t{1} << 20;  // [bytes]
constexpr int kMinBaseSide = 16;                           // of a spectrum
constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Returns the heights as bytes of little-endian floats.
std::vector<std::byte> bytes_of(std::span<const float> heights) {
    std::vector<std::byte> bytes;
    bytes.reserve(4 * heights.size());
    for (const float height : heights) {
        const auto bits = std::bit_cast<std::uint32_t>(height);
        for (int shift = 0; shift < 32; shift += 8) {
            bytes.push_back(static_cast<std::byte>(bits >> shift));
        }
    }
    return bytes;
}

std::string hash_of(const ElevationModel& model) {
    std::string head;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        // Nine digits: a cell that went through its text is the same to the last bit but one.
        head += format_text("%d %.9g\n", model.domain.samples[axis], model.domain.step(axis));
    }
    std::vector<std::byte> bytes;
    for (const char c : head) bytes.push_back(static_cast<std::byte>(c));
    const std::vector<std::byte> heights = bytes_of(model.heights);
    bytes.insert(bytes.end(), heights.begin(), heights.end());
    return seafile::sha256_hex(bytes);
}

/// Returns the base of a model without holes.
std::shared_ptr<const TerrainBase> base_of(ElevationModel model) {
    for (const int side : model.domain.samples) {
        if (side >= kMinBaseSide) continue;
        throw Error(ErrorKind::invalid_value,
                    "a base needs at least 16 samples along each side, for its spectrum; this one "
                    "has " +
                        std::to_string(side));
    }
    const double ratio = model.domain.step(0) / model.domain.step(1);
    if (std::abs(ratio - 1.0) > 0.5) {
        throw Error(ErrorKind::invalid_value,
                    "the cells of a base are at most 1.5 times as long as they are wide; these "
                    "are " +
                        shortest_text(model.domain.step(0)) + " m x " +
                        shortest_text(model.domain.step(1)) + " m");
    }
    ThreadPool pool;
    TerrainBase base;
    for (const Ring& ring : measure_rings(model.domain, model.heights, pool)) {
        base.rings.wavenumber.push_back(ring.wavenumber);
        base.rings.density.push_back(ring.density);
    }
    base.hash = hash_of(model);
    base.model = std::move(model);
    return std::make_shared<const TerrainBase>(std::move(base));
}

/// Returns the heights as lines of base 64 [RFC 4648], 72 bytes each.
std::vector<std::string> encoded(std::span<const float> heights) {
    constexpr std::size_t kBytesOfLine = 72;
    const std::vector<std::byte> bytes = bytes_of(heights);
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

/// Returns the floats of such lines; nothing if they are not `count` finite heights.
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

[[noreturn]] void refuse(const std::string& what) {
    throw Error(ErrorKind::invalid_value, {.what = what,
                                           .parameter = "terrain." + std::string(kBaseTable),
                                           .value = "{...}",
                                           .allowed = "the table that libocean writes"});
}

/// Returns two finite numbers above 0.
std::array<double, 2> positive_pair(const toml::table& table, std::string_view key) {
    std::array<double, 2> pair{};
    const toml::node* node = table.get(key);
    const toml::array* list = node != nullptr ? node->as_array() : nullptr;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto number =
            list != nullptr && list->size() == 2 ? number_of((*list)[i]) : std::nullopt;
        if (!number || !(*number > 0.0) || !std::isfinite(*number)) {
            refuse("has no " + std::string(key) + " of two numbers above 0");
        }
        pair[i] = *number;
    }
    return pair;
}

}  // namespace

std::shared_ptr<const TerrainBase> read_base(const std::string& path) {
    return base_of(read_elevation(path));
}

std::string base_text(const TerrainBase& base) {
    const ElevationModel& model = base.model;
    const Domain& domain = model.domain;
    std::string text = "\n[terrain." + std::string(kBaseTable) + "]\n";
    text += "sha256 = \"" + base.hash + "\"\n";
    if (sizeof(float) * model.heights.size() > kMaxInlined) return text;
    text += "samples = [" + std::to_string(domain.samples[0]) + ", " +
            std::to_string(domain.samples[1]) + "]\n";
    text +=
        "cell = [" + shortest_text(domain.step(0)) + ", " + shortest_text(domain.step(1)) + "]\n";
    text += "heights = [\n";
    for (const std::string& line : encoded(model.heights)) text += "    \"" + line + "\",\n";
    return text + "]\n";
}

BaseHeights read_base_table(const toml::table& table) {
    BaseHeights found;
    if (const auto* hash = table.get_as<std::string>("sha256")) found.hash = hash->get();
    if (found.hash.size() != 64) refuse("has no sha256 of 64 digits");
    const toml::array* lines = table.get_as<toml::array>("heights");
    if (lines == nullptr) {
        if (table.size() != 1) refuse("has other keys than sha256, but no heights");
        return found;
    }
    if (table.size() != 4) refuse("has other keys than sha256, samples, cell and heights");
    const auto samples = positive_pair(table, "samples"), cell = positive_pair(table, "cell");
    ElevationModel model;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (samples[axis] != std::floor(samples[axis]) || samples[axis] > kMaxElevationSide) {
            refuse("has no whole samples of at most 65536 a side");
        }
        model.domain.samples[axis] = static_cast<int>(samples[axis]);
        model.domain.size[axis] = cell[axis] * (samples[axis] - 1.0);
    }
    if (sizeof(float) * model.domain.count() > kMaxInlined) refuse("is larger than 1 MB");
    auto heights = decoded(*lines, model.domain.count());
    if (!heights) refuse("does not hold its number of finite heights in base 64");
    model.heights = *std::move(heights);
    found.model = base_of(std::move(model));
    if (found.model->hash != found.hash) {
        refuse("has the hash " + found.model->hash + ", not the one that it states, " + found.hash);
    }
    return found;
}

}  // namespace ocean
