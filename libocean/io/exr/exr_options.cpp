// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of compressions.
#include "ocean/enum_words.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/io/exr.hpp"

namespace ocean::io {

ExrCompression find_exr_compression(std::string_view name) {
    constexpr const char* kAllowed = "; allowed: none, rle, zips, zip, piz, pxr24";
    if (const auto found = enumerator_of<ExrCompression>(name)) return *found;
    // Both families are made for colours: B44 quantises blocks of half pixels; DWA discards details
    // that the eye does not see in channels named R, G, B, Y and keeps other channels.
    if (name == "b44" || name == "b44a" || name == "dwaa" || name == "dwab") {
        throw Error(ErrorKind::invalid_value, "compression '" + std::string(name) +
                                                  "' is lossy and changes vectors by centimetres" +
                                                  kAllowed);
    }
    throw Error(ErrorKind::invalid_value, "compression '" + std::string(name) + "' is unknown" +
                                              did_you_mean(name, kEnumWords<ExrCompression>) +
                                              kAllowed);
}

std::string_view exr_compression_name(ExrCompression compression) {
    return word_of(compression);
}

}  // namespace ocean::io
