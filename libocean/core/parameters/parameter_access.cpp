// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reading and writing parameters through the table: by name, with every check in one place.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "ocean/error.hpp"
#include "ocean/grid.hpp"
#include "ocean/parameter_table.hpp"
#include "parameters/parameter_text.hpp"

namespace ocean {

namespace {

template <typename Section, typename AnyParameters>
auto& section_of(AnyParameters& parameters, std::size_t wave) {
    if constexpr (std::is_same_v<Section, Water>) return parameters.water;
    if constexpr (std::is_same_v<Section, Grid>) return parameters.grid;
    if constexpr (std::is_same_v<Section, SurfaceSettings>) return parameters.surface;
    if constexpr (std::is_same_v<Section, Timing>) return parameters.time;
    if constexpr (std::is_same_v<Section, WaveSystem>) return parameters.waves[wave];
    if constexpr (std::is_same_v<Section, Parameters>) return parameters;
}

/// The member that a table entry points to, in a const or a changeable Parameters.
template <typename AnyParameters, typename Section, typename Value>
auto& target_of(AnyParameters& parameters, std::size_t wave, Value Section::*member) {
    return section_of<Section>(parameters, wave).*member;
}

[[noreturn]] void refuse(const ParameterRef& ref, const std::string& value,
                         const std::string& reason) {
    throw Error(ErrorKind::invalid_value, {.what = reason,
                                           .parameter = ref.info->path(ref.wave),
                                           .value = value,
                                           .allowed = allowed_values(*ref.info)});
}

double checked_number(const ParameterRef& ref, const ParameterValue& value) {
    double number = 0.0;
    if (const auto* real = std::get_if<double>(&value)) {
        number = *real;
    } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
        number = static_cast<double>(*integer);
    } else {
        refuse(ref, quoted_text(value), "is not a number");
    }
    if (std::isnan(number)) refuse(ref, "nan", "is not a number");
    const bool below = number > 0.0 && number < ref.info->least;
    if (number < ref.info->min || number > ref.info->max || below) {
        refuse(ref, to_text(value), "is out of range");
    }
    return number;
}

std::int64_t checked_integer(const ParameterRef& ref, const ParameterValue& value) {
    const double number = checked_number(ref, value);
    if (number != std::floor(number)) refuse(ref, to_text(value), "is not a whole number");
    return static_cast<std::int64_t>(number);
}

void store(const ParameterRef& ref, double& target, const ParameterValue& value) {
    target = checked_number(ref, value);
}
void store(const ParameterRef& ref, std::optional<double>& target, const ParameterValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    if (text != nullptr && text->empty()) {
        target.reset();
    } else {
        target = checked_number(ref, value);
    }
}
void store(const ParameterRef& ref, int& target, const ParameterValue& value) {
    const auto number = static_cast<int>(checked_integer(ref, value));
    if (ref.info->key == "resolution" && !is_resolution(number)) {
        refuse(ref, to_text(value), "is not a power of two");
    }
    if (ref.info->key == "alignment" && number % 2 != 0) {
        refuse(ref, to_text(value), "is not even");
    }
    target = number;
}
void store(const ParameterRef& ref, std::uint32_t& target, const ParameterValue& value) {
    target = static_cast<std::uint32_t>(checked_integer(ref, value));
}
void store(const ParameterRef& ref, std::string& target, const ParameterValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) refuse(ref, to_text(value), "is not a text");
    constexpr std::size_t kMaxBytes = 4096;
    const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
    if (text->size() > kMaxBytes || std::any_of(text->begin(), text->end(), control)) {
        std::string shown = quoted_text(value);
        std::replace_if(shown.begin(), shown.end(), control, '?');
        refuse(ref, shown, "is longer than 4096 bytes or holds a control character");
    }
    target = *text;
}
void store(const ParameterRef& ref, std::vector<int>& target, const ParameterValue& value) {
    const auto* list = std::get_if<std::vector<std::int64_t>>(&value);
    if (list == nullptr) refuse(ref, quoted_text(value), "is not a list of whole numbers");
    if (list->size() > 5) refuse(ref, to_text(value), "has more than 5 numbers");
    std::vector<int> numbers;
    for (const std::int64_t number : *list) {
        numbers.push_back(static_cast<int>(checked_integer(ref, number)));
    }
    target = std::move(numbers);
}
template <typename Enum>
requires std::is_enum_v<Enum>
void store(const ParameterRef& ref, Enum& target, const ParameterValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) refuse(ref, to_text(value), "is not one of the words");
    const auto words = ref.info->choices();
    const auto found = std::find(words.begin(), words.end(), *text);
    if (found == words.end()) refuse(ref, quoted_text(value), "is not one of the words");
    target = static_cast<Enum>(found - words.begin());
}

ParameterValue load(const ParameterInfo&, double value) {
    return value;
}
ParameterValue load(const ParameterInfo&, int value) {
    return static_cast<std::int64_t>(value);
}
ParameterValue load(const ParameterInfo&, std::uint32_t value) {
    return static_cast<std::int64_t>(value);
}
ParameterValue load(const ParameterInfo&, const std::string& value) {
    return value;
}
ParameterValue load(const ParameterInfo&, const std::optional<double>& value) {
    if (value) return *value;
    return std::string();
}
ParameterValue load(const ParameterInfo&, const std::vector<int>& value) {
    return std::vector<std::int64_t>(value.begin(), value.end());
}
template <typename Enum>
requires std::is_enum_v<Enum> ParameterValue load(const ParameterInfo& info, Enum value) {
    return std::string(info.choices()[static_cast<std::size_t>(value)]);
}

void require_system(const Parameters& parameters, const ParameterRef& ref) {
    if (!ref.info->per_wave_system() || ref.wave < parameters.waves.size()) return;
    throw Error(ErrorKind::invalid_value,
                {.what = "there are " + std::to_string(parameters.waves.size()) +
                         " wave systems, numbered from 0",
                 .parameter = ref.info->path(ref.wave)});
}

}  // namespace

void assign(Parameters& parameters, const ParameterRef& ref, const ParameterValue& value) {
    require_system(parameters, ref);
    std::visit([&](auto member) { store(ref, target_of(parameters, ref.wave, member), value); },
               ref.info->member);
}

ParameterValue value_of(const Parameters& parameters, const ParameterRef& ref) {
    require_system(parameters, ref);
    return std::visit(
        [&](auto member) { return load(*ref.info, target_of(parameters, ref.wave, member)); },
        ref.info->member);
}

namespace {

bool same_systems(const Parameters& a, const Parameters& b) {
    return std::equal(a.waves.begin(), a.waves.end(), b.waves.begin(), b.waves.end(),
                      [](const WaveSystem& x, const WaveSystem& y) {
                          return x.measured == y.measured && x.energy_share == y.energy_share &&
                                 x.wind_onset == y.wind_onset;
                      });
}

}  // namespace

std::optional<Stage> first_dirty_stage(const Parameters& before, const Parameters& after) {
    if (!same_systems(before, after)) return Stage::spectrum;
    std::optional<Stage> first;
    for (const ParameterInfo& info : parameter_table()) {
        if (first && *first <= info.dirties) continue;
        const std::size_t systems = info.per_wave_system() ? before.waves.size() : 1;
        for (std::size_t wave = 0; wave < systems; ++wave) {
            const ParameterRef ref{&info, wave};
            if (value_of(before, ref) != value_of(after, ref)) first = info.dirties;
        }
    }
    return first;
}

void set_parameter(Parameters& parameters, std::string_view name, std::string_view text) {
    const ParameterRef ref = find_parameter(name);
    Parameters changed = parameters;
    assign(changed, ref, parse_value(ref, text));
    const std::string_view key = ref.info->key;
    const bool names_record = key == "file" || key == "record" || key == "place";
    if (names_record && value_of(changed, ref) != value_of(parameters, ref)) {
        changed.waves[ref.wave].measured = nullptr;  // the old one is no longer what is named
    }
    parameters = std::move(changed);
}

std::string get_parameter(const Parameters& parameters, std::string_view name) {
    return to_text(value_of(parameters, find_parameter(name)));
}

}  // namespace ocean
