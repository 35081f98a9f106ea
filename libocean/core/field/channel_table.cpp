// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Look-ups in the tables of channels and products.
#include <algorithm>
#include <array>
#include <string>

#include "ocean/channel.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/land_mask.hpp"

namespace ocean {
namespace {

/// Rows of the masks, which are not computed from fields of waves.
constexpr auto kMaskRows = [] {
    std::array<ChannelInfo, kMaskProducts.size()> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].name = kMaskProducts[i].name;
        rows[i].unit = kMaskProducts[i].unit;
    }
    return rows;
}();

constexpr auto kAllProducts = [] {
    std::array<Product, kProducts.size() + kMaskProducts.size()> all{};
    std::ranges::copy(kMaskProducts, std::ranges::copy(kProducts, all.begin()).out);
    return all;
}();

[[noreturn]] void refuse_channel(int channel, std::size_t host_channels) {
    throw Error(ErrorKind::invalid_value, "channel " + std::to_string(channel) +
                                              " is not known; allowed: 0 .. " +
                                              std::to_string(kChannels.size() + host_channels - 1));
}

}  // namespace

const ChannelInfo& channel_info(Channel channel, std::span<const ChannelInfo> host_channels) {
    const auto index = static_cast<std::size_t>(channel);
    if (index < kChannels.size()) return kChannels[index];
    if (is_mask(channel)) return kMaskRows[index - kFirstMask];
    const std::size_t count = kChannels.size() + host_channels.size();
    if (index < count) return host_channels[index - kChannels.size()];
    refuse_channel(static_cast<int>(channel), host_channels.size());
}

namespace {

/// Calls visit(row) for each channel of the set except masks. Throws for channels without a row.
template <typename Visit>
void for_each_channel(ChannelSet channels, std::span<const ChannelInfo> host_channels,
                      const Visit& visit) {
    for (int c = 0; c < kMaxChannels; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (channels.contains(channel)) visit(channel_info(channel, host_channels));
    }
    for (int c = kMaxChannels; c <= kChannelNumbers; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (channels.contains(channel) && !is_mask(channel)) {
            refuse_channel(c, host_channels.size());
        }
    }
}

}  // namespace

void require_channels(ChannelSet channels, std::span<const ChannelInfo> host_channels) {
    for_each_channel(channels, host_channels, [](const ChannelInfo&) {});
    for (const Product& mask : kMaskProducts) {
        if (!channels.intersects(mask.set())) continue;
        const std::string owner =
            mask.subject == kSeaKind ? "only a region of a sea over a bed" : "only a terrain";
        throw Error(ErrorKind::unsupported, owner + " has the mask " + std::string(mask.name));
    }
}

LinearSet fields_of(ChannelSet channels, bool flat, std::span<const ChannelInfo> host_channels) {
    LinearSet fields;
    for_each_channel(channels, host_channels, [&](const ChannelInfo& info) {
        fields = fields | (flat ? info.flat : info.choppy);
    });
    return fields;
}

FoamUse foam_use(ChannelSet channels, std::span<const ChannelInfo> host_channels) {
    FoamUse most = FoamUse::none;
    for_each_channel(channels, host_channels,
                     [&](const ChannelInfo& info) { most = std::max(most, info.foam); });
    return most;
}

std::span<const Product> product_table() {
    return kAllProducts;
}

const Product& find_product(std::string_view name, std::span<const Product> products) {
    const auto found = std::ranges::find(products, name, &Product::name);
    if (found != products.end()) return *found;
    throw Error(ErrorKind::invalid_value, "unknown product '" + std::string(name) + "'" +
                                              did_you_mean(name, products, &Product::name) +
                                              "; known: " + joined(products, ", ", &Product::name));
}

const Product& find_product(std::string_view name) {
    return find_product(name, product_table());
}

}  // namespace ocean
