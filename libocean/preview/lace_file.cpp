// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A line that names the edition, the levels of each texture as floats of this machine, and a hash.
#include "lace_file.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "ocean/internal/text.hpp"

namespace ocean::preview {
namespace {

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

}  // namespace

std::string to_bytes(const LaceTextures& textures) {
    std::string bytes = head();
    for_each_part(textures, [&](const std::vector<float>& values) {
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    });
    const std::uint64_t hash = hash_of(bytes);
    bytes.append(reinterpret_cast<const char*>(&hash), sizeof(hash));
    return bytes;
}

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

}  // namespace ocean::preview
