// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a sea file: either a sea that survives a round trip, or one Error whose message is
// safe to print. Anything else is a finding.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/seafile.hpp"
#include "require.hpp"

using ocean::fuzz::check_message;
using ocean::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    ocean::Sea sea;
    try {
        sea = ocean::parse_sea(text, "fuzz.toml", "/nonexistent");
    } catch (const ocean::Error& error) {
        check_message(error.what());
        return 0;
    }
    const std::string written = ocean::write_sea(sea);
    require(ocean::write_sea(ocean::parse_sea(written, "written.toml", "/nonexistent")) == written);
    return 0;
}
