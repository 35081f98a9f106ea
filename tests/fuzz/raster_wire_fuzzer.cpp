// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A child that reads a raster may send any bytes, since a file may have overrun it: decode gives a
// raster, one fault, or a WireError.
#include "child_bytes.hpp"
#include "raster.hpp"
#include "raster_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean;
    const sandbox::Source source = fuzz::child_bytes(data, size);
    try {
        fuzz::check_raster([&](const elevation::RasterReceiver& receiver) {
            elevation::decode(source, receiver);
        });
    } catch (const sandbox::WireError&) {
        return 0;
    }
    return 0;
}
