// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Channels: the scalar maps of a surface. One table states for each its name, its unit and the
// fields that it is computed from; a second lists the products, the names by which users request
// one or several channels. Planner, kernel, reference backends, estimates and hosts all read these
// tables.
//
// A new channel is an enumerator and a row here, an enumerator of libocean.h with its line in
// capi/evaluate.cpp, and a name in python/libocean/_surface.py. A part that is left out does not
// compile or fails tests/python/test_wrapper.py. The kernel needs no change, though it may have
// faster code for a channel.
//
//     const ChannelSet wanted = {Channel::height, Channel::foam};
//     if (wanted.contains(Channel::foam)) ...
//     const Product& normal = find_product("normal");  // throws Error that lists the known ones
//     for (Channel channel : std::span(normal.channels).first(normal.count)) {
//         std::printf("%s\n", channel_info(channel).name.data());  // nx, ny, nz
//     }
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

#include "ocean/enum_words.hpp"

namespace ocean {

/// The kinds of subjects, as Subject::kind returns them and file headers store them.
inline constexpr std::string_view kSeaKind = "sea";
inline constexpr std::string_view kTerrainKind = "terrain";

/// Linear fields: sums over the modes. D is the horizontal displacement at choppiness 1, so that a
/// point moves by -D. Rates are time derivatives [1/s].
enum class Linear : int {
    height,
    displacement_x,
    displacement_y,
    slope_x,
    slope_y,
    gradient_xx,  // dDx/dx
    gradient_yy,
    gradient_xy,
    height_rate,
    displacement_x_rate,
    displacement_y_rate,
};
inline constexpr int kLinearCount = static_cast<int>(enum_count<Linear>());
inline constexpr auto kLinears = [] {
    std::array<Linear, kLinearCount> all{};
    for (int i = 0; i < kLinearCount; ++i) {
        all[static_cast<std::size_t>(i)] = static_cast<Linear>(i);
    }
    return all;
}();

/// One scalar map. libocean.h lists channels in the same order.
enum class Channel : int {
    dx,
    dy,
    height,
    nx,
    ny,
    nz,
    slope_x,
    slope_y,
    jacobian,
    whitecap,
    foam,
    vx,
    vy,
    vz,
    dx_x,
    dy_y,
    dx_y,
    cover,
};
/// The number of channels. The table below has a row for each, or it does not compile.
inline constexpr int kChannelCount = static_cast<int>(enum_count<Channel>());

/// The max number of channels, a host's included (OceanOptions::channels): Channel(kChannelCount +
/// i) is row i of the host's.
inline constexpr int kMaxChannels = 32;
/// Channels of waves have numbers below this. Numbers from kFirstMask on are the masks of
/// land_mask.hpp, which no sea has; the gap makes a host's first excess channel an error.
inline constexpr int kFirstMask = 40;
inline constexpr int kChannelNumbers = 56;

/// A set of channels or of linear fields, as bits.
template <typename Value>
class SetOf {
  public:
    constexpr SetOf() = default;
    constexpr SetOf(Value value) : bits_(bit(value)) {}
    constexpr SetOf(std::initializer_list<Value> values) {
        for (const Value value : values) bits_ |= bit(value);
    }
    constexpr bool contains(Value value) const { return (bits_ & bit(value)) != 0; }
    constexpr bool contains(SetOf other) const { return (other.bits_ & ~bits_) == 0; }
    constexpr bool intersects(SetOf other) const { return (bits_ & other.bits_) != 0; }
    constexpr SetOf operator|(SetOf other) const { return SetOf(bits_ | other.bits_); }
    constexpr SetOf without(SetOf other) const { return SetOf(bits_ & ~other.bits_); }
    constexpr bool empty() const { return bits_ == 0; }
    constexpr int size() const {
        int n = 0;
        for (std::uint64_t b = bits_; b != 0; b &= b - 1) ++n;
        return n;
    }
    constexpr bool operator==(const SetOf&) const = default;

  private:
    constexpr explicit SetOf(std::uint64_t bits) : bits_(bits) {}
    /// The last bit stands for every value beyond kChannelNumbers, so that such a value is noticed.
    static constexpr std::uint64_t bit(Value value) {
        const int index = static_cast<int>(value);
        return std::uint64_t{1} << (index >= 0 && index < kChannelNumbers ? index : 63);
    }
    std::uint64_t bits_ = 0;
};
using ChannelSet = SetOf<Channel>;
using LinearSet = SetOf<Linear>;

/// All channels of the table, without a host's.
inline constexpr ChannelSet kEveryChannel = [] {
    ChannelSet all;
    for (int c = 0; c < kChannelCount; ++c) all = all | static_cast<Channel>(c);
    return all;
}();

/// One sample, the input of a channel's formula. Fields that the channel's row does not list are
/// not numbers.
template <typename Real>
struct SurfacePoint {
    std::array<Real, kLinearCount> field{};  // 0 if a flat surface does not need the field
    Real choppiness{};
    Real foam_threshold{};       // Jacobian below which whitecaps begin
    Real foam_width{};           // how far below that they are complete
    float previous_foam = 0.0f;  // faded value of earlier foam
    float foam_alone = 1.0f;     // part of a whitecap without earlier foam
    float foam_cutoff = 0.0f;    // foam below it becomes 0
    float cover_power = 1.0f;    // cover = foam^cover_power

    constexpr Real operator[](Linear linear) const {
        return field[static_cast<std::size_t>(linear)];
    }
};

/// A formula in both precisions: float for the fast backends, double for the reference.
struct ChannelFormula {
    using InFloat = float (*)(const SurfacePoint<float>&);
    using InDouble = double (*)(const SurfacePoint<double>&);

    InFloat in_float = nullptr;
    InDouble in_double = nullptr;
    /// Stored, since with a sanitizer the comparison of a function to null is not constexpr.
    bool given = false;

    constexpr ChannelFormula() = default;
    constexpr ChannelFormula(InFloat f, InDouble d) : in_float(f), in_double(d), given(true) {}
    /// Takes a generic lambda: [](const auto& point) { return point[Linear::slope_x]; }
    template <typename Function>
    constexpr ChannelFormula(Function function)
        : in_float(function), in_double(function), given(true) {}

    constexpr float operator()(const SurfacePoint<float>& point) const { return in_float(point); }
    constexpr double operator()(const SurfacePoint<double>& point) const {
        return in_double(point);
    }
};

/// The inputs that a formula reads of the foam. past: threshold, width and the faded earlier foam;
/// cover: all these, and the power that turns foam into cover.
enum class FoamUse { none, threshold, past, cover };
/// Returns true if the formula reads earlier foam, so that its map needs the maps before it.
constexpr bool has_past(FoamUse use) {
    return use >= FoamUse::past;
}

/// A row of the table. The channel is a multiple of one linear field, or a formula of several.
struct ChannelInfo {
    enum class Factor { one, minus_choppiness };

    std::string_view name;
    std::string_view unit;
    LinearSet choppy;        // the fields that it is computed from
    LinearSet flat;          // the same at choppiness 0, where some fields do not matter
    Linear field{};          // the field of a multiple
    Factor factor{};         // and its factor
    ChannelFormula formula;  // empty for a multiple
    FoamUse foam{};

    constexpr ChannelInfo() = default;
    constexpr ChannelInfo(std::string_view channel, std::string_view its_unit, Linear of,
                          Factor times = Factor::one)
        : name(channel), unit(its_unit), choppy{of}, flat{of}, field(of), factor(times) {}
    constexpr ChannelInfo(std::string_view channel, std::string_view its_unit, LinearSet of,
                          LinearSet of_when_flat, ChannelFormula of_these,
                          FoamUse of_foam = FoamUse::none)
        : name(channel),
          unit(its_unit),
          choppy(of),
          flat(of_when_flat),
          formula(of_these),
          foam(of_foam) {}

    constexpr bool is_multiple() const { return !formula.given; }
    /// Returns the factor of a multiple.
    template <typename Real>
    constexpr Real times(Real choppiness) const {
        return factor == Factor::one ? Real(1) : -choppiness;
    }
};

/// The formulas of shaders/wave/surface.glsl; the formula of cover is in
/// shaders/wave/foam_cover.glsl.
namespace channel_formula {
template <typename Real>
Real normal_x(const SurfacePoint<Real>& point);
template <typename Real>
Real normal_y(const SurfacePoint<Real>& point);
template <typename Real>
Real normal_z(const SurfacePoint<Real>& point);
template <typename Real>
Real jacobian_of(const SurfacePoint<Real>& point);
template <typename Real>
Real whitecap_of(const SurfacePoint<Real>& point);
template <typename Real>
Real foam_of(const SurfacePoint<Real>& point);
template <typename Real>
Real cover_of(const SurfacePoint<Real>& point);
}  // namespace channel_formula

namespace detail {

inline constexpr LinearSet kSlopes = {Linear::slope_x, Linear::slope_y};
inline constexpr LinearSet kGradients = {Linear::gradient_xx, Linear::gradient_yy,
                                         Linear::gradient_xy};

constexpr ChannelInfo normal(std::string_view name, ChannelFormula formula) {
    return {name, "", kSlopes | kGradients, kSlopes, formula};
}
constexpr ChannelInfo from_gradients(std::string_view name, ChannelFormula formula,
                                     FoamUse foam = FoamUse::none) {
    return {name, "", kGradients, {}, formula, foam};
}

}  // namespace detail

/// The table of channels, in the order of the enumerators.
inline constexpr auto kChannels = [] {
    using enum Channel;
    using enum ChannelInfo::Factor;
    using namespace channel_formula;
    constexpr std::pair<Channel, ChannelInfo> kRows[] = {
        // Offset of the displaced point.
        {dx, {"dx", "m", Linear::displacement_x, minus_choppiness}},
        {dy, {"dy", "m", Linear::displacement_y, minus_choppiness}},
        {height, {"height", "m", Linear::height}},
        // Unit normal of the displaced surface.
        {nx, detail::normal("nx", {normal_x, normal_x})},
        {ny, detail::normal("ny", {normal_y, normal_y})},
        {nz, detail::normal("nz", {normal_z, normal_z})},
        // Slope dh/dx by label, before displacement.
        {slope_x, {"slope_x", "", Linear::slope_x}},
        {slope_y, {"slope_y", "", Linear::slope_y}},
        {jacobian, detail::from_gradients("jacobian", {jacobian_of, jacobian_of})},
        {whitecap,
         detail::from_gradients("whitecap", {whitecap_of, whitecap_of}, FoamUse::threshold)},
        {foam, detail::from_gradients("foam", {foam_of, foam_of}, FoamUse::past)},
        // Velocity d/dt of the displaced point at a fixed label.
        {vx, {"vx", "m/s", Linear::displacement_x_rate, minus_choppiness}},
        {vy, {"vy", "m/s", Linear::displacement_y_rate, minus_choppiness}},
        {vz, {"vz", "m/s", Linear::height_rate}},
        // Derivatives of the offset by label: d dx/dx, d dy/dy, and d dx/dy = d dy/dx.
        {dx_x, {"dx_x", "", Linear::gradient_xx, minus_choppiness}},
        {dy_y, {"dy_y", "", Linear::gradient_yy, minus_choppiness}},
        {dx_y, {"dx_y", "", Linear::gradient_xy, minus_choppiness}},
        // Share of the water that foam hides. Coarser maps and distant water show its mean.
        {cover, detail::from_gradients("cover", {cover_of, cover_of}, FoamUse::cover)},
    };
    std::array<ChannelInfo, kChannelCount> table{};
    for (const auto& [channel, info] : kRows) table[static_cast<std::size_t>(channel)] = info;
    return table;
}();
static_assert(std::ranges::none_of(kChannels, &std::string_view::empty, &ChannelInfo::name),
              "a channel without a row");
static_assert(kChannelCount <= kMaxChannels);

/// Returns the channel's row, also for a mask; `host_channels` are the rows that a host adds.
/// Throws Error invalid_value for a channel without a row.
const ChannelInfo& channel_info(Channel channel, std::span<const ChannelInfo> host_channels = {});
/// Throws Error invalid_value if one of the channels has no row, and unsupported for a mask of a
/// land, which no waves have.
void require_channels(ChannelSet channels, std::span<const ChannelInfo> host_channels = {});
/// Returns the linear fields that the channels are computed from; `flat`: at choppiness 0.
LinearSet fields_of(ChannelSet channels, bool flat = false,
                    std::span<const ChannelInfo> host_channels = {});

/// Returns the largest FoamUse of the channels.
FoamUse foam_use(ChannelSet channels, std::span<const ChannelInfo> host_channels = {});

/// Type of a product's samples in an image file whose options do not state one.
enum class Precision {
    half,
    full,  // for products that move geometry: a half is too coarse, 2 mm at 4 m
};

/// When a product's image file is written with run lengths (RLE). They pay if they leave less than
/// 0.9 of the bytes and the frame, computed and written, needs at most 1.4 times the CPU. They
/// leave 0.14 of whitecaps, 0.68 of slopes, whose B is empty, 0.86 of halves of normals. ZIP leaves
/// 0.97 of float displacement for 5.5 times the CPU, 0.72 of normals for 4.4 [measured, N = 1024].
enum class RunLengths { never, of_halves, always };

/// A map that users request by name: a channel, or the components of a vector.
struct Product {
    std::string_view name;
    std::array<Channel, 3> channels;  // the first `count` are valid
    int count;                        // 0: not made of channels but of a whole surface
    std::string_view unit;
    bool vector = false;            // x, y, z: a host may store it in other axes
    std::string_view subject = {};  // the one kind of subject that has it; empty = all kinds
    Precision precision = Precision::half;
    RunLengths run_lengths = RunLengths::never;
    std::string_view help = {};  // for help texts, "Height above still water"

    constexpr ChannelSet set() const {
        ChannelSet result;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            result = result | channels[i];
        }
        return result;
    }
};

namespace detail {

/// Requires all columns, so that a row of the table cannot leave them out.
constexpr Product product(std::string_view name, std::initializer_list<Channel> channels,
                          Precision precision, RunLengths run_lengths, std::string_view help) {
    Product result{.name = name,
                   .channels = {},
                   .count = static_cast<int>(channels.size()),
                   .unit = {},
                   .precision = precision,
                   .run_lengths = run_lengths,
                   .help = help};
    std::copy(channels.begin(), channels.end(), result.channels.begin());
    result.unit = kChannels[static_cast<std::size_t>(result.channels[0])].unit;
    return result;
}
constexpr Product vector(std::string_view name, std::initializer_list<Channel> channels,
                         Precision precision, RunLengths run_lengths, std::string_view help) {
    Product result = product(name, channels, precision, run_lengths, help);
    result.vector = true;
    return result;
}

}  // namespace detail

inline constexpr auto kProducts = [] {
    using enum Channel;
    using enum Precision;
    using enum RunLengths;
    return std::to_array<Product>({
        detail::product("height", {height}, half, never, "Height above still water"),
        detail::vector("displacement", {dx, dy, height}, full, never,
                       "Offset of the displaced point from its label"),
        detail::product("slope", {slope_x, slope_y}, half, always,
                        "Slope dh/dx, dh/dy by label, before displacement"),
        detail::vector("normal", {nx, ny, nz}, half, of_halves,
                       "Unit normal of the displaced surface"),
        detail::product("jacobian", {jacobian}, half, of_halves,
                        "Jacobian of the displacement; below 0 the surface folds over"),
        detail::product("whitecap", {whitecap}, half, always,
                        "Share of the water that breaks now, 0 .. 1"),
        detail::product("foam", {foam}, half, always,
                        "Foam that whitecaps leave and that fades, 0 .. 1"),
        detail::vector("velocity", {vx, vy, vz}, full, never, "Velocity of the displaced point"),
        detail::product("derivatives", {dx_x, dy_y, dx_y}, half, of_halves,
                        "Derivatives of the offset by label"),
        detail::product("cover", {cover}, half, always,
                        "Share of the water that foam hides, 0 .. 1"),
    });
}();

namespace detail {

/// Returns true if every channel is in a product, a product of one channel has the channel's name,
/// and all components of a product have its unit.
constexpr bool products_fit_channels() {
    ChannelSet all;
    for (const Product& product : kProducts) {
        all = all | product.set();
        for (std::size_t i = 0; i < static_cast<std::size_t>(product.count); ++i) {
            const ChannelInfo& info = kChannels[static_cast<std::size_t>(product.channels[i])];
            if (info.unit != product.unit) return false;
            if (product.count == 1 && info.name != product.name) return false;
        }
    }
    return all.size() == kChannelCount;
}
static_assert(products_fit_channels());

}  // namespace detail

/// Returns height, displacement, slope, normal, jacobian, whitecap, foam, velocity, derivatives,
/// cover, and the masks of lands.
std::span<const Product> product_table();
/// Returns the product of that name. Throws Error invalid_value for an unknown name, with a list of
/// the known ones.
const Product& find_product(std::string_view name);
/// Returns the product of that name among `products`. Throws Error invalid_value for an unknown
/// name, with a list of the known ones.
const Product& find_product(std::string_view name, std::span<const Product> products);

}  // namespace ocean
