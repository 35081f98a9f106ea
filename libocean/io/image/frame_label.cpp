// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/io/frame_label.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "ocean/platform.hpp"
#include "ocean/text.hpp"
#include "ocean/version.hpp"

namespace ocean::io {

std::vector<HeaderString> label_strings(const FrameLabel& label) {
    return {{"ocean:sea", std::string(label.sea_text)},
            {"ocean:frame", std::to_string(label.number)},
            {"ocean:time", shortest_text(label.time)},
            {"ocean:period", shortest_text(label.period)},
            {"ocean:backend", std::string(label.backend)},
            {"ocean:version", OCEAN_VERSION}};
}

std::string read_head(const std::string& path) {
    constexpr std::uintmax_t kLongest = std::uintmax_t{8} << 20;  // a sea with its take
    std::error_code missing;
    const std::uintmax_t size = std::filesystem::file_size(utf8_path(path), missing);
    if (missing) return {};
    std::ifstream file(utf8_path(path), std::ios::binary);
    std::string head(static_cast<std::size_t>(std::min(size, kLongest)), '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return head;
}

std::string comment_lines(std::span<const HeaderString> strings, std::string_view prefix) {
    std::string lines;
    for (const HeaderString& string : strings) {
        std::string_view rest = string.text;
        for (bool more = true; more;) {
            const std::size_t end = rest.find('\n');
            more = end != std::string_view::npos && end + 1 < rest.size();
            lines += std::string(prefix) + ' ' + string.name + ' ';
            lines += rest.substr(0, end);
            lines += '\n';
            if (more) rest.remove_prefix(end + 1);
        }
    }
    return lines;
}

std::vector<HeaderString> parse_comment_lines(std::string_view text, std::string_view prefix) {
    std::vector<HeaderString> strings;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (!line.starts_with(prefix)) continue;
        line.remove_prefix(prefix.size());
        if (!line.starts_with(' ')) continue;
        line.remove_prefix(1);
        const std::size_t blank = line.find(' ');
        if (blank == std::string_view::npos) continue;
        const std::string_view name = line.substr(0, blank);
        if (strings.empty() || strings.back().name != name) {
            strings.push_back({std::string(name), ""});
        } else {
            strings.back().text += '\n';
        }
        strings.back().text += line.substr(blank + 1);
    }
    return strings;
}

}  // namespace ocean::io
