// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_header.hpp"

#include <algorithm>
#include <fstream>

#include "ocean/error.hpp"
#include "ocean/platform.hpp"

namespace ocean::io {

std::vector<HeaderString> read_comments(const std::string& path, std::string_view magic,
                                        std::string_view end, std::string_view prefix) {
    constexpr std::size_t kLongestHeader = std::size_t{8} << 20;  // a sea with its take
    std::ifstream file(utf8_path(path), std::ios::binary);
    std::string head(kLongestHeader, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    const std::size_t stop = head.find(end, magic.size());
    std::vector<HeaderString> strings;
    if (head.starts_with(magic) && stop != std::string::npos) {
        const std::string_view lines = std::string_view(head).substr(0, stop);
        strings = parse_comment_lines(lines.substr(magic.size()), prefix);
    }
    const auto is_sea = [](const HeaderString& string) { return string.name == "ocean:sea"; };
    if (std::ranges::none_of(strings, is_sea)) {
        throw Error(ErrorKind::bad_file,
                    path + ": its comments name no sea; only files that `ocean bake` wrote do");
    }
    return strings;
}

}  // namespace ocean::io
