// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Units of spectral densities: see density_units.hpp.
//
//   product  = factor { ["." | "*" | "-" | "/" | "per"] factor }
//   factor   = (name | number | "(" product ")") [power] | "square" factor
//   power    = ["^" | "**"] integer | "squared"
#include "ocean/internal/density_units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <utility>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kMaxUnitBytes = 100;
constexpr int kMaxPower = 9;
/// Energy per area and variance, J/m^4: rho g with the defaults of SWAN.
constexpr double kEnergyOfVariance = 1025.0 * 9.81;

/// Powers of the base units. Angles are dimensions of their own; so is the hertz, because it is not
/// an angular frequency.
struct Unit {
    double factor = 1.0;
    int metre = 0, second = 0, kilogram = 0, radian = 0, degree = 0, hertz = 0;
};

Unit operator*(const Unit& a, const Unit& b) {
    return {a.factor * b.factor, a.metre + b.metre,   a.second + b.second, a.kilogram + b.kilogram,
            a.radian + b.radian, a.degree + b.degree, a.hertz + b.hertz};
}

Unit power(const Unit& u, int n) {
    return {std::pow(u.factor, n), u.metre * n,  u.second * n, u.kilogram * n,
            u.radian * n,          u.degree * n, u.hertz * n};
}

struct NamedUnit {
    std::string_view symbol, name, other;
    Unit unit;
};

constexpr std::array kUnits = {
    NamedUnit{"m", "meter", "metre", {1.0, 1}},
    NamedUnit{"s", "second", "sec", {1.0, 0, 1}},
    NamedUnit{"min", "minute", "", {60.0, 0, 1}},
    NamedUnit{"h", "hour", "hr", {3600.0, 0, 1}},
    NamedUnit{"hz", "hertz", "cps", {1.0, 0, 0, 0, 0, 0, 1}},
    NamedUnit{"cph", "", "", {1.0 / 3600.0, 0, 0, 0, 0, 0, 1}},
    NamedUnit{"rad", "radian", "", {1.0, 0, 0, 0, 1}},
    NamedUnit{"deg", "degree", "degr", {1.0, 0, 0, 0, 0, 1}},
    NamedUnit{"j", "joule", "", {1.0, 2, -2, 1}},
    NamedUnit{"n", "newton", "", {1.0, 1, -2, 1}},
    NamedUnit{"g", "gram", "gramme", {1e-3, 0, 0, 1}},
    NamedUnit{"ft", "foot", "feet", {0.3048, 1}},
    NamedUnit{"cycle", "cyc", "", {}},
};

struct Prefix {
    std::string_view symbol, name;
    double factor;
};

constexpr std::array kPrefixes = {
    Prefix{"k", "kilo", 1e3},   Prefix{"d", "deci", 1e-1},  Prefix{"c", "centi", 1e-2},
    Prefix{"m", "milli", 1e-3}, Prefix{"u", "micro", 1e-6},
};

std::optional<Unit> unprefixed(std::string_view name) {
    for (const NamedUnit& known : kUnits) {
        const bool same = name == known.symbol || name == known.name || name == known.other;
        if (same && !name.empty()) return known.unit;
    }
    return std::nullopt;
}

std::optional<Unit> singular(std::string_view name) {
    if (const auto unit = unprefixed(name)) return unit;
    for (const Prefix& prefix : kPrefixes) {
        for (const std::string_view start : {prefix.name, prefix.symbol}) {
            if (!name.starts_with(start)) continue;
            auto unit = unprefixed(name.substr(start.size()));
            if (!unit) continue;
            unit->factor *= prefix.factor;
            return unit;
        }
    }
    return std::nullopt;
}

std::optional<Unit> named(std::string_view name) {
    if (const auto unit = singular(name)) return unit;
    const bool plural = name.size() > 2 && name.ends_with('s');
    return plural ? singular(name.substr(0, name.size() - 1)) : std::nullopt;
}

/// Returns the text in ASCII and lower case, with parentheses for all brackets. Latin-1 characters
/// are replaced last, because their bytes are parts of UTF-8 too.
std::string plain_text(std::string_view text) {
    constexpr std::array kSpellings = {
        std::pair{"\u00b2"sv, "2"sv},   std::pair{"\u00b3"sv, "3"sv},
        std::pair{"\u00b9"sv, "1"sv},   std::pair{"\u207b"sv, "-"sv},
        std::pair{"\u207a"sv, "+"sv},   std::pair{"\u2212"sv, "-"sv},
        std::pair{"\u2013"sv, "-"sv},   std::pair{"\u00b7"sv, "."sv},
        std::pair{"\u22c5"sv, "."sv},   std::pair{"\u2219"sv, "."sv},
        std::pair{"\u00d7"sv, "*"sv},   std::pair{"\u2215"sv, "/"sv},
        std::pair{"\u00f7"sv, "/"sv},   std::pair{"\u00b0"sv, "deg"sv},
        std::pair{"\u00ba"sv, "deg"sv}, std::pair{"\u00b5"sv, "u"sv},
        std::pair{"\u03bc"sv, "u"sv},   std::pair{"\u00a0"sv, " "sv},
        std::pair{"\\cdot"sv, "."sv},   std::pair{"$"sv, ""sv},
        std::pair{"\xb2"sv, "2"sv},     std::pair{"\xb3"sv, "3"sv},
        std::pair{"\xb9"sv, "1"sv},     std::pair{"\xb7"sv, "."sv},
        std::pair{"\xb0"sv, "deg"sv},   std::pair{"\xba"sv, "deg"sv},
        std::pair{"["sv, "("sv},        std::pair{"]"sv, ")"sv},
        std::pair{"{"sv, "("sv},        std::pair{"}"sv, ")"sv},
        std::pair{"_"sv, " "sv},        std::pair{"\t"sv, " "sv},
    };
    std::string plain = lower_case(text);
    for (const auto& [from, to] : kSpellings) {
        for (std::size_t at = 0; (at = plain.find(from, at)) != std::string::npos;
             at += to.size()) {
            plain.replace(at, from.size(), to);
        }
    }
    return plain;
}

bool is_letter(char c) {
    return c >= 'a' && c <= 'z';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

struct UnitFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class UnitParser {
  public:
    /// Takes the text. `divide_all`: a division applies to all factors up to the next division.
    UnitParser(std::string_view plain, bool divide_all) : left_(plain), divide_all_(divide_all) {}

    Unit parse() {
        const Unit unit = product();
        skip_blanks();
        if (!left_.empty()) throw UnitFault("'" + std::string(left_) + "' is not understood");
        return unit;
    }

  private:
    char next() const { return left_.empty() ? '\0' : left_.front(); }
    void skip_blanks() {
        left_.remove_prefix(std::min(left_.find_first_not_of(' '), left_.size()));
    }
    bool accept(std::string_view word) {
        if (!left_.starts_with(word)) return false;
        left_.remove_prefix(word.size());
        return true;
    }
    bool accept_word(std::string_view word) {
        const bool whole = left_.size() <= word.size() || !is_letter(left_[word.size()]);
        return whole && accept(word);
    }

    Unit product() {
        Unit result;
        bool divides = false;
        bool first = true;
        for (;;) {
            skip_blanks();
            if (left_.empty() || next() == ')') break;
            bool may_be_number = first;  // "m 2" and "m^2.5" are not products
            if (accept("/") || accept_word("per")) {
                divides = may_be_number = true;
            } else {
                divides = divides && divide_all_;
                may_be_number = may_be_number || accept("*");
                if (!first && !may_be_number && !accept(".")) accept("-");
            }
            skip_blanks();
            result = result * power(factor(may_be_number), divides ? -1 : 1);
            first = false;
        }
        if (first) throw UnitFault("a unit is missing");
        return result;
    }

    Unit factor(bool may_be_number) {
        if (accept_word("square") || accept_word("sq")) {
            skip_blanks();
            return power(factor(false), 2);
        }
        Unit unit;
        if (accept("(")) {
            unit = product();
            if (!accept(")")) throw UnitFault("a parenthesis is not closed");
        } else if (is_digit(next()) && may_be_number) {
            unit.factor = number();
            return accept("^") || accept("**") ? power(unit, integer()) : unit;
        } else {
            unit = named_unit();
        }
        return power(unit, exponent());
    }

    Unit named_unit() {
        std::size_t length = 0;
        while (length < left_.size() && is_letter(left_[length])) ++length;
        const std::string_view name = left_.substr(0, length);
        const auto unit = named(name);
        if (!unit) {
            throw UnitFault("'" + std::string(length > 0 ? name : left_) + "' is not a known unit");
        }
        left_.remove_prefix(length);
        return *unit;
    }

    double number() {
        double value = 0.0;
        const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), value);
        if (error != std::errc() || !(value > 1e-12 && value < 1e12)) {
            throw UnitFault("'" + std::string(left_) + "' must begin with a number, 1e-12 .. 1e12");
        }
        left_.remove_prefix(static_cast<std::size_t>(end - left_.data()));
        return value;
    }

    /// Returns the exponent that follows; 1 if there is none.
    int exponent() {
        if (accept("^") || accept("**")) return integer();
        const std::string_view before = left_;
        skip_blanks();
        const bool negative = left_.size() > 1 && next() == '-' && is_digit(left_[1]);
        if (is_digit(next()) || negative) return integer();
        accept("-");
        if (accept_word("squared")) return 2;
        left_ = before;
        return 1;
    }

    int integer() {
        skip_blanks();
        if (accept("(")) {
            const int inner = integer();
            if (!accept(")")) throw UnitFault("a parenthesis is not closed");
            return inner;
        }
        const bool negative = accept("-");
        if (!negative) accept("+");
        int value = 0;
        const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), value);
        if (error != std::errc() || value < 0 || value > kMaxPower) {
            throw UnitFault("'" + std::string(left_) + "' must begin with a power of at most 9");
        }
        left_.remove_prefix(static_cast<std::size_t>(end - left_.data()));
        return negative ? -value : value;
    }

    std::string_view left_;
    bool divide_all_;
};

/// Returns a unit spelled as "m^2 s rad^-1".
std::string text_of(const Unit& unit) {
    std::string text;
    const auto add = [&](std::string_view name, int n) {
        if (n == 0) return;
        text += (text.empty() ? "" : " ") + std::string(name);
        if (n != 1) text += "^" + std::to_string(n);
    };
    add("kg", unit.kilogram);
    add("m", unit.metre);
    add("s", unit.second);
    add("rad", unit.radian);
    add("degree", unit.degree);
    add("Hz", unit.hertz);
    return text.empty() ? "a number" : text;
}

/// Returns the factor; nothing for a unit of another quantity.
std::optional<double> density_factor(Unit unit, DensityOver over) {
    if (unit.kilogram == 1) {  // an energy: rho g is in kg m^-2 s^-2
        unit = unit * Unit{1.0 / kEnergyOfVariance, 2, 2, -1};
    }
    if (unit.kilogram != 0 || unit.metre != 2 || unit.second - unit.hertz != 1) return std::nullopt;
    const std::pair angles(unit.radian, unit.degree);
    if (over == DensityOver::frequency) {
        if (angles == std::pair(0, 0)) return unit.factor;
        const bool angular = angles == std::pair(-1, 0) && unit.hertz == 0;
        return angular ? std::optional(unit.factor * 2.0 * kPi) : std::nullopt;
    }
    if (angles == std::pair(0, -1)) return unit.factor;
    if (angles == std::pair(-1, 0)) return unit.factor * kDegree;
    if (angles == std::pair(-1, -1)) return unit.factor * 2.0 * kPi;
    if (angles == std::pair(-2, 0)) return unit.factor * 2.0 * kPi * kDegree;
    return std::nullopt;
}

}  // namespace

DensityUnit parse_density_unit(std::string_view text, DensityOver over) {
    const std::string name = "units '" + text::printable(text) + "': ";
    const std::string_view wanted =
        over == DensityOver::frequency
            ? "of a density over frequency, like m2/Hz, m2 s, m2/(rad/s), J/m2/Hz"
            : "of a density over frequency and direction, like m2/Hz/deg, m2 s rad-1, J/m2/Hz/deg";
    if (text.size() > kMaxUnitBytes) return {0.0, name + "too long for a unit"};
    const std::string plain = plain_text(text);
    try {
        const Unit understood = UnitParser(plain, false).parse();
        auto factor = density_factor(understood, over);
        if (!factor) factor = density_factor(UnitParser(plain, true).parse(), over);
        if (factor && std::isnormal(*factor)) return {*factor, ""};
        return {0.0, name + text_of(understood) + " is not a unit " + std::string(wanted)};
    } catch (const UnitFault& fault) {
        return {0.0,
                name + text::printable(fault.what()) + "; allowed: a unit " + std::string(wanted)};
    }
}

}  // namespace ocean
