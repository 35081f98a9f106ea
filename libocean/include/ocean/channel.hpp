// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Channels: the scalar maps of a surface. One table says of each its name, its unit, and what it is
// made of; another which of them a user asks for under one name. Whoever needs to know what a
// channel is made of (planner, kernel, references, estimates, hosts) asks the table.
//
// A new channel is an enumerator and a row here, an enumerator of libocean.h with its line in
// capi/evaluate.cpp, and a name in python/libocean/_surface.py: what is left out does not compile,
// or fails tests/python/test_wrapper.py. It needs nothing in the kernel, which may have faster
// code.
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

/// Fields that are sums over the modes. D is the horizontal displacement at choppiness 1 (towards
/// -D), rates are per second.
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

/// One scalar map. The order is that of the C API's enum.
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
/// The table below has a row for each enumerator, or it does not compile.
inline constexpr int kChannelCount = static_cast<int>(enum_count<Channel>());

/// With those that a host adds (OceanOptions::channels): Channel(kChannelCount + i) is its row i.
inline constexpr int kMostChannels = 32;

/// A set of channels or of linear fields.
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
    /// The last bit stands for every value that no set has room for, so that none goes unnoticed.
    static constexpr std::uint64_t bit(Value value) {
        const int index = static_cast<int>(value);
        return std::uint64_t{1} << (index >= 0 && index < kMostChannels ? index : 63);
    }
    std::uint64_t bits_ = 0;
};
using ChannelSet = SetOf<Channel>;
using LinearSet = SetOf<Linear>;

/// Those of the table.
inline constexpr ChannelSet kEveryChannel = [] {
    ChannelSet all;
    for (int c = 0; c < kChannelCount; ++c) all = all | static_cast<Channel>(c);
    return all;
}();

/// One sample, as a channel's formula sees it: what the row leaves out is not a number.
template <typename Real>
struct SurfacePoint {
    std::array<Real, kLinearCount> field{};  // of a flat surface those that fall out are 0
    Real choppiness{};
    Real foam_threshold{};    // the Jacobian where whitecaps begin
    Real foam_width{};        // and how much lower they are whole
    float foam_left = 0.0f;   // of earlier foam
    float foam_least = 0.0f;  // below it there is none
    float cover_power = 1.0f;

    constexpr Real operator[](Linear linear) const {
        return field[static_cast<std::size_t>(linear)];
    }
};

/// A formula in both precisions: that of the fast backend, and that of the judge.
struct ChannelFormula {
    using InFloat = float (*)(const SurfacePoint<float>&);
    using InDouble = double (*)(const SurfacePoint<double>&);

    InFloat in_float = nullptr;
    InDouble in_double = nullptr;
    bool given = false;  // with a sanitizer, whether a function is null is no constant expression

    constexpr ChannelFormula() = default;
    constexpr ChannelFormula(InFloat f, InDouble d) : in_float(f), in_double(d), given(true) {}
    /// [](const auto& point) { return point[Linear::slope_x] * point[Linear::slope_x]; }
    template <typename Function>
    constexpr ChannelFormula(Function function)
        : in_float(function), in_double(function), given(true) {}

    constexpr float operator()(const SurfacePoint<float>& point) const { return in_float(point); }
    constexpr double operator()(const SurfacePoint<double>& point) const {
        return in_double(point);
    }
};

/// What a formula reads of the foam: nothing, the threshold and width of the whitecaps, what is
/// left of the past as well, or that and the power that makes cover of it.
enum class FoamUse { none, threshold, past, cover };
constexpr bool has_past(FoamUse use) {
    return use >= FoamUse::past;
}

/// A row of the table: a multiple of one linear field, or a formula of several.
struct ChannelInfo {
    enum class Factor { one, minus_choppiness };

    std::string_view name;
    std::string_view unit;
    LinearSet choppy;  // the fields it is made of
    LinearSet flat;    // and those that are left of them where the choppiness is 0
    Linear field{};    // of a multiple
    Factor factor{};
    ChannelFormula formula;  // empty: a multiple
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
    template <typename Real>
    constexpr Real times(Real choppiness) const {
        return factor == Factor::one ? Real(1) : -choppiness;
    }
};

/// The formulas of shaders/wave/surface.glsl, and cover that of foam_cover.glsl.
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
constexpr ChannelInfo squeezed(std::string_view name, ChannelFormula formula,
                               FoamUse foam = FoamUse::none) {
    return {name, "", kGradients, {}, formula, foam};
}

}  // namespace detail

/// The table, in the order of the enumerators.
inline constexpr auto kChannels = [] {
    using enum Channel;
    using enum ChannelInfo::Factor;
    using namespace channel_formula;
    constexpr std::pair<Channel, ChannelInfo> kRows[] = {
        // The offset of the displaced point.
        {dx, {"dx", "m", Linear::displacement_x, minus_choppiness}},
        {dy, {"dy", "m", Linear::displacement_y, minus_choppiness}},
        {height, {"height", "m", Linear::height}},
        // The unit normal of the displaced surface.
        {nx, detail::normal("nx", {normal_x, normal_x})},
        {ny, detail::normal("ny", {normal_y, normal_y})},
        {nz, detail::normal("nz", {normal_z, normal_z})},
        // dh/dx by label, before displacement.
        {slope_x, {"slope_x", "", Linear::slope_x}},
        {slope_y, {"slope_y", "", Linear::slope_y}},
        {jacobian, detail::squeezed("jacobian", {jacobian_of, jacobian_of})},
        {whitecap, detail::squeezed("whitecap", {whitecap_of, whitecap_of}, FoamUse::threshold)},
        {foam, detail::squeezed("foam", {foam_of, foam_of}, FoamUse::past)},
        // d/dt of the displaced point at a fixed label.
        {vx, {"vx", "m/s", Linear::displacement_x_rate, minus_choppiness}},
        {vy, {"vy", "m/s", Linear::displacement_y_rate, minus_choppiness}},
        {vz, {"vz", "m/s", Linear::height_rate}},
        // Of the offset by label: d dx/dx, d dy/dy, and d dx/dy, which is d dy/dx.
        {dx_x, {"dx_x", "", Linear::gradient_xx, minus_choppiness}},
        {dy_y, {"dy_y", "", Linear::gradient_yy, minus_choppiness}},
        {dx_y, {"dx_y", "", Linear::gradient_xy, minus_choppiness}},
        // The share of the water that foam hides. Coarser maps and far water are its mean.
        {cover, detail::squeezed("cover", {cover_of, cover_of}, FoamUse::cover)},
    };
    std::array<ChannelInfo, kChannelCount> table{};
    for (const auto& [channel, info] : kRows) table[static_cast<std::size_t>(channel)] = info;
    return table;
}();
static_assert(std::ranges::none_of(kChannels, &std::string_view::empty, &ChannelInfo::name),
              "a channel without a row");
static_assert(kChannelCount <= kMostChannels);

/// The channel's row. `further`: those of the host. Throws Error for a channel that has none.
const ChannelInfo& channel_info(Channel channel, std::span<const ChannelInfo> further = {});
/// Throws the same if one of them has none.
void require_channels(ChannelSet channels, std::span<const ChannelInfo> further = {});
/// The linear fields that the channels are made of.
LinearSet fields_of(ChannelSet channels, bool flat = false,
                    std::span<const ChannelInfo> further = {});

/// The most that any of them reads.
FoamUse foam_use(ChannelSet channels, std::span<const ChannelInfo> further = {});

/// Type of a product's samples in an image file whose options leave it open.
enum class Precision {
    half,
    full,  // of what moves geometry: half is 2 mm at 4 m, too coarse
};

/// Whether run lengths pay in a product's image file: where they leave less than 0.9 of the bytes,
/// for at most 1.4 times the CPU of a frame that is computed and written as it is. They leave 0.14
/// of whitecaps, 0.68 of slopes, whose B is empty, 0.86 of halves of normals. ZIP leaves 0.97 of
/// float displacement for 5.5 times, 0.72 of normals for 4.4 [measured, N = 1024].
enum class RunLengths { never, of_halves, always };

/// What users ask for by name: a channel, or the components of a vector.
struct Product {
    std::string_view name;
    std::array<Channel, 3> channels;  // the first `count` hold
    int count;                        // 0: a map without channels, made of a whole frame
    std::string_view unit;
    bool vector = false;            // x, y and z, which a host may want in other axes
    std::string_view subject = {};  // the one kind of subject that has it; empty: any may
    Precision precision = Precision::half;
    RunLengths run_lengths = RunLengths::never;

    constexpr ChannelSet set() const {
        ChannelSet result;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            result = result | channels[i];
        }
        return result;
    }
};

namespace detail {

/// A row of the table states precision and run lengths: without them it does not compile.
constexpr Product product(std::string_view name, std::initializer_list<Channel> channels,
                          Precision precision, RunLengths run_lengths) {
    Product result{.name = name,
                   .channels = {},
                   .count = static_cast<int>(channels.size()),
                   .unit = {},
                   .precision = precision,
                   .run_lengths = run_lengths};
    std::copy(channels.begin(), channels.end(), result.channels.begin());
    result.unit = kChannels[static_cast<std::size_t>(result.channels[0])].unit;
    return result;
}
constexpr Product vector(std::string_view name, std::initializer_list<Channel> channels,
                         Precision precision, RunLengths run_lengths) {
    Product result = product(name, channels, precision, run_lengths);
    result.vector = true;
    return result;
}

}  // namespace detail

inline constexpr auto kProducts = [] {
    using enum Channel;
    using enum Precision;
    using enum RunLengths;
    return std::to_array<Product>({
        detail::product("height", {height}, half, never),
        detail::vector("displacement", {dx, dy, height}, full, never),
        detail::product("slope", {slope_x, slope_y}, half, always),
        detail::vector("normal", {nx, ny, nz}, half, of_halves),
        detail::product("jacobian", {jacobian}, half, of_halves),
        detail::product("whitecap", {whitecap}, half, always),
        detail::product("foam", {foam}, half, always),
        detail::vector("velocity", {vx, vy, vz}, full, never),
        detail::product("derivatives", {dx_x, dy_y, dx_y}, half, of_halves),
        detail::product("cover", {cover}, half, always),
    });
}();

namespace detail {

/// Every channel is in a product, a product of one channel has its name, and units are those of all
/// components.
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

/// height, displacement, slope, normal, jacobian, whitecap, foam, velocity, derivatives, cover.
std::span<const Product> product_table();
/// Throws Error invalid_value for an unknown name, which lists those that there are.
const Product& find_product(std::string_view name);
const Product& find_product(std::string_view name, std::span<const Product> products);

}  // namespace ocean
