// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads tar: headers of 512 bytes, each followed by its file in blocks of the same size
// [POSIX.1-2017, pax, ustar interchange format]. A long name precedes its file in a separate file
// (GNU's L, pax' x).
#include "archive.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "ocean/internal/checked_text.hpp"

namespace ocean {
namespace {

constexpr std::size_t kBlock = 512;
constexpr std::size_t kMaxName = 4096;

struct Field {
    std::size_t at;
    std::size_t size;
};
constexpr Field kName = {0, 100};
constexpr Field kSize = {124, 12};
constexpr Field kChecksum = {148, 8};
constexpr std::size_t kType = 156;
constexpr Field kMagic = {257, 5};
constexpr Field kPrefix = {345, 155};

std::string_view field(std::string_view header, Field at) {
    const std::string_view bytes = header.substr(at.at, at.size);
    return bytes.substr(0, bytes.find('\0'));
}

std::optional<std::size_t> octal(std::string_view digits) {
    digits.remove_prefix(std::min(digits.find_first_not_of(' '), digits.size()));
    digits = digits.substr(0, digits.find(' '));
    std::size_t value = 0;
    for (const char c : digits) {
        if (c < '0' || c > '7') return std::nullopt;
        value = 8 * value + static_cast<std::size_t>(c - '0');
    }
    return digits.empty() || digits.size() > kSize.size ? std::nullopt : std::optional(value);
}

bool is_header(std::string_view block) {
    if (block.size() < kBlock) return false;
    std::size_t sum = 0;
    for (std::size_t i = 0; i < kBlock; ++i) {
        const bool blank = i >= kChecksum.at && i < kChecksum.at + kChecksum.size;
        sum += blank ? std::size_t{' '} : static_cast<std::uint8_t>(block[i]);
    }
    return octal(field(block, kChecksum)) == sum;
}

/// Returns the path of "27 path=folder/name\n" and other lines of a pax header; empty without one.
std::string_view pax_path(std::string_view content) {
    constexpr std::string_view kKey = " path=";
    const std::size_t at = content.find(kKey);
    if (at == std::string_view::npos) return {};
    const std::string_view path = content.substr(at + kKey.size());
    return path.substr(0, path.find('\n'));
}

}  // namespace

bool is_tar(std::string_view content) {
    return is_header(content.substr(0, kBlock));
}

std::vector<ArchiveMember> tar_members(std::string_view content, const std::string& name,
                                       std::string& cut_off) {
    const auto fail = [&](const std::string& why) {
        return text::error_at(ErrorKind::bad_file, name, 0, "tar: " + why);
    };
    std::vector<ArchiveMember> members;
    std::string long_name;
    while (content.size() >= kBlock) {
        const std::string_view header = content.substr(0, kBlock);
        content.remove_prefix(kBlock);
        if (header.find_first_not_of('\0') == std::string_view::npos) break;  // the end
        const std::optional<std::size_t> size = octal(field(header, kSize));
        if (!is_header(header) || !size) throw fail("the header of a file is damaged");
        std::string member = long_name;
        if (member.empty()) {
            const bool ustar = header.substr(kMagic.at, kMagic.size) == "ustar";
            const std::string_view prefix = ustar ? field(header, kPrefix) : std::string_view();
            member = std::string(prefix) + (prefix.empty() ? "" : "/") +
                     std::string(field(header, kName));
        }
        member = text::printable(member, kMaxName);
        if (*size > content.size()) {
            if (members.empty()) throw fail("the file is cut off within " + member);
            cut_off = member;
            break;
        }
        const std::string_view file = content.substr(0, *size);
        const char type = header[kType];
        long_name.clear();
        if (type == 'L') long_name = file.substr(0, std::min(file.find('\0'), kMaxName));
        if (type == 'x') long_name = pax_path(file).substr(0, kMaxName);
        if (type == '0' || type == '\0') {
            if (members.size() == kMaxArchiveMembers) throw fail("more than 10000 files");
            members.push_back({member, file});
        }
        content.remove_prefix(std::min(content.size(), (*size + kBlock - 1) / kBlock * kBlock));
    }
    return members;
}

}  // namespace ocean
