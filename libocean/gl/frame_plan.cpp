// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From tables to #defines; see frame_plan.hpp.
#include "frame_plan.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/internal/linear_shape.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::gl {

namespace {

std::string define(std::string_view name, std::string_view value) {
    return "#define " + std::string(name) + " " + std::string(value) + "\n";
}
std::string define(std::string_view name, long long value) {
    return define(name, std::to_string(value));
}

/// Returns the real factor of a field's coefficient, which is h or dh/dt, times i or not, times it.
std::string real_factor(Linear field) {
    const LinearShape shape = linear_shape(field);
    std::string factor = shape.sign < 0 ? "-1.0" : "1.0";
    for (int i = 0; i < shape.x_power; ++i) factor += " * kx";
    for (int i = 0; i < shape.y_power; ++i) factor += " * ky";
    if (shape.displacement) factor += " * u";
    if (field == Linear::gradient_xy) factor += " * gradient_scale";
    return factor;
}

std::string state_of(Linear field) {
    return linear_shape(field).rate ? "h_rate" : "h";
}

}  // namespace

/// The state times f + i g, times i or not, since both fields of a pair have the same state.
/// Written as a sum of two coefficients, a + times_i(b), it was compiled by NVIDIA's driver 580
/// without the second times_i.
std::string coefficients(const FieldPair& pack) {
    if (pack.real == pack.imaginary) return coefficient(pack.real);
    const std::string together = "product(" + state_of(pack.real) + ", vec2(" +
                                 real_factor(pack.real) + ", " + real_factor(pack.imaginary) + "))";
    return linear_shape(pack.real).odd ? "times_i(" + together + ")" : together;
}

/// Returns true if the fields of each pair are made of one state, as coefficients() needs.
constexpr bool pairs_share_a_state() {
    for (const FieldPair& pack : kFieldPairs) {
        const LinearShape a = linear_shape(pack.real), b = linear_shape(pack.imaginary);
        if (a.odd != b.odd || a.rate != b.rate) return false;
    }
    return true;
}
static_assert(pairs_share_a_state());

namespace {

std::string value_of(Quantity quantity) {
    if (quantity.is_linear()) return "p." + std::string(word_of(quantity.linear()));
    const ChannelInfo& info = channel_info(quantity.channel());
    if (!info.is_multiple()) return "channel_" + std::string(info.name) + "(p, previous_foam)";
    const bool choppy = info.factor == ChannelInfo::Factor::minus_choppiness;
    return (choppy ? "-choppiness * p." : "p.") + std::string(word_of(info.field));
}

std::string texel(const MapTexture& map) {
    std::string values;
    for (std::size_t i = 0; i < 4; ++i) {
        const bool there = i < map.quantities.size();
        values += (i > 0 ? ", " : "") + (there ? value_of(map.quantities[i]) : "0.0");
    }
    return "vec4(" + values + ")";
}

std::string_view format_word(const MapTexture& map) {
    switch (map.components()) {
        case 1:
            return "r32f";
        case 2:
            return "rg32f";
        default:
            return "rgba32f";
    }
}

std::string numbered(std::string_view name, std::size_t number) {
    return std::string(name) + "_" + std::to_string(number);
}

std::string shared_defines(const FramePlan& plan) {
    return define("N", plan.shape.resolution) + define("THREADS", plan.shape.threads()) +
           define("COLUMNS", plan.shape.columns) + define("SPLIT", plan.shape.split) +
           define("PACKS", static_cast<long long>(plan.packs.size()));
}

}  // namespace

std::string coefficient(Linear field) {
    const std::string of = state_of(field);
    const bool odd = linear_shape(field).odd;
    return (odd ? "times_i(" + of + ")" : of) + " * (" + real_factor(field) + ")";
}

PassShape pass_shape(int resolution, int shared_bytes, int workgroup_threads) {
    PassShape shape;
    shape.resolution = resolution;
    constexpr int kComplex = 8;
    const auto fits = [&](int lines, int padded_length) {
        return lines * padded_length * (shape.split ? kComplex / 2 : kComplex) <= shared_bytes &&
               lines * shape.threads() <= workgroup_threads;
    };
    while (shape.columns > 1 && !fits(shape.columns, resolution)) shape.columns /= 2;
    if (!fits(1, resolution)) shape.split = true;
    if (!fits(1, resolution)) {
        throw Error(ErrorKind::no_gpu,
                    format_text("maps of %d samples: this GPU's workgroups have %d bytes and %d "
                                "threads, and a line needs %d and %d",
                                resolution, shared_bytes, workgroup_threads,
                                resolution * kComplex / 2, shape.threads()));
    }
    // The first exchange writes every 8th number: that many lines apart, 32 banks of memory are
    // gone through without meeting.
    const auto padding = [&](int lines, int shift) {
        return fits(lines, resolution + (resolution >> shift)) ? shift : 31;
    };
    shape.rows_padding = padding(1, 5);
    shape.columns_padding = padding(shape.columns, shape.columns == 4   ? 3
                                                   : shape.columns == 2 ? 4
                                                                        : 5);
    return shape;
}

int MapTexture::components() const {
    const auto count = static_cast<int>(quantities.size());
    return count == 3 ? 4 : count;
}

GLenum MapTexture::format() const {
    constexpr GLenum kFormats[] = {GL_R32F, GL_RG32F, GL_NONE, GL_RGBA32F};
    return kFormats[components() - 1];
}

GLenum MapTexture::pixel_format() const {
    constexpr GLenum kFormats[] = {GL_RED, GL_RG, GL_NONE, GL_RGBA};
    return kFormats[components() - 1];
}

FramePlan make_frame_plan(const PassShape& shape, std::vector<Quantity> quantities, bool flat) {
    FramePlan plan;
    plan.shape = shape;
    LinearSet fields;
    ChannelSet channels;
    for (const Quantity quantity : quantities) {
        if (quantity.is_linear()) fields = fields | quantity.linear();
        if (quantity.is_channel()) channels = channels | quantity.channel();
    }
    fields = fields | fields_of(channels, flat);
    // A pass needs at least one pack, even if a flat sea's Jacobian needs no field.
    if (fields.empty()) fields = Linear::height;
    for (const FieldPair& pair : kFieldPairs) {
        if (fields.intersects({pair.real, pair.imaginary})) plan.packs.push_back(pair);
    }
    for (std::size_t i = 0; i < quantities.size(); i += 4) {
        const std::size_t end = std::min(i + 4, quantities.size());
        plan.maps.push_back({{quantities.begin() + static_cast<std::ptrdiff_t>(i),
                              quantities.begin() + static_cast<std::ptrdiff_t>(end)}});
    }
    plan.foam = has_past(foam_use(channels));
    return plan;
}

std::string FramePlan::rows_defines() const {
    std::string text = shared_defines(*this) + define("PAD", shape.rows_padding);
    for (std::size_t p = 0; p < packs.size(); ++p) {
        text += define(numbered("COEFFICIENTS", p), coefficients(packs[p]));
    }
    return text;
}

std::string FramePlan::columns_defines() const {
    std::string text = shared_defines(*this) + define("PAD", shape.columns_padding) +
                       define("FOAM", foam) + define("MAPS", static_cast<long long>(maps.size()));
    std::array<std::string, kLinearCount> values;
    values.fill("0.0");
    for (std::size_t p = 0; p < packs.size(); ++p) {
        const std::string pack = numbered("values", p) + "[e]";
        const bool scaled = packs[p].imaginary == Linear::gradient_xy;
        values[static_cast<std::size_t>(packs[p].imaginary)] =
            pack + (scaled ? ".y / gradient_scale" : ".y");
        values[static_cast<std::size_t>(packs[p].real)] = pack + ".x";
    }
    for (const Linear field : kLinears) {
        text +=
            define("FIELD_" + std::string(word_of(field)), values[static_cast<std::size_t>(field)]);
    }
    for (std::size_t m = 0; m < maps.size(); ++m) {
        text += define(numbered("FORMAT", m), format_word(maps[m]));
        text += define(numbered("TEXEL", m), texel(maps[m]));
    }
    return text;
}

}  // namespace ocean::gl
