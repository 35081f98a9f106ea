// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a sea file: either a sea that survives a round trip, or one Error whose message is
// safe to print. Anything else is a finding.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/seafile.hpp"

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

void require_printable(std::string_view message) {
    require(!message.empty() && message.size() < 4096);
    for (char c : message) require(static_cast<unsigned char>(c) >= 0x20);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    ocean::Sea sea;
    try {
        sea = ocean::parse_sea(text, "fuzz.toml", "/nonexistent");
    } catch (const ocean::Error& error) {
        require_printable(error.what());
        return 0;
    }
    const std::string written = ocean::write_sea(sea);
    require(ocean::write_sea(ocean::parse_sea(written, "written.toml", "/nonexistent")) == written);
    return 0;
}
