// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The words by which people choose a compression.
#include <array>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/io/exr.hpp"

namespace ocean::io {
namespace {

constexpr std::array<std::pair<std::string_view, ExrCompression>, 6> kCompressions{
    {{"none", ExrCompression::none},
     {"rle", ExrCompression::rle},
     {"zips", ExrCompression::zips},
     {"zip", ExrCompression::zip},
     {"piz", ExrCompression::piz},
     {"pxr24", ExrCompression::pxr24}}};

}  // namespace

ExrCompression find_exr_compression(std::string_view name) {
    constexpr const char* kAllowed = "; allowed: none, rle, zips, zip, piz, pxr24";
    for (const auto& [text, compression] : kCompressions) {
        if (text == name) return compression;
    }
    // Both families are made for colour: B44 quantises blocks of half pixels, DWA throws away what
    // an eye does not see in channels named R, G, B, Y and leaves others alone.
    if (name == "b44" || name == "b44a" || name == "dwaa" || name == "dwab") {
        throw Error(ErrorKind::invalid_value, "compression '" + std::string(name) +
                                                  "' is lossy and spoils vectors by centimetres" +
                                                  kAllowed);
    }
    throw Error(ErrorKind::invalid_value,
                "compression '" + std::string(name) + "' is unknown" + kAllowed);
}

std::string_view exr_compression_name(ExrCompression compression) {
    for (const auto& [text, value] : kCompressions) {
        if (value == compression) return text;
    }
    return "";
}

}  // namespace ocean::io
