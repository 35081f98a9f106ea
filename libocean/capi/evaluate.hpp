// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From the planar maps of a Surface to the interleaved buffers of a C host.
#pragma once

#include <span>

#include "libocean.h"
#include "ocean/surface.hpp"

namespace ocean::capi {

/// The channels that the outputs ask for, after every check of libocean.h on buffers for maps of
/// `resolution` samples a side. Throws CallError.
ChannelSet check_outputs(std::span<const ocean_output> outputs, int resolution);

/// Fills one checked output from a surface that has its channels.
void write_output(const Surface& surface, const ocean_output& output);

}  // namespace ocean::capi
