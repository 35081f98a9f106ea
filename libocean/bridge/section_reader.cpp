// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "section_reader.hpp"

#include <cmath>
#include <variant>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"

namespace ocean::bridge {
namespace {

constexpr double kMaxNumber = 1e9;

}  // namespace

void SectionReader::read_keys(std::initializer_list<KeyRow> rows,
                              std::initializer_list<std::string_view> read_elsewhere) {
    std::vector<std::string_view> allowed = read_elsewhere;
    for (const KeyRow& row : rows) allowed.push_back(row.key);
    while (next()) {
        if (std::ranges::find(allowed, key()) == allowed.end()) {
            throw text::error_at(ErrorKind::bad_file, file_, key_->line,
                                 "unknown key '" + text::printable(key()) + "' of [[" +
                                     section_.name + "]]" + did_you_mean(key(), allowed) +
                                     "; allowed: " + joined(allowed, ", "));
        }
        const auto row = std::ranges::find(rows, key(), &KeyRow::key);
        if (row != rows.end()) row->read();
    }
}

bool SectionReader::has(std::string_view key) const {
    return std::ranges::find(section_.keys, key, &TomlKey::name) != section_.keys.end();
}

bool SectionReader::next() {
    if (next_ >= section_.keys.size()) return false;
    key_ = &section_.keys[next_++];
    return true;
}

Error SectionReader::fail(const std::string& message) const {
    return text::error_at(ErrorKind::bad_file, file_, section_.line, message);
}

Error SectionReader::fail_here(const std::string& message) const {
    return text::error_at(ErrorKind::bad_file, file_, key_->line, given() + ": " + message);
}

Error SectionReader::refused(const std::string& allowed) const {
    return fail_here("allowed: " + allowed);
}

Error SectionReader::refused_word(std::span<const std::string_view> words) const {
    const std::string meant = did_you_mean(text(), words);
    return fail_here((meant.empty() ? "" : meant.substr(2) + " ") +
                     "allowed: " + joined(words, ", "));
}

std::string SectionReader::given() const {
    const auto& value = key_->value;
    std::string text = text::printable(key_->name) + " = ";
    if (const bool* flag = std::get_if<bool>(&value)) return text + (*flag ? "true" : "false");
    if (const double* number = std::get_if<double>(&value)) return text + plain_text(*number);
    if (const auto* word = std::get_if<std::string>(&value)) {
        return text + '"' + text::printable(*word) + '"';
    }
    return text + "a list of " + std::to_string(std::get<std::vector<double>>(value).size());
}

const std::string& SectionReader::text() const {
    const auto* text = std::get_if<std::string>(&key_->value);
    if (text == nullptr) throw refused("a text in quotes");
    return *text;
}

bool SectionReader::flag() const {
    const bool* flag = std::get_if<bool>(&key_->value);
    if (flag == nullptr) throw refused("true or false");
    return *flag;
}

double SectionReader::number(double min, double max) const {
    const double* number = std::get_if<double>(&key_->value);
    if (number == nullptr || !(*number >= min && *number <= max)) {
        throw refused(plain_text(min) + " .. " + plain_text(max));
    }
    return *number;
}

int SectionReader::whole(int min, int max) const {
    const double value = number(min, max);
    if (value == std::round(value)) return static_cast<int>(value);
    throw refused("whole numbers " + std::to_string(min) + " .. " + std::to_string(max));
}

std::array<double, 2> SectionReader::range(bool rising) const {
    const auto* list = std::get_if<std::vector<double>>(&key_->value);
    if (list == nullptr || list->size() != 2 ||
        !std::ranges::all_of(*list, [](double x) { return std::abs(x) <= kMaxNumber; })) {
        throw refused("two numbers within -1e9 .. 1e9, such as [0, 30]");
    }
    if (rising && (*list)[0] >= (*list)[1]) throw refused("[LOWEST, HIGHEST]");
    return {(*list)[0], (*list)[1]};
}

std::vector<int> SectionReader::whole_list(int min, int max) const {
    const auto refusal = [&] {
        return refused("a list of whole numbers " + std::to_string(min) + " .. " +
                       std::to_string(max) + ", each once");
    };
    const auto* list = std::get_if<std::vector<double>>(&key_->value);
    if (list == nullptr) throw refusal();
    std::vector<int> numbers;
    for (const double value : *list) {
        if (!(value >= min && value <= max) || value != std::round(value)) throw refusal();
        const int number = static_cast<int>(value);
        if (std::ranges::find(numbers, number) != numbers.end()) throw refusal();
        numbers.push_back(number);
    }
    return numbers;
}

}  // namespace ocean::bridge
