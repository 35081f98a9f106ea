// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A jet: a value with its derivatives along x and y [1/m] and in time [1/s]. Arithmetic with jets
// differentiates a formula while it evaluates it, so that slopes and velocities of the surface
// follow from its height by the chain rule, without formulas of their own. A Plain is a value
// alone: the same formula gives it the same bits as a jet's value, in less time.
#pragma once

#include <cmath>

namespace ocean {

/// Four floats that are added and multiplied together.
using Quad = float __attribute__((vector_size(16)));

/// Returns tanh(x) to 3e-7 relative, in half the time of std::tanh: below 0.3 by its series, whose
/// next term is below 2e-8 there, above 0.3 by an exponential.
inline float quick_tanh(float x) {
    const float size = std::abs(x);
    if (size < 0.3f) {
        const float x2 = x * x;
        float series = 62.0f / 2835.0f;
        series = series * x2 - 17.0f / 315.0f;
        series = series * x2 + 2.0f / 15.0f;
        series = series * x2 - 1.0f / 3.0f;
        return x + x * x2 * series;
    }
    const float result = 1.0f - 2.0f / (std::exp(2.0f * size) + 1.0f);
    return x < 0.0f ? -result : result;
}

struct Jet {
    Quad parts{};  // value, by_x, by_y, by_t

    Jet() = default;
    explicit Jet(Quad all) : parts(all) {}
    Jet(float value) : parts{value, 0.0f, 0.0f, 0.0f} {}
    explicit Jet(double value) : Jet(static_cast<float>(value)) {}
    Jet(float value, float by_x, float by_y, float by_t = 0.0f) : parts{value, by_x, by_y, by_t} {}

    float value() const { return parts[0]; }
    float by_x() const { return parts[1]; }
    float by_y() const { return parts[2]; }
    float by_t() const { return parts[3]; }

    Jet& operator+=(const Jet& other) {
        parts += other.parts;
        return *this;
    }
};

inline double value_of(const Jet& jet) {
    return static_cast<double>(jet.value());
}
/// Returns f(a) for a function with the value `value` and the derivative `slope` at a.
inline Jet chain(const Jet& a, float value, float slope) {
    Quad parts = slope * a.parts;
    parts[0] = value;
    return Jet(parts);
}

inline Jet operator+(const Jet& a, const Jet& b) {
    return Jet(a.parts + b.parts);
}
inline Jet operator-(const Jet& a, const Jet& b) {
    return Jet(a.parts - b.parts);
}
inline Jet operator-(const Jet& a) {
    return Jet(-a.parts);
}
inline Jet operator*(const Jet& a, const Jet& b) {
    Quad parts = a.value() * b.parts + b.value() * a.parts;
    parts[0] = a.value() * b.value();
    return Jet(parts);
}
inline Jet operator*(float a, const Jet& b) {
    return Jet(a * b.parts);
}
inline Jet operator*(const Jet& a, float b) {
    return Jet(b * a.parts);
}
inline Jet operator/(const Jet& a, const Jet& b) {
    const float inverse = 1.0f / b.value();
    const float quotient = a.value() * inverse;
    Quad parts = inverse * (a.parts - quotient * b.parts);
    parts[0] = quotient;
    return Jet(parts);
}

inline Jet sqrt(const Jet& a) {
    const float root = std::sqrt(a.value());
    return chain(a, root, root > 0.0f ? 0.5f / root : 0.0f);
}
inline Jet exp(const Jet& a) {
    const float value = std::exp(a.value());
    return chain(a, value, value);
}
inline Jet log(const Jet& a) {
    return chain(a, std::log(a.value()), 1.0f / a.value());
}
inline Jet log10(const Jet& a) {
    constexpr float kLogE = 0.4342944819f;
    return chain(a, std::log10(a.value()), kLogE / a.value());
}
/// Returns a to the power of the value of `exponent`, which must be constant.
inline Jet pow(const Jet& a, const Jet& exponent) {
    const float value = std::pow(a.value(), exponent.value());
    return chain(a, value, a.value() != 0.0f ? exponent.value() * value / a.value() : 0.0f);
}
inline Jet tanh(const Jet& a) {
    const float value = quick_tanh(a.value());
    return chain(a, value, 1.0f - value * value);
}
inline Jet sin(const Jet& a) {
    return chain(a, std::sin(a.value()), std::cos(a.value()));
}
inline Jet cos(const Jet& a) {
    return chain(a, std::cos(a.value()), -std::sin(a.value()));
}
inline Jet abs(const Jet& a) {
    return a.value() < 0.0f ? -a : a;
}
inline Jet min(const Jet& a, const Jet& b) {
    return b.value() < a.value() ? b : a;
}
inline Jet max(const Jet& a, const Jet& b) {
    return b.value() > a.value() ? b : a;
}

/// A value without derivatives. Its arithmetic has the same bits as a jet's value.
struct Plain {
    float number = 0.0f;

    Plain() = default;
    Plain(float value) : number(value) {}
    explicit Plain(double value) : number(static_cast<float>(value)) {}

    float value() const { return number; }
    explicit operator Jet() const { return {number}; }
};

inline double value_of(Plain a) {
    return static_cast<double>(a.number);
}
inline Plain chain(Plain, float value, float) {
    return value;
}

inline Plain operator+(Plain a, Plain b) {
    return a.number + b.number;
}
inline Plain operator-(Plain a, Plain b) {
    return a.number - b.number;
}
inline Plain operator-(Plain a) {
    return -a.number;
}
inline Plain operator*(Plain a, Plain b) {
    return a.number * b.number;
}
inline Plain operator/(Plain a, Plain b) {
    return a.number * (1.0f / b.number);
}

inline Plain sqrt(Plain a) {
    return std::sqrt(a.number);
}
inline Plain exp(Plain a) {
    return std::exp(a.number);
}
inline Plain log(Plain a) {
    return std::log(a.number);
}
inline Plain pow(Plain a, Plain exponent) {
    return std::pow(a.number, exponent.number);
}
inline Plain tanh(Plain a) {
    return quick_tanh(a.number);
}
inline Plain sin(Plain a) {
    return std::sin(a.number);
}
inline Plain cos(Plain a) {
    return std::cos(a.number);
}

}  // namespace ocean
