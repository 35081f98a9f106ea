// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "window/recent_files.hpp"

#include <algorithm>
#include <filesystem>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"
#include "user_files.hpp"

namespace ocean::app {
namespace {

constexpr std::size_t kMaxListBytes = std::size_t{64} << 10;
constexpr std::size_t kMaxPathBytes = 4096;

bool is_plain_path(const std::string& line) {
    return line.starts_with('/') && line.size() <= kMaxPathBytes &&
           text::printable(line, kMaxPathBytes + 1) == line;
}

}  // namespace

std::string RecentFiles::default_path() {
    return state_file("recent");
}

std::vector<std::string> RecentFiles::read() const {
    std::vector<std::string> files;
    if (path_.empty()) return files;
    std::string list;
    try {
        list = text::read_file(path_, kMaxListBytes);
    } catch (const Error&) {
        return files;  // none was opened yet, or the list is not ours
    }
    for (const std::string& line : split(list, '\n')) {
        const bool is_listed = std::ranges::find(files, line) != files.end();
        if (files.size() < kMaxFiles && is_plain_path(line) && !is_listed) files.push_back(line);
    }
    return files;
}

void RecentFiles::add(const std::string& file) const {
    const std::string path = text::to_utf8(std::filesystem::absolute(utf8_path(file)));
    if (path_.empty() || !is_plain_path(path)) return;
    std::vector<std::string> files = read();
    std::erase(files, path);
    files.insert(files.begin(), path);
    if (files.size() > kMaxFiles) files.resize(kMaxFiles);
    std::string list;
    for (const std::string& each : files) list += each + "\n";
    io::write_output(path_, list);
}

}  // namespace ocean::app
