// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Values of a table's rows: all checks of types, ranges and rules, and values as text, without
// regard to the locale. This code knows no model.
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>

#include "ocean/error.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/table.hpp"

namespace ocean {

namespace {

/// A row, and the item to which a message refers.
struct Place {
    const ParameterSpec& spec;
    std::size_t item;
};

[[noreturn]] void refuse(const Place& place, const std::string& value, const std::string& reason) {
    throw Error(ErrorKind::invalid_value, {.what = reason,
                                           .parameter = place.spec.path(place.item),
                                           .value = value,
                                           .allowed = allowed_values(place.spec)});
}

/// Returns the length of the number at the start of a text, 0 if there is none.
std::size_t length_of_number(std::string_view text, double& number) {
    const std::size_t plus = text.starts_with('+') ? 1 : 0;
    const char* const start = text.data() + plus;
    const auto parsed = std::from_chars(start, text.data() + text.size(), number);
    return parsed.ec == std::errc() ? static_cast<std::size_t>(parsed.ptr - text.data()) : 0;
}

double checked_number(const Place& place, const ParameterValue& value) {
    double number = 0.0;
    if (const auto* real = std::get_if<double>(&value)) {
        number = *real;
    } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
        number = static_cast<double>(*integer);
    } else {
        const auto* text = std::get_if<std::string>(&value);
        refuse(place, quoted_text(value), no_number_reason(place.spec, text ? *text : ""));
    }
    if (std::isnan(number)) refuse(place, "nan", "is not a number");
    const bool below = number > 0.0 && number < place.spec.min_nonzero;
    if (number < place.spec.min || number > place.spec.max || below) {
        refuse(place, to_text(value), "is out of range");
    }
    return number;
}

std::int64_t checked_integer(const Place& place, const ParameterValue& value) {
    const double number = checked_number(place, value);
    if (number != std::floor(number)) refuse(place, to_text(value), "is not a whole number");
    const auto whole = static_cast<std::int64_t>(number);
    const bool unset = whole == 0 && place.spec.min_nonzero > 0.0;
    const bool power =
        unset || (whole > 0 && std::has_single_bit(static_cast<std::uint64_t>(whole)));
    if (place.spec.rule == NumberRule::power_of_two && !power) {
        refuse(place, to_text(value), "is not a power of two");
    }
    if (place.spec.rule == NumberRule::even && whole % 2 != 0) {
        refuse(place, to_text(value), "is not even");
    }
    return whole;
}

std::string checked_text(const Place& place, const ParameterValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) refuse(place, to_text(value), "is not a text");
    constexpr std::size_t kMaxBytes = 4096;
    const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
    if (text->size() > kMaxBytes || std::any_of(text->begin(), text->end(), control)) {
        std::string shown = quoted_text(value);
        std::replace_if(shown.begin(), shown.end(), control, '?');
        refuse(place, shown, "is longer than 4096 bytes or holds a control character");
    }
    return *text;
}

std::vector<std::int64_t> checked_list(const Place& place, const ParameterValue& value) {
    const auto* list = std::get_if<std::vector<std::int64_t>>(&value);
    if (list == nullptr) refuse(place, quoted_text(value), "is not a list of whole numbers");
    if (list->size() > place.spec.max_length) {
        refuse(place, to_text(value),
               "has more than " + std::to_string(place.spec.max_length) + " numbers");
    }
    std::vector<std::int64_t> numbers;
    for (const std::int64_t number : *list) numbers.push_back(checked_integer(place, number));
    return numbers;
}

std::vector<double> checked_numbers(const Place& place, const ParameterValue& value) {
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    if (numbers == nullptr) refuse(place, quoted_text(value), "is not a list of numbers");
    if (numbers->size() > place.spec.max_length) {
        refuse(place, to_text(value),
               "has more than " + std::to_string(place.spec.max_length) + " numbers");
    }
    for (const double number : *numbers) checked_number(place, number);
    return *numbers;
}

NumberPairs checked_pairs(const Place& place, const ParameterValue& value) {
    const auto* pairs = std::get_if<NumberPairs>(&value);
    if (pairs == nullptr) refuse(place, quoted_text(value), "is not a list of pairs");
    if (pairs->size() > place.spec.max_length) {
        refuse(place, to_text(value),
               "has more than " + std::to_string(place.spec.max_length) + " pairs");
    }
    for (const auto& [first, second] : *pairs) {
        checked_number(place, first);
        // NaN fails both comparisons.
        if (!(second >= place.spec.second_min && second <= place.spec.second_max)) {
            refuse(place, to_text(value), "holds " + plain_text(second) + ", out of range");
        }
    }
    return *pairs;
}

std::string checked_word(const Place& place, const ParameterValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) refuse(place, to_text(value), "is not one of the words");
    const auto words = place.spec.choices();
    if (std::find(words.begin(), words.end(), *text) == words.end()) {
        const std::vector<std::string_view> known(words.begin(), words.end());
        refuse(place, quoted_text(value), "is not one of the words" + did_you_mean(*text, known));
    }
    return *text;
}

/// Returns metres as a number, a multiple of Hs as its text.
ParameterValue checked_wave_height(const Place& place, const ParameterValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) return checked_number(place, value);
    const auto height = parse_wave_height(*text);
    if (!height) refuse(place, quoted_text(value), "is not a height");
    if (!height->is_relative) return checked_number(place, height->value);
    if (!std::isfinite(height->value)) refuse(place, quoted_text(value), "is not a finite height");
    return to_text(*height);
}

bool checked_truth(const Place& place, const ParameterValue& value) {
    const auto* truth = std::get_if<bool>(&value);
    if (truth == nullptr) refuse(place, quoted_text(value), "is neither true nor false");
    return *truth;
}

std::vector<std::int64_t> parse_list(const Place& place, std::string_view text) {
    std::vector<std::int64_t> numbers;
    std::size_t at = 0;
    while ((at = text.find_first_not_of("[], ", at)) != std::string_view::npos) {
        std::int64_t number = 0;
        const auto parsed = std::from_chars(text.data() + at, text.data() + text.size(), number);
        if (parsed.ec != std::errc()) {
            refuse(place, quoted_text(std::string(text)), "is not a list of whole numbers");
        }
        numbers.push_back(number);
        at = static_cast<std::size_t>(parsed.ptr - text.data());
    }
    return numbers;
}

/// Returns the numbers of "[[500, 2.5], [20, 1.9]]", with or without the brackets.
std::vector<double> parse_numbers(const Place& place, std::string_view text,
                                  const std::string& fault) {
    std::vector<double> numbers;
    std::size_t at = 0;
    while ((at = text.find_first_not_of("[], ", at)) != std::string_view::npos) {
        double number = 0.0;
        if (text[at] == '+') ++at;
        const auto parsed = std::from_chars(text.data() + at, text.data() + text.size(), number);
        if (parsed.ec != std::errc()) refuse(place, quoted_text(std::string(text)), fault);
        numbers.push_back(number);
        at = static_cast<std::size_t>(parsed.ptr - text.data());
    }
    return numbers;
}

NumberPairs parse_pairs(const Place& place, std::string_view text) {
    const std::string fault = "is not a list of pairs";
    const std::vector<double> numbers = parse_numbers(place, text, fault);
    if (numbers.size() % 2 != 0) refuse(place, quoted_text(std::string(text)), fault);
    NumberPairs pairs;
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
        pairs.push_back({numbers[i], numbers[i + 1]});
    }
    return pairs;
}

/// Returns "[a, b]".
template <typename Items, typename Spell>
std::string bracketed(const Items& items, const Spell& spell) {
    return "[" + joined(items, ", ", spell) + "]";
}

std::string range_text(double min, double max) {
    return plain_text(min) + " .. " + plain_text(max);
}

}  // namespace

std::optional<WaveHeight> parse_wave_height(std::string_view text) {
    WaveHeight height;
    const std::size_t length = length_of_number(text, height.value);
    text.remove_prefix(length);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    height.is_relative = text == "Hs";
    if (length == 0 || (!height.is_relative && !text.empty())) return std::nullopt;
    return height;
}

std::string to_text(const WaveHeight& height) {
    return plain_text(height.value) + (height.is_relative ? " Hs" : "");
}

bool ParameterSpec::is_unset(const ParameterValue& value) const {
    return type() == "float" && std::holds_alternative<std::string>(value);
}

bool ParameterSpec::is_left_out(const ParameterValue& value) const {
    return is_unset(value) || (neutral && to_text(value) == *neutral);
}

ParameterValue checked_value(const ParameterSpec& spec, std::size_t item,
                             const ParameterValue& value) {
    const Place place{spec, item};
    const std::string_view type = spec.type();
    if (type == "int") return checked_integer(place, value);
    if (type == "bool") return checked_truth(place, value);
    if (type == "enum") return checked_word(place, value);
    if (type == "text") return checked_text(place, value);
    if (type == "list") return checked_list(place, value);
    if (type == "numbers") return checked_numbers(place, value);
    if (type == "pairs") return checked_pairs(place, value);
    if (type == "wave_height") return checked_wave_height(place, value);
    const auto* text = std::get_if<std::string>(&value);
    if (spec.member_type.optional && text != nullptr && text->empty()) return value;
    return checked_number(place, value);
}

std::string no_number_reason(const ParameterSpec& spec, std::string_view text) {
    double number = 0.0;
    const std::size_t length = length_of_number(text, number);
    const std::string_view rest = text.substr(length);
    const std::size_t unit = std::min(rest.find_first_not_of(' '), rest.size());
    const bool has_unit = length > 0 && unit < rest.size() &&
                          rest.find_first_of("0123456789.,;:[](){}") == std::string_view::npos;
    if (!has_unit) return "is not a number";
    return "is not a number: write it " +
           (spec.unit.empty() ? "" : "in " + std::string(spec.unit) + ", ") + "without a unit";
}

ParameterValue parse_value(const ParameterSpec& spec, std::size_t item, std::string_view text) {
    const Place place{spec, item};
    const std::string_view type = spec.type();
    const bool unset = spec.member_type.optional && text.empty();
    if (type == "enum" || type == "text" || type == "wave_height" || unset) {
        return std::string(text);
    }
    if (type == "list") return parse_list(place, text);
    if (type == "numbers") return parse_numbers(place, text, "is not a list of numbers");
    if (type == "pairs") return parse_pairs(place, text);
    if (type == "bool") {
        if (text == "true" || text == "false") return text == "true";
        refuse(place, quoted_text(std::string(text)), "is neither true nor false");
    }
    double number = 0.0;
    if (text.empty() || length_of_number(text, number) != text.size()) {
        refuse(place, quoted_text(std::string(text)), no_number_reason(spec, text));
    }
    return number;
}

std::string to_text(const ParameterValue& value) {
    if (const auto* real = std::get_if<double>(&value)) return plain_text(*real);
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
        return bracketed(*numbers, plain_text);
    }
    if (const auto* pairs = std::get_if<NumberPairs>(&value)) {
        return bracketed(*pairs, [](const auto& pair) { return bracketed(pair, plain_text); });
    }
    return bracketed(std::get<std::vector<std::int64_t>>(value),
                     [](std::int64_t number) { return std::to_string(number); });
}

std::string quoted_text(const ParameterValue& value) {
    const bool text = std::holds_alternative<std::string>(value);
    return text ? "\"" + to_text(value).substr(0, 80) + "\"" : to_text(value);
}

std::string allowed_values(const ParameterSpec& spec) {
    const std::string_view type = spec.type();
    if (type == "text") return "any text";
    if (type == "bool") return "true or false";
    if (type == "enum") {
        std::string words;
        for (const std::string_view word : spec.choices()) {
            words += (words.empty() ? "one of " : ", ") + std::string(word);
        }
        return words;
    }
    std::string range = plain_text(spec.min);
    if (spec.min_nonzero > 0.0) range += " or " + plain_text(spec.min_nonzero);
    range += " .. " + plain_text(spec.max);
    if (!spec.unit.empty() && spec.unit != "samples") range += " " + std::string(spec.unit);
    if (spec.rule == NumberRule::power_of_two) return "a power of two, " + range;
    if (spec.rule == NumberRule::even) return "an even number, " + range;
    if (type == "int") return "a whole number, " + range;
    if (type == "wave_height") return range + ", or a multiple of Hs such as \"1.3 Hs\"";
    const std::string at_most = "at most " + std::to_string(spec.max_length);
    if (type == "list") return at_most + " whole numbers, " + range;
    if (type == "numbers") return at_most + " numbers, " + range;
    if (type == "pairs") {
        return at_most + " pairs [" + range + ", " + range_text(spec.second_min, spec.second_max) +
               "]";
    }
    return range;
}

void refuse_item(const ParameterSpec& spec, std::size_t item, std::size_t items) {
    throw Error(ErrorKind::invalid_value,
                {.what = "only " + std::to_string(items) + " " + std::string(spec.item) +
                         "s exist, numbered from 0",
                 .parameter = spec.path(item)});
}

}  // namespace ocean
