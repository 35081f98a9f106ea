// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A raster, or a fault, as bytes for a pipe between two processes. The reading side
// trusts no byte, because a hostile file may control the writing side.
#pragma once

#include "ocean/internal/child_process.hpp"
#include "raster.hpp"

namespace ocean::elevation {

/// Runs `read` with a receiver that writes to the sink, then a fault if it throws one.
void encode(const std::function<void(const RasterReceiver&)>& read, const sandbox::Sink& sink);

/// Returns the facts that `encode` wrote. Throws as decode.
RasterFacts decode_facts(const sandbox::Source& source);

/// Calls the receiver with what `encode` wrote: as many rows as the facts announce. Throws
/// RasterFault if the other side sent one, sandbox::WireError for invalid bytes.
void decode(const sandbox::Source& source, const RasterReceiver& receiver);

}  // namespace ocean::elevation
