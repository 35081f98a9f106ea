// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Masks of a land, of a sea over a bed and of a sea with hulls: scalar maps beside the heights that
// no wave of the open sea has, for materials and scattered plants. A new mask is an enumerator and
// a row here. Files, command lines, the functions of terrain.inc and the slices of their maps
// follow from the row; tests/python/test_masks_in_every_host.py names what a host must write
// itself.
//
//     const Surface map = terrain.surface({Channel::height, channel_of(LandMask::wear)});
//     std::span<const float> wear = map.channel(channel_of(LandMask::wear));
//     const bool has_beach = terrain.channels().contains(channel_of(LandMask::beach));
//     for (const Product& mask : kMaskProducts) menu.add(mask.name, mask.help);
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "ocean/channel.hpp"
#include "ocean/enum_words.hpp"

namespace ocean {

/// The channels of every terrain, which has no displacement; some lands have masks too.
inline constexpr ChannelSet kTerrainChannels = {
    Channel::height, Channel::nx, Channel::ny, Channel::nz, Channel::slope_x, Channel::slope_y};

/// The masks, in the order of libocean.h.
enum class LandMask {
    wear,
    gully,
    ridge,
    flow,
    deposit,
    streambed,
    wetness,
    beach,
    cliff,
    shelter,
    depth,
    breaking,
    trail,
    dry
};
inline constexpr int kMaskCount = static_cast<int>(enum_count<LandMask>());
static_assert(kFirstMask + kMaskCount <= kChannelNumbers);

/// Returns the mask as a channel of maps.
constexpr Channel channel_of(LandMask mask) {
    return static_cast<Channel>(kFirstMask + static_cast<int>(mask));
}
/// Returns true for a channel that is a mask.
constexpr bool is_mask(Channel channel) {
    const int index = static_cast<int>(channel) - kFirstMask;
    return index >= 0 && index < kMaskCount;
}

namespace detail {

constexpr Product mask(LandMask mask, std::string_view unit, Precision precision,
                       std::string_view help, std::string_view subject = kTerrainKind) {
    return {.name = word_of(mask),
            .channels = {channel_of(mask)},
            .count = 1,
            .unit = unit,
            .subject = subject,
            .precision = precision,
            .run_lengths = RunLengths::always,
            .help = help};
}

}  // namespace detail

/// The masks as products, in the order of the enumerators.
inline constexpr auto kMaskProducts = [] {
    using enum LandMask;
    using enum Precision;
    return std::to_array<Product>({
        detail::mask(wear, "", half, "Floors of gullies -1 .. crests between them 1"),
        detail::mask(gully, "", half, "Floors of gullies, 0 .. 1"),
        detail::mask(ridge, "", half, "Crests between gullies, 0 .. 1"),
        detail::mask(flow, "m2", full, "Area that drains through the place"),
        detail::mask(deposit, "", half, "Ground that streams laid down, 0 .. 1"),
        detail::mask(streambed, "", half, "Channels of streams, 0 .. 1"),
        detail::mask(wetness, "", half,
                     "Wetness of the ground by its drainage, or by the waves that run up, 0 .. 1",
                     {}),
        detail::mask(beach, "", half, "Sand of beaches, above and under water, 0 .. 1"),
        detail::mask(cliff, "", half, "Cliffs and rocks of exposed shores, 0 .. 1"),
        detail::mask(shelter, "", half, "Shelter of the nearest shore from the sea, 0 .. 1"),
        detail::mask(depth, "m", full, "Height of the water over the bed; below 0 where it is dry",
                     kSeaKind),
        detail::mask(breaking, "", half, "Fronts of waves that break by the depth, 0 .. 1",
                     kSeaKind),
        detail::mask(trail, "", half, "White water behind hulls, 0 .. 1", kSeaKind),
        detail::mask(dry, "", half, "Inside of hulls, where no water is, 0 .. 1", kSeaKind),
    });
}();
static_assert(kMaskProducts.size() == static_cast<std::size_t>(kMaskCount));

/// The masks whose values are -1 .. 1. Other masks without a unit are 0 .. 1.
inline constexpr ChannelSet kSignedMasks = channel_of(LandMask::wear);

/// The masks of a sea with hulls. The other masks of a sea are those of a sea over a bed.
inline constexpr ChannelSet kHullMasks = {channel_of(LandMask::trail), channel_of(LandMask::dry)};

/// Returns the masks that a kind of subject can have, all masks for "", as a set of channels.
constexpr ChannelSet masks_of(std::string_view kind) {
    ChannelSet masks;
    for (const Product& mask : kMaskProducts) {
        const bool is_had = kind.empty() || mask.subject.empty() || mask.subject == kind;
        if (is_had) masks = masks | mask.set();
    }
    return masks;
}
inline constexpr ChannelSet kEveryMask = masks_of("");
inline constexpr ChannelSet kMasksOverBed = masks_of(kSeaKind).without(kHullMasks);

}  // namespace ocean
