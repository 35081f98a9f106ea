// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_header.hpp"

#include "ocean/error.hpp"

namespace ocean::io {

std::vector<HeaderString> read_comments(const std::string& path, std::string_view magic,
                                        std::string_view end, std::string_view prefix) {
    const std::string head = read_head(path);
    const std::size_t stop = head.find(end, magic.size());
    std::vector<HeaderString> strings;
    if (head.starts_with(magic) && stop != std::string::npos) {
        const std::string_view lines = std::string_view(head).substr(0, stop);
        strings = parse_comment_lines(lines.substr(magic.size()), prefix);
    }
    if (!find_provenance(strings, path)) {
        throw Error(
            ErrorKind::bad_file,
            path + ": its comments have no sea; only files that `ocean bake` wrote have one");
    }
    return strings;
}

}  // namespace ocean::io
