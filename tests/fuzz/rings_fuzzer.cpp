// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A file of rings from any bytes gives increasing wavenumbers, or one printable error.
#include <cmath>

#include "ocean/internal/measured_rings.hpp"
#include "reader_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean;
    try {
        const MeasuredRings rings =
            parse_rings({reinterpret_cast<const char*>(data), size}, "fuzz.csv");
        const std::size_t count = rings.wavenumber.size();
        fuzz::require(count >= kMinRings && count <= kMaxRings && rings.density.size() == count);
        for (std::size_t i = 0; i < count; ++i) {
            fuzz::require(rings.wavenumber[i] > (i > 0 ? rings.wavenumber[i - 1] : 0.0));
            fuzz::require(rings.density[i] >= 0.0 && std::isfinite(rings.density[i]));
        }
    } catch (const Error& error) {
        fuzz::check_message(error.what());
    }
    return 0;
}
