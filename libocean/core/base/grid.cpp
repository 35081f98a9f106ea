// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The check of a number of samples; see grid.hpp.
#include "ocean/internal/grid.hpp"

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {

void require_resolution(int resolution) {
    if (is_resolution(resolution)) return;
    throw Error(ErrorKind::invalid_value, {.parameter = "resolution",
                                           .value = std::to_string(resolution),
                                           .allowed = format_text("a power of two, %d .. %d",
                                                                  kMinResolution, kMaxResolution)});
}

}  // namespace ocean
