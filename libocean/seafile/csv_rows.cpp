// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rows of a CSV that nobody has checked; see csv_rows.hpp.
#include "ocean/csv_rows.hpp"

#include <algorithm>
#include <utility>

namespace ocean::csv {

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    return text.substr(0, text.find_last_not_of(" \t") + 1);
}

bool next_row(LineReader& lines) {
    while (lines.next_filled()) {
        if (!lines.line().starts_with('#')) return true;
    }
    return false;
}

std::optional<std::vector<std::string_view>> split(std::string_view line, char separator,
                                                   std::size_t limit) {
    std::vector<std::string_view> fields;
    while (fields.size() <= limit) {
        const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
        std::size_t end = start;
        while (end < line.size() && line[end] == '"') {  // "" within a text ends and begins it
            end = line.find('"', end + 1);
            if (end == std::string_view::npos) return std::nullopt;
            ++end;
        }
        end = line.find(separator, end);
        const std::string_view field = trimmed(line.substr(start, end - start));
        if (field.starts_with('"') && !field.ends_with('"')) return std::nullopt;
        fields.push_back(field.starts_with('"') ? field.substr(1, field.size() - 2) : field);
        if (end == std::string_view::npos) break;
        line.remove_prefix(end + 1);
    }
    return fields;
}

std::vector<std::string_view> fields_of(const LineReader& lines, char separator,
                                        std::size_t limit) {
    auto fields = split(lines.line(), separator, limit);
    if (!fields) throw lines.fail("a quote is not closed");
    return std::move(*fields);
}

}  // namespace ocean::csv
