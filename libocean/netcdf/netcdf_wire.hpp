// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A content, or a fault, as bytes for a pipe between two processes of one program. The reading side
// trusts no byte, because a hostile file may control the writing side.
#pragma once

#include "netcdf_content.hpp"
#include "ocean/internal/child_process.hpp"

namespace ocean::netcdf {

using sandbox::Sink;
using sandbox::Source;
using sandbox::WireError;

void encode(const Content& content, const Sink& sink);
void encode(const Fault& fault, const Sink& sink);

/// Returns a consistent content: all dimensions exist, and each variable has one value or text per
/// point of its dimensions. Uses at most a few times the memory of the bytes received. Throws Fault
/// if the other side sent one, WireError for invalid bytes.
Content decode(const Source& source);

}  // namespace ocean::netcdf
