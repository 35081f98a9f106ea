// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Untrusted TOML: see toml_input.hpp.
#include "toml_input.hpp"

#include <algorithm>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/seafile.hpp"
#include "toml_text.hpp"

namespace ocean {
namespace {

constexpr std::size_t kMaxKeyParts = 16;

/// Finds keys of absurdly many parts, a.b.c.d...: each part is a table inside the previous one, and
/// toml++ destroys nested tables by recursion, which overflows the stack. Dots are counted outside
/// strings and comments since the last separator; a float has one dot.
class KeyDepth {
  public:
    explicit KeyDepth(std::string_view text) : text_(text) {}

    /// Returns the line of the first such key.
    std::optional<std::size_t> first_fault() {
        std::size_t dots = 0;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"' || c == '\'') {
                skip_string(c);
                continue;
            }
            if (c == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
                continue;
            }
            if (std::string_view("\n,=[]{}").find(c) != std::string_view::npos) dots = 0;
            if (c == '\n') ++line_;
            if (c == '.' && ++dots > kMaxKeyParts) return line_;
            ++at_;
        }
        return std::nullopt;
    }

  private:
    void skip_string(char quote) {
        const std::string triple(3, quote);
        const bool multi_line = text_.substr(at_).starts_with(triple);
        at_ += multi_line ? 3 : 1;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '\n' && !multi_line) return;
            if (c == '\n') ++line_;
            if (c == '\\' && quote == '"') {
                const bool line_ends = at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
                at_ += line_ends ? 1 : 2;
            } else if (!multi_line && c == quote) {
                ++at_;
                return;
            } else if (multi_line && text_.substr(at_).starts_with(triple)) {
                at_ += 3;
                // Up to two quotes may precede the closing three.
                for (int i = 0; i < 2 && at_ < text_.size() && text_[at_] == quote; ++i) ++at_;
                return;
            } else {
                ++at_;
            }
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

std::size_t line_at(std::string_view text, std::size_t offset) {
    const auto lines =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n');
    return static_cast<std::size_t>(lines) + 1;
}

/// Returns a hint for a line such as `wind_speed = 12kn`, "" for other lines.
std::string unit_hint(std::string_view text, std::size_t line) {
    for (; line > 1 && !text.empty(); --line) {
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    }
    text = text.substr(0, text.find_first_of("\r\n#"));
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::size_t value = text.find_first_not_of("= +-", equals);
    if (value == std::string_view::npos || text[value] < '0' || text[value] > '9') return "";
    const std::size_t unit = text.find_first_not_of("0123456789._ ", value);
    const bool is_letter = unit != std::string_view::npos &&
                           ((text[unit] | 0x20) >= 'a' && (text[unit] | 0x20) <= 'z');
    return is_letter ? "; numbers are written without their unit, which `ocean params` lists" : "";
}

void check_bounds(std::string_view text, const std::string& name) {
    const auto fail = [&](std::size_t line, std::string_view message) {
        return text::error_at(ErrorKind::bad_file, name, line, message);
    };
    if (text.size() > kMaxSeaFileBytes) throw fail(0, "is larger than the 4 MiB allowed");
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
        throw fail(line_at(text, nul), "holds a NUL byte; a sea file is text");
    }
    if (const auto line = KeyDepth(text).first_fault()) {
        throw fail(*line, "a key has more than 16 parts");
    }
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& name) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    // PowerShell's `>` writes it, with its byte order mark [RFC 2781] 3.2.
    const bool little = text.starts_with("\xFF\xFE");
    if (little || text.starts_with("\xFE\xFF")) {
        const text::Utf16Text read = text::utf8_of_utf16(text.substr(2), !little);
        if (!read.half) return parse_toml(read.text, name);
        throw text::error_at(ErrorKind::bad_file, name, line_at(read.text, *read.half),
                             "is UTF-16 with half a character");
    }
    check_bounds(text, name);
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        const std::size_t line = error.source().begin.line;
        throw text::error_at(
            ErrorKind::bad_file, name, line,
            "is not TOML: " + std::string(error.description()) + unit_hint(text, line));
    }
}

std::vector<TomlEntry> in_file_order(const toml::table& table) {
    std::vector<TomlEntry> entries;
    for (auto&& [key, node] : table) {
        entries.push_back({key.str(), key.source().begin.line, &node});
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const TomlEntry& a, const TomlEntry& b) { return a.line < b.line; });
    return entries;
}

std::size_t line_of(const toml::node& node) {
    return node.source().begin.line;
}

std::optional<double> number_of(const toml::node& node) {
    if (const auto* real = node.as_floating_point()) return real->get();
    if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
    return std::nullopt;
}

std::optional<std::vector<double>> numbers_of(const toml::node& node) {
    const toml::array* list = node.as_array();
    if (list == nullptr) return std::nullopt;
    std::vector<double> numbers;
    for (const toml::node& item : *list) {
        const std::optional<double> number = number_of(item);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::string shown(const toml::node& node) {
    if (const auto* text = node.as_string()) return '"' + text::printable(text->get()) + '"';
    if (const auto* number = node.as_floating_point()) return toml_number(number->get());
    if (const auto* integer = node.as_integer()) return std::to_string(integer->get());
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* list = node.as_array()) return "an array of " + std::to_string(list->size());
    return node.is_table() ? "a table" : "a date or time";
}

}  // namespace ocean
