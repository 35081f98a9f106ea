// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The heights of a frame, for the formats that hold only heights.
#pragma once

#include "ocean/bake/typed_format.hpp"
#include "ocean/io/image.hpp"

namespace ocean {

/// Returns the heights of a frame's first map, with provenance and the resolution of the map.
io::Image height_image(const FrameWork& work);

}  // namespace ocean
