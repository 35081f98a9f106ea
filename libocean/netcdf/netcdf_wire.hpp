// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A content, or a fault, as bytes for a pipe between two processes of one program. The reading side
// believes nothing: the writing side may have been overrun by the file that it reads.
#pragma once

#include <functional>

#include "netcdf_content.hpp"

namespace ocean::netcdf {

/// Takes all of the bytes.
using Sink = std::function<void(const void* bytes, std::size_t count)>;
/// Gives so many bytes; false if there are not as many.
using Source = std::function<bool(void* bytes, std::size_t count)>;

void encode(const Content& content, const Sink& sink);
void encode(const Fault& fault, const Sink& sink);

/// The bytes are no content.
struct WireError : std::runtime_error {
    WireError() : std::runtime_error("no content") {}
};
/// A consistent content: dimensions exist, and each variable has as many values or texts as its
/// dimensions say. Takes no more memory than a few times what it is given. Throws Fault if the
/// other side sent one, WireError.
Content decode(const Source& source);

}  // namespace ocean::netcdf
