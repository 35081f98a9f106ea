// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Maps of one time as POV-Ray's density_file, the only binary that POV-Ray 3.7 reads: three 16-bit
// sizes, then voxels of 32 bits, all big-endian. A slice along z is a map of one quantity; a sea's:
//
//     0 height [m]   1 dx [m]   2 dz [m]   3 normal p   4 normal q   5 foam   6 cover
//
// in POV-Ray's axes, x east, y up, z north. Read with `interpolate 1`, sample i of N lies at i/N,
// slice k of n at k/n, and maps repeat. A length is (code - 2^31) / 2^21 m. A subject that is not
// displaced has height, p and q; its height is base + scale * code / (2^32 - 1), because land rises
// above the limit of these codes. The normal is its stereographic projection from below, which has
// no edge where crests fold over:
//     (p, q) = (x, z) / (1 + y),  (x, y, z) = (2 p, 1 - p^2 - q^2, 2 q) / (1 + p^2 + q^2),
// each of p and q (code - 2^31) / 2^28. Foam and cover are code / (2^32 - 1). Masks of a land have
// bytes in a file of their own, because materials need no more of them.
//
// Slope tiles have voxels of 16 bits, slice 2 b the slope of band b along x, slice 2 b + 1 its
// slope along z, each (code - 2^15) / 2^13.
#include "ocean/internal/io/df3.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ocean/error.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/land_mask.hpp"

namespace ocean::io {
namespace {

constexpr std::array kSeaSlices = {
    Df3Slice{Channel::height, Df3Code::length}, Df3Slice{Channel::dx, Df3Code::offset},
    Df3Slice{Channel::dy, Df3Code::offset},     Df3Slice{Channel::nx, Df3Code::normal},
    Df3Slice{Channel::ny, Df3Code::normal},     Df3Slice{Channel::foam, Df3Code::share},
    Df3Slice{Channel::cover, Df3Code::share},
};
constexpr std::size_t kPositionSlices = 3;
constexpr std::array kStillSlices = {
    Df3Slice{Channel::height, Df3Code::range},
    Df3Slice{Channel::nx, Df3Code::normal},
    Df3Slice{Channel::ny, Df3Code::normal},
};

constexpr double kZero = 2147483648.0;
constexpr double kLargestCode = 4294967295.0;
constexpr double kCodesPerMetre = 2097152.0;
constexpr double kCodesPerProjection = 268435456.0;
constexpr double kCodesPerSlope = 8192.0;
constexpr double kSteepest = 3.99;
// A normal that points straight down has no projection: the limit tilts it by 14 degrees.
constexpr double kLargestProjection = 7.99;

[[noreturn]] void refuse(const char* what, double value) {
    throw Error(ErrorKind::invalid_value, std::string(what) + " of the surface is " +
                                              std::to_string(value) +
                                              "; a DF3 file holds finite lengths, -1024 .. 1024 m");
}

// Positions on the two edges of a period must differ by exactly the period as floats, or copies
// show cracks: offsets are rounded to a grid that single precision holds up to the period plus
// offset.
class Offsets {
  public:
    explicit Offsets(const Surface& surface) {
        const double size = std::max(surface.domain().size[0], surface.domain().size[1]);
        double reach = size;
        for (const Channel channel : {Channel::dx, Channel::dy}) {
            if (!surface.channels().contains(channel)) continue;
            for (const float offset : surface.channel(channel)) {
                reach = std::max(reach, size + std::abs(double{offset}));
            }
        }
        // A value that is not finite is refused below.
        if (std::isfinite(reach)) step_ = std::ldexp(1.0, std::max(8, std::ilogb(reach) + 1) - 24);
    }
    double snapped(double offset) const { return std::nearbyint(offset / step_) * step_; }

  private:
    double step_ = 1.0;
};

std::uint32_t length_code(const char* what, double metres) {
    // The comparison is written so that NaN fails it.
    if (!(std::abs(metres) < 1024.0)) refuse(what, metres);
    return static_cast<std::uint32_t>(std::nearbyint(metres * kCodesPerMetre) + kZero);
}

std::uint32_t projection_code(double along, double up) {
    const double projected =
        std::clamp(along / std::max(1.0 + up, 1e-9), -kLargestProjection, kLargestProjection);
    return static_cast<std::uint32_t>(std::nearbyint(projected * kCodesPerProjection) + kZero);
}

std::uint32_t share_code(double share) {
    return static_cast<std::uint32_t>(std::nearbyint(std::clamp(share, 0.0, 1.0) * kLargestCode));
}

std::uint32_t voxel(const Surface& surface, const Offsets& offsets, const Df3Heights& heights,
                    const Df3Slice& slice, std::size_t at) {
    const double value = surface.channel(slice.channel)[at];
    switch (slice.code) {
        case Df3Code::length:
            return length_code("the height", value);
        case Df3Code::range:
            return share_code((value - heights.base) / heights.scale);
        case Df3Code::offset:
            return length_code("the displacement", offsets.snapped(value));
        case Df3Code::normal:
            return projection_code(value, double{surface.channel(Channel::nz)[at]});
        case Df3Code::share:
            break;
    }
    return share_code(value);
}

std::uint8_t mask_code(Channel mask, double value) {
    if (kSignedMasks.contains(mask)) {
        return static_cast<std::uint8_t>(127.0 +
                                         std::nearbyint(127.0 * std::clamp(value, -1.0, 1.0)));
    }
    return static_cast<std::uint8_t>(std::nearbyint(255.0 * std::clamp(value, 0.0, 1.0)));
}

void append_big_endian(std::string& bytes, std::uint32_t value, int count) {
    for (int shift = 8 * (count - 1); shift >= 0; shift -= 8) {
        bytes += static_cast<char>((value >> shift) & 0xffu);
    }
}

/// Returns the header of a file with that many voxels.
std::string df3_head(std::size_t columns, std::size_t rows, std::size_t slices) {
    std::string head;
    for (const std::size_t size : {columns, rows, slices}) {
        append_big_endian(head, static_cast<std::uint32_t>(size), 2);
    }
    return head;
}

std::uint32_t slope_code(float slope) {
    // The standard deviation of short waves' slopes is at most 0.3: the limit is 13 deviations.
    const double held = std::clamp(double{slope}, -kSteepest, kSteepest);
    return static_cast<std::uint32_t>(std::nearbyint(held * kCodesPerSlope) + 32768.0);
}

}  // namespace

Df3Slices df3_slices(std::string_view kind) {
    if (kind == kSeaKind) return kSeaSlices;
    return kStillSlices;
}

Df3Slices df3_position_slices() {
    return Df3Slices(kSeaSlices).first(kPositionSlices);
}

ChannelSet df3_channels(Df3Slices slices) {
    ChannelSet channels;
    for (const Df3Slice& slice : slices) {
        channels = channels | ChannelSet{slice.channel};
        if (slice.code == Df3Code::normal) channels = channels | ChannelSet{Channel::nz};
    }
    return channels;
}

std::uint64_t df3_bytes(int resolution, std::size_t slices) {
    const auto n = static_cast<std::uint64_t>(resolution);
    return 6 + n * n * slices * sizeof(std::uint32_t);
}

std::uint64_t df3_bytes(const Domain& domain, std::size_t slices) {
    return 6 + domain.count() * slices * sizeof(std::uint32_t);
}

Df3Heights df3_heights(const Surface& surface) {
    const auto heights = surface.channel(Channel::height);
    for (const float height : heights) {
        if (!std::isfinite(height)) {
            throw Error(ErrorKind::invalid_value, "a height is not finite: nothing was written");
        }
    }
    const auto [low, high] = std::ranges::minmax(heights);
    const double spread = static_cast<double>(high) - static_cast<double>(low);
    return {static_cast<double>(low), spread > 0.0 ? spread : 1.0};
}

namespace {

/// Hands the bytes of a file to `write`, a piece at a time.
template <typename Write>
void encode_df3(const Surface& surface, Df3Slices slices, const Write& write) {
    if ((surface.channels() | df3_channels(slices)).size() != surface.channels().size()) {
        throw Error(ErrorKind::invalid_value,
                    "a DF3 file needs the channels of its slices: a sea's are displacement, "
                    "height, normal, foam and cover");
    }
    const auto columns = static_cast<std::size_t>(surface.domain().samples[0]);
    const auto rows = static_cast<std::size_t>(surface.domain().samples[1]);
    const Offsets offsets(surface);
    const bool has_range =
        std::ranges::find(slices, Df3Code::range, &Df3Slice::code) != slices.end();
    const Df3Heights heights = has_range ? df3_heights(surface) : Df3Heights{0.0, 1.0};
    std::string bytes;
    bytes.reserve(columns * sizeof(std::uint32_t));
    write(df3_head(columns, rows, slices.size()));
    for (const Df3Slice& slice : slices) {
        for (std::size_t j = 0; j < rows; ++j) {
            bytes.clear();
            for (std::size_t i = 0; i < columns; ++i) {
                append_big_endian(bytes, voxel(surface, offsets, heights, slice, j * columns + i),
                                  4);
            }
            write(bytes);
        }
    }
}

/// Hands the bytes of a file of masks to `write`, a piece at a time.
template <typename Write>
void encode_masks(const Surface& surface, std::span<const Channel> masks, const Write& write) {
    const auto columns = static_cast<std::size_t>(surface.domain().samples[0]);
    const auto rows = static_cast<std::size_t>(surface.domain().samples[1]);
    write(df3_head(columns, rows, masks.size()));
    std::string bytes(columns * rows, '\0');
    for (const Channel mask : masks) {
        if (!surface.has(mask)) {
            throw Error(ErrorKind::invalid_value, "a DF3 file of masks needs all of them");
        }
        const auto values = surface.channel(mask);
        std::ranges::transform(values, bytes.begin(), [&](float value) {
            return static_cast<char>(mask_code(mask, double{value}));
        });
        write(bytes);
    }
}

}  // namespace

void write_df3(const Surface& surface, const std::string& path, Df3Slices slices) {
    OutputFile file(path);
    encode_df3(surface, slices, [&](const std::string& bytes) { file.write(bytes); });
    file.commit();
}

std::string df3_text(const Surface& surface, Df3Slices slices) {
    std::string text;
    encode_df3(surface, slices, [&](const std::string& bytes) { text += bytes; });
    return text;
}

std::vector<Channel> df3_masks(ChannelSet available) {
    std::vector<Channel> masks;
    for (const ocean::Product& mask : kMaskProducts) {
        if (mask.unit.empty() && available.contains(mask.set())) {
            masks.push_back(mask.channels[0]);
        }
    }
    return masks;
}

std::uint64_t masks_df3_bytes(const Domain& domain, std::size_t masks) {
    return 6 + domain.count() * masks;
}

void write_masks_df3(const Surface& surface, std::span<const Channel> masks,
                     const std::string& path) {
    OutputFile file(path);
    encode_masks(surface, masks, [&](const std::string& bytes) { file.write(bytes); });
    file.commit();
}

std::string masks_df3_text(const Surface& surface, std::span<const Channel> masks) {
    std::string text;
    encode_masks(surface, masks, [&](const std::string& bytes) { text += bytes; });
    return text;
}

std::uint64_t slopes_df3_bytes(int samples, int bands) {
    const auto n = static_cast<std::uint64_t>(samples);
    return 6 + n * n * 2 * static_cast<std::uint64_t>(bands) * sizeof(std::uint16_t);
}

void write_slopes_df3(const Detail& detail, const std::string& path) {
    const auto n = static_cast<std::size_t>(detail.samples());
    OutputFile file(path);
    file.write(df3_head(n, n, 2 * detail.bands().size()));
    std::string bytes;
    for (std::size_t band = 0; band < detail.bands().size(); ++band) {
        const std::span<const float> slopes = detail.slopes(band);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            bytes.clear();
            for (std::size_t at = 0; at < n * n; ++at) {
                append_big_endian(bytes, slope_code(slopes[2 * at + axis]), 2);
            }
            file.write(bytes);
        }
    }
    file.commit();
}

}  // namespace ocean::io
