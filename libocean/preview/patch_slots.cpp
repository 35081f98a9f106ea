// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "patch_slots.hpp"

#include <algorithm>
#include <utility>

namespace ocean::preview {

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

}  // namespace ocean::preview
