// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "lace_maps.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/internal/text.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean::preview {
namespace {

// The textures as bytes that a program keeps between its runs.

/// Counts what lace_levels makes of a texture.
constexpr int kLevelsEdition = 1;

std::string head() {
    return format_text("libocean foam pattern %d.%d\n", kFoamTextureEdition, kLevelsEdition);
}

/// FNV-1a, of words in place of bytes.
std::uint64_t hash_of(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + at, std::min(sizeof(word), bytes.size() - at));
        hash = (hash ^ word) * 0x100000001b3u;
    }
    return hash;
}

/// Calls body(values) for all values of the textures, in their order.
template <typename Textures, typename Body>
void for_each_part(Textures& textures, const Body& body) {
    for (auto& levels : textures) {
        for (auto& level : levels) {
            body(level.means);
            body(level.shares);
        }
    }
}

std::string to_bytes(const LaceTextures& textures) {
    std::string bytes = head();
    for_each_part(textures, [&](const std::vector<float>& values) {
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    });
    const std::uint64_t hash = hash_of(bytes);
    bytes.append(reinterpret_cast<const char*>(&hash), sizeof(hash));
    return bytes;
}

/// Returns nothing for bytes that were not made whole by to_bytes of this edition of the textures.
std::optional<LaceTextures> lace_of_bytes(std::string_view bytes) {
    LaceTextures textures = empty_lace();
    std::size_t size = head().size() + sizeof(std::uint64_t);
    for_each_part(textures,
                  [&](std::vector<float>& values) { size += values.size() * sizeof(float); });
    if (bytes.size() != size || !bytes.starts_with(head())) return std::nullopt;
    std::uint64_t hash = 0;
    const std::string_view hashed = bytes.substr(0, size - sizeof(hash));
    std::memcpy(&hash, bytes.data() + hashed.size(), sizeof(hash));
    if (hash != hash_of(hashed)) return std::nullopt;
    const char* from = bytes.data() + head().size();
    for_each_part(textures, [&](std::vector<float>& values) {
        std::memcpy(values.data(), from, values.size() * sizeof(float));
        from += values.size() * sizeof(float);
    });
    return textures;
}

/// Texels a side: 1 cm of the net, 3 mm of the bubbles, 19 cm of the streaks.
constexpr std::array<int, kFoamTextures.size()> kSizes = {1024, 512, 512};
constexpr int kMinSize = 32;
constexpr int kReads = 1 << 19;  // that a level is sampled by

float at(const LaceLevel& level, int x, int y) {
    const int mask = level.size - 1;
    return level.means[static_cast<std::size_t>((y & mask) * level.size + (x & mask))];
}

std::vector<float> halved(const LaceLevel& fine) {
    std::vector<float> means;
    for (int y = 0; y < fine.size; y += 2) {
        for (int x = 0; x < fine.size; x += 2) {
            means.push_back(0.25f * (at(fine, x, y) + at(fine, x + 1, y) + at(fine, x, y + 1) +
                                     at(fine, x + 1, y + 1)));
        }
    }
    return means;
}

/// Returns the table of the texture itself, whose values are uniform.
std::vector<float> even_shares() {
    std::vector<float> shares;
    for (int i = 0; i < kLaceShares; ++i) {
        shares.push_back(static_cast<float>(i) / static_cast<float>(kLaceShares - 1));
    }
    return shares;
}

std::vector<float> shares_of(const LaceLevel& level) {
    constexpr int kBins = kLaceShares - 1;
    std::vector<std::uint32_t> count(kBins);
    // Places within a texel follow the two-dimensional golden ratio: a lattice would miss extremes.
    const int reads = std::max(2, kReads / (level.size * level.size));
    float u = 0.5f, v = 0.5f;
    for (int y = 0; y < level.size; ++y) {
        for (int x = 0; x < level.size; ++x) {
            const float a = at(level, x, y), b = at(level, x + 1, y);
            const float c = at(level, x, y + 1), d = at(level, x + 1, y + 1);
            for (int i = 0; i < reads; ++i) {
                u += 0.75487767f;
                v += 0.56984029f;
                u -= u >= 1.0f ? 1.0f : 0.0f;
                v -= v >= 1.0f ? 1.0f : 0.0f;
                const float left = a + (c - a) * v, right = b + (d - b) * v;
                const int bin = static_cast<int>((left + (right - left) * u) * kBins);
                ++count[static_cast<std::size_t>(std::clamp(bin, 0, kBins - 1))];
            }
        }
    }
    std::vector<float> shares = {0.0f};
    double below = 0.0;
    for (const std::uint32_t of_bin : count) {
        below += of_bin;
        shares.push_back(
            static_cast<float>(below / (static_cast<double>(level.size) * level.size * reads)));
    }
    return shares;
}

gl::Texture upload(const std::vector<LaceLevel>& levels) {
    gl::Texture texture = gl::generate<gl::Texture, &glGenTextures>();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    for (std::size_t l = 0; l < levels.size(); ++l) {
        glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(l), GL_R16, levels[l].size, levels[l].size,
                     0, GL_RED, GL_FLOAT, levels[l].means.data());
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels.size()) - 1);
    // No table fits a read between two levels.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
}

}  // namespace

std::vector<LaceLevel> lace_levels(const FoamTextureSettings& settings, ThreadPool& pool) {
    std::vector<LaceLevel> levels = {{settings.size, make_foam_texture(settings, pool), {}}};
    while (levels.back().size > kMinSize) {
        levels.push_back({levels.back().size / 2, halved(levels.back()), {}});
    }
    pool.for_each_item(static_cast<int>(levels.size()), [&](int item, int) {
        LaceLevel& level = levels[static_cast<std::size_t>(item)];
        level.shares = item == 0 ? even_shares() : shares_of(level);
    });
    return levels;
}

LaceTextures empty_lace() {
    LaceTextures textures;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        for (int size = kSizes[i]; size >= kMinSize; size /= 2) {
            const auto side = static_cast<std::size_t>(size);
            textures[i].push_back(
                {size, std::vector<float>(side * side), std::vector<float>(kLaceShares)});
        }
    }
    return textures;
}

LaceTextures LaceMaps::make(int threads, const KeptTextures& kept) {
    if (kept.read) {
        if (std::optional<LaceTextures> read = lace_of_bytes(kept.read())) return std::move(*read);
    }
    ThreadPool pool(threads);
    LaceTextures made;
    for (std::size_t i = 0; i < made.size(); ++i) {
        made[i] = lace_levels({kFoamTextures[i].kind, kSizes[i]}, pool);
    }
    if (kept.write) kept.write(to_bytes(made));
    return made;
}

Pending LaceMaps::pending() const {
    if (!making_.valid()) return Pending::nothing;
    const bool made = making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    return made ? Pending::ready : Pending::in_work;
}

bool LaceMaps::ready() {
    if (ready_) return true;
    if (!making_.valid() && !waits_) making_ = std::async(std::launch::async, make, 1, kept_);
    if (!waits_ && making_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        return false;
    }
    const LaceTextures all = waits_ ? make(0, kept_) : making_.get();
    std::vector<float> shares;
    for (std::size_t i = 0; i < all.size(); ++i) {
        textures_[i] = upload(all[i]);
        for (const LaceLevel& level : all[i]) {
            shares.insert(shares.end(), level.shares.begin(), level.shares.end());
        }
        shares.resize((i + 1) * kMaxLaceLevels * kLaceShares);
    }
    shares_ = gl::generate<gl::Texture, &glGenTextures>();
    glBindTexture(GL_TEXTURE_2D, shares_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, kLaceShares,
                 kMaxLaceLevels * static_cast<int>(all.size()), 0, GL_RED, GL_FLOAT, shares.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return ready_ = true;
}

}  // namespace ocean::preview
