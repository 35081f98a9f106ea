// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See height_image.hpp.
#include "formats/height_image.hpp"

#include <string>

#include "ocean/internal/io/product_image.hpp"

namespace ocean {

io::Image height_image(const FrameWork& work) {
    const Product* const heights[] = {&find_product("height")};
    io::Image image = io::product_image(heights, {}, work.provenance(), work.maps.front());
    image.strings.push_back({"ocean:resolution", std::to_string(work.plan.resolution)});
    return image;
}

}  // namespace ocean
