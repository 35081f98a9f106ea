// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A content, or a fault, as bytes for a pipe between two processes of one program. The reading side
// trusts no byte, because a hostile file may control the writing side.
#pragma once

#include <functional>

#include "netcdf_content.hpp"

namespace ocean::netcdf {

/// Writes all bytes.
using Sink = std::function<void(const void* bytes, std::size_t count)>;
/// Reads `count` bytes. Returns false if fewer are left.
using Source = std::function<bool(void* bytes, std::size_t count)>;

void encode(const Content& content, const Sink& sink);
void encode(const Fault& fault, const Sink& sink);

/// The bytes do not represent a content.
struct WireError : std::runtime_error {
    WireError() : std::runtime_error("no content") {}
};
/// Returns a consistent content: all dimensions exist, and each variable has one value or text per
/// point of its dimensions. Uses at most a few times the memory of the bytes received. Throws Fault
/// if the other side sent one, WireError for invalid bytes.
Content decode(const Source& source);

}  // namespace ocean::netcdf
