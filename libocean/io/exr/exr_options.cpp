// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of compressions.
#include <array>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/io/exr.hpp"

namespace ocean::io {
namespace {

using Compression = std::pair<std::string_view, ExrCompression>;
constexpr std::array<Compression, 6> kCompressions{{{"none", ExrCompression::none},
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
    // Both families are made for colours: B44 quantises blocks of half pixels; DWA discards details
    // that the eye does not see in channels named R, G, B, Y and keeps other channels.
    if (name == "b44" || name == "b44a" || name == "dwaa" || name == "dwab") {
        throw Error(ErrorKind::invalid_value, "compression '" + std::string(name) +
                                                  "' is lossy and changes vectors by centimetres" +
                                                  kAllowed);
    }
    throw Error(ErrorKind::invalid_value,
                "compression '" + std::string(name) + "' is unknown" +
                    did_you_mean(name, kCompressions, &Compression::first) + kAllowed);
}

std::string_view exr_compression_name(ExrCompression compression) {
    for (const auto& [text, value] : kCompressions) {
        if (value == compression) return text;
    }
    return "";
}

}  // namespace ocean::io
