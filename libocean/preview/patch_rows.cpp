// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "patch_rows.hpp"

#include <algorithm>

namespace ocean::preview {
namespace {

/// All squares around an eye over 150 km are about 2500.
constexpr int kMaxRows = 8192;

}  // namespace

PatchRows::PatchRows(int vertices) : vertices_(vertices) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    capacity_ = std::min<int>(kMaxRows, limit);
    texture_ = gl::generate<gl::Texture, &glGenTextures>();
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, vertices_, capacity_, 0, GL_RG, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    clear();
}

void PatchRows::clear() {
    rows_.clear();
    held_.assign(static_cast<std::size_t>(capacity_), 0);
    free_.clear();
    for (int row = capacity_ - 1; row >= 0; --row) free_.push_back(row);
}

bool PatchRows::hold(const PatchKey& key) {
    const auto found = rows_.find(key);
    if (found == rows_.end()) return false;
    held_[static_cast<std::size_t>(found->second)] = picture_;
    return true;
}

void PatchRows::add(const PatchMaker::Made& made) {
    if (rows_.contains(made.key)) return;
    if (free_.empty()) make_room();
    if (free_.empty()) return;
    const int row = free_.back();
    free_.pop_back();
    rows_.emplace(made.key, row);
    held_[static_cast<std::size_t>(row)] = picture_;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, row, vertices_, 1, GL_RG, GL_FLOAT, made.heights.data());
}

/// Frees the quarter of the rows that were not held for longest.
void PatchRows::make_room() {
    std::vector<std::pair<std::uint64_t, PatchKey>> old;
    for (const auto& [key, row] : rows_) {
        const std::uint64_t held = held_[static_cast<std::size_t>(row)];
        if (held != picture_) old.emplace_back(held, key);
    }
    const std::size_t freed = std::min(old.size(), rows_.size() / 4);
    std::ranges::nth_element(old, old.begin() + static_cast<std::ptrdiff_t>(freed), {},
                             [](const auto& entry) { return entry.first; });
    old.resize(freed);
    for (const auto& [held, key] : old) {
        const auto found = rows_.find(key);
        free_.push_back(found->second);
        rows_.erase(found);
    }
}

std::uint64_t PatchRows::bytes() const {
    return static_cast<std::uint64_t>(capacity_) * static_cast<std::uint64_t>(vertices_) *
           2 * sizeof(float);
}

}  // namespace ocean::preview
