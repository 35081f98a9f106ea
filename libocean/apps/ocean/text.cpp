// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Text for people and for JSON; see text.hpp.
#include "text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "ocean/error.hpp"

namespace ocean::app {

std::string format_text(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    va_list again;
    va_copy(again, arguments);
    const int length = std::vsnprintf(nullptr, 0, format, arguments);
    va_end(arguments);
    std::string text(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
    std::vsnprintf(text.data(), text.size() + 1, format, again);
    va_end(again);
    return text;
}

std::string json_string(std::string_view text) {
    std::string json = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            json += '\\';
            json += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            json += format_text("\\u%04x", static_cast<unsigned>(c));
        } else {
            json += c;
        }
    }
    return json + '"';
}

std::string json_list(const std::vector<std::string>& texts) {
    std::string json = "[";
    for (const std::string& text : texts) {
        if (json.size() > 1) json += ", ";
        json += json_string(text);
    }
    return json + "]";
}

std::string bytes_text(std::uint64_t bytes) {
    const double mebibytes = static_cast<double>(bytes) / (1024.0 * 1024.0);
    if (mebibytes < 1024.0) return format_text("%.1f MiB", mebibytes);
    return format_text("%.1f GiB", mebibytes / 1024.0);
}

std::string duration_text(double seconds) {
    if (seconds < 10.0) return format_text("%.1f s", std::max(seconds, 0.0));
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole < 3600) return format_text("%lld:%02lld", whole / 60, whole % 60);
    return format_text("%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
    std::string lines;
    std::string line;
    const auto finish_line = [&] {
        if (!line.empty()) lines += std::string(indent, ' ') + line + '\n';
        line.clear();
    };
    for (const std::string& word : split(text, ' ')) {
        if (!line.empty() && indent + line.size() + 1 + word.size() > width) finish_line();
        if (!line.empty()) line += ' ';
        line += word;
    }
    finish_line();
    return lines;
}

std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts;
    for (;;) {
        const std::size_t end = text.find(separator);
        parts.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

double parse_number(std::string_view text, const std::string& what, double lowest, double highest) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, value);
    // The comparison is written so that NaN fails it.
    if (code != std::errc() || stop != end || !(value >= lowest && value <= highest)) {
        throw Error(ErrorKind::invalid_value,
                    what + " = " + std::string(text) +
                        format_text(": allowed is a number, %g .. %g", lowest, highest));
    }
    return value;
}

}  // namespace ocean::app
