// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Running a compute shader; see compute_program.hpp.
#include "compute_program.hpp"

namespace ocean::gl {

void dispatch_texels(int resolution) {
    const auto tiles = static_cast<GLuint>(resolution) / 16;
    glDispatchCompute(tiles, tiles, 1);
}

}  // namespace ocean::gl
