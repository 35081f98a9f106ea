// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See image.hpp.
#include "ocean/io/image.hpp"

namespace ocean::io {

std::vector<HeaderString> Image::header_strings() const {
    std::vector<HeaderString> all;
    if (!provenance.kind.empty()) all = provenance_strings(provenance);
    all.insert(all.end(), strings.begin(), strings.end());
    return all;
}

}  // namespace ocean::io
