// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "patch_textures.hpp"

#include <algorithm>
#include <utility>

namespace ocean::preview {
namespace {

/// All squares around an eye over 150 km are about 2500; 18 MiB.
constexpr int kMaxRows = 8192;
/// About twice the layers of a picture; 56 MiB.
constexpr int kMaxLayers = 1024;

int limited(int wanted, GLenum limit) {
    GLint most = 0;
    glGetIntegerv(limit, &most);
    return std::min<int>(wanted, most);
}

}  // namespace

PatchSlots::PatchSlots(int capacity) : capacity_(capacity) {
    clear();
}

void PatchSlots::clear() {
    slots_.clear();
    held_.assign(static_cast<std::size_t>(capacity_), 0);
    free_.clear();
    for (int slot = capacity_ - 1; slot >= 0; --slot) free_.push_back(slot);
}

std::optional<int> PatchSlots::find(const PatchKey& key) const {
    const auto found = slots_.find(key);
    return found == slots_.end() ? std::nullopt : std::optional(found->second);
}

bool PatchSlots::hold(const PatchKey& key) {
    const std::optional<int> slot = find(key);
    if (slot) held_[static_cast<std::size_t>(*slot)] = picture_;
    return slot.has_value();
}

std::optional<int> PatchSlots::add(const PatchKey& key) {
    if (slots_.contains(key)) return std::nullopt;
    if (free_.empty()) make_room();
    if (free_.empty()) return std::nullopt;
    const int slot = free_.back();
    free_.pop_back();
    slots_.emplace(key, slot);
    held_[static_cast<std::size_t>(slot)] = picture_;
    return slot;
}

/// Frees a quarter of the slots, those that were not held for longest.
void PatchSlots::make_room() {
    std::vector<std::pair<std::uint64_t, PatchKey>> old;
    for (const auto& [key, slot] : slots_) {
        const std::uint64_t held = held_[static_cast<std::size_t>(slot)];
        if (held != picture_) old.emplace_back(held, key);
    }
    const std::size_t freed = std::min(old.size(), slots_.size() / 4);
    std::ranges::nth_element(old, old.begin() + static_cast<std::ptrdiff_t>(freed), {},
                             [](const auto& entry) { return entry.first; });
    old.resize(freed);
    for (const auto& [held, key] : old) {
        const auto found = slots_.find(key);
        free_.push_back(found->second);
        slots_.erase(found);
    }
}

PatchRows::PatchRows(int vertices)
    : slots(limited(kMaxRows, GL_MAX_TEXTURE_SIZE)), vertices_(vertices) {
    texture_ = gl::generate<gl::Texture, &glGenTextures>();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, vertices_, slots.capacity(), 0, GL_RG, GL_FLOAT,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void PatchRows::add(const PatchMaker::Made& made) {
    const std::optional<int> row = slots.add(made.key);
    if (!row) return;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, *row, vertices_, 1, GL_RG, GL_FLOAT, made.values.data());
}

std::uint64_t PatchRows::bytes() const {
    return static_cast<std::uint64_t>(slots.capacity()) * static_cast<std::uint64_t>(vertices_) *
           2 * sizeof(float);
}

PatchLayers::PatchLayers(int side)
    : slots(limited(kMaxLayers, GL_MAX_ARRAY_TEXTURE_LAYERS)), side_(side) {}

void PatchLayers::make_texture() {
    texture_ = gl::generate<gl::Texture, &glGenTextures>();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
    for (int mip = 0; mip < kDetailMips; ++mip) {
        glTexImage3D(GL_TEXTURE_2D_ARRAY, mip, GL_RGBA16F, side_ >> mip, side_ >> mip,
                     slots.capacity(), 0, GL_RGB, GL_FLOAT, nullptr);
    }
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, kDetailMips - 1);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void PatchLayers::add(const PatchMaker::Made& made) {
    const std::optional<int> layer = slots.add(made.key);
    if (!layer) return;
    glActiveTexture(GL_TEXTURE0);
    if (!texture_) make_texture();
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
    const float* from = made.values.data();
    for (int mip = 0; mip < kDetailMips; ++mip) {
        const int side = side_ >> mip;
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, mip, 0, 0, *layer, side, side, 1, GL_RGB, GL_FLOAT,
                        from);
        from += 3 * side * side;
    }
}

std::uint64_t PatchLayers::bytes() const {
    if (!texture_) return 0;
    constexpr std::uint64_t kTexel = 4 * 2;
    std::uint64_t texels = 0;
    for (int mip = 0; mip < kDetailMips; ++mip) {
        const auto side = static_cast<std::uint64_t>(side_ >> mip);
        texels += side * side;
    }
    return kTexel * texels * static_cast<std::uint64_t>(slots.capacity());
}

}  // namespace ocean::preview
