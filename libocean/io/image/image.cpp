// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// An image as a value; see image.hpp.
#include "ocean/io/image.hpp"

#include <algorithm>

#include "ocean/error.hpp"

namespace ocean::io {

const std::string& Image::string(std::string_view name) const {
    const auto found =
        std::find_if(strings.begin(), strings.end(),
                     [&](const HeaderString& string) { return string.name == name; });
    if (found != strings.end()) return found->text;
    throw Error(ErrorKind::invalid_value, "an image has no string " + std::string(name));
}

}  // namespace ocean::io
