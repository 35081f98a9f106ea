// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From the buffers of a C host to the outputs of Ocean::evaluate_into.
#pragma once

#include <span>

#include "libocean.h"
#include "ocean/map_output.hpp"

namespace ocean::capi {

/// Every check of libocean.h on buffers for maps of `resolution` samples a side. Throws CallError.
void check_outputs(std::span<const ocean_output> outputs, int resolution);

/// A checked output.
MapOutput map_output(const ocean_output& output);

}  // namespace ocean::capi
