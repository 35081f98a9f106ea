// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See text.hpp.
#include "text.hpp"

#include <algorithm>
#include <cmath>

namespace ocean::app {

std::string bytes_text(std::uint64_t bytes) {
    const double mebibytes = static_cast<double>(bytes) / (1024.0 * 1024.0);
    if (mebibytes < 1024.0) return format_text("%.1f MiB", mebibytes);
    return format_text("%.1f GiB", mebibytes / 1024.0);
}

std::string length_text(double metres) {
    return metres < 10'000.0 ? significant<4>(metres) + " m" : significant<4>(metres / 1e3) + " km";
}

std::string duration_text(double seconds) {
    if (seconds < 10.0) return format_text("%.1f s", std::max(seconds, 0.0));
    const auto whole = static_cast<long long>(std::ceil(seconds));
    if (whole < 3600) return format_text("%lld:%02lld", whole / 60, whole % 60);
    return format_text("%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"# ") == std::string::npos && !text.empty()) return text;
    std::string cell = "\"";
    for (const char c : text) {
        if (c == '"') cell += '"';
        cell += c;
    }
    return cell + '"';
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

}  // namespace ocean::app
