// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From texels that were read back to the buffers of a host.
#pragma once

#include "ocean/backend.hpp"
#include "ocean/internal/map_request.hpp"

namespace ocean::gl {

/// Writes the quantity, times its factor, to every component of the outputs that holds it.
/// `texels`: the whole map, row by row, `step` floats apart.
void write_quantity(const MapRequest& request, Quantity quantity, const float* texels, int step,
                    ThreadPool& pool);

}  // namespace ocean::gl
