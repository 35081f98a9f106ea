// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts in the header of a PNG: chunks iTXt, which hold UTF-8, and tEXt, which hold Latin-1,
// between the first chunk and the pixels [PNG 1.2] sections 3.2 and 4.2.3. They are inserted and
// read without libpng, whose simple writer does not support them.
#include <zlib.h>

#include <cstdint>

#include "ocean/error.hpp"
#include "ocean/internal/io/png.hpp"

namespace ocean::io {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kText = "iTXt", kKeyword = "tEXt";
constexpr std::size_t kChunkOverhead = 12;  // length, type and checksum
constexpr std::size_t kFirstChunk = kSignature.size() + 13 + kChunkOverhead;  // IHDR
/// The bytes after the keyword: its end, "not compressed", the method, the ends of two empty texts.
constexpr std::string_view kPlain("\0\0\0\0\0", 5);

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(value >> shift & 0xff);
    }
    return bytes;
}

std::uint32_t integer_at(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char byte : bytes.substr(0, 4))
        value = value << 8 | static_cast<unsigned char>(byte);
    return value;
}

/// Returns a chunk of a type; `between` separates the name from the text.
std::string text_chunk(std::string_view type, const HeaderString& string,
                       std::string_view between) {
    const std::string content =
        std::string(type) + string.name + std::string(between) + string.text;
    const auto checksum =
        crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size());
    return big_endian(static_cast<std::uint32_t>(content.size() - type.size())) + content +
           big_endian(static_cast<std::uint32_t>(checksum));
}

std::string with_chunks(std::string_view png, std::span<const HeaderString> strings,
                        std::string_view type, std::string_view between) {
    std::string bytes(png.substr(0, kFirstChunk));
    for (const HeaderString& string : strings) bytes += text_chunk(type, string, between);
    return bytes += png.substr(kFirstChunk);
}

/// Returns the bytes between the name and the text of a chunk of that type; "" for other chunks.
std::string_view separator_of(std::string_view type) {
    if (type == kText) return kPlain;
    return type == kKeyword ? kPlain.substr(0, 1) : std::string_view();
}

}  // namespace

std::string with_png_strings(std::string_view png, std::span<const HeaderString> strings) {
    return with_chunks(png, strings, kText, kPlain);
}

std::string with_png_keywords(std::string_view png, std::span<const HeaderString> strings) {
    return with_chunks(png, strings, kKeyword, kPlain.substr(0, 1));
}

std::vector<HeaderString> read_png_header(const std::string& path) {
    const std::string head = read_head(path);
    const auto refuse = [&](const char* reason) {
        return Error(ErrorKind::bad_file, path + ": " + reason);
    };
    std::string_view rest = head;
    if (!rest.starts_with(kSignature)) throw refuse("is no PNG file");
    rest.remove_prefix(kSignature.size());
    std::vector<HeaderString> strings;
    while (rest.size() >= kChunkOverhead) {
        const std::size_t length = integer_at(rest);
        const std::string_view type = rest.substr(4, 4);
        if (type == "IDAT") break;
        if (length > rest.size() - kChunkOverhead) throw refuse("its header ends early");
        const std::string_view content = rest.substr(8, length);
        const std::size_t end = content.find('\0');
        const std::string_view between = separator_of(type);
        const bool plain = !between.empty() && end != std::string_view::npos &&
                           content.substr(end).starts_with(between);
        if (plain && content.starts_with("ocean:")) {
            strings.push_back({std::string(content.substr(0, end)),
                               std::string(content.substr(end + between.size()))});
        }
        rest.remove_prefix(kChunkOverhead + length);
    }
    if (strings.empty()) throw refuse("its header names no sea, so it was not written by libocean");
    return strings;
}

}  // namespace ocean::io
