// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a take: either events that survive a round trip, alone and inside a sea file, and
// play, or one Error whose message is safe to print. Anything else is a finding.
#include <cmath>

#include "reader_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean;
    Sea sea;
    sea.parameters.waves.resize(2);
    try {
        sea.take =
            parse_take({reinterpret_cast<const char*>(data), size}, "fuzz.take", sea.parameters);
    } catch (const Error& error) {
        fuzz::check_message(error.what());
        return 0;
    }
    const std::string written = write_take(sea.take);
    fuzz::require(write_take(parse_take(written, "written", sea.parameters)) == written);
    const std::string whole = write_sea(sea);
    fuzz::require(write_sea(parse_sea(whole, "written.toml", "/nonexistent")) == whole);
    validate(sea);
    const double end = sea.take.empty() ? 0.0 : sea.take.events.back().seconds;
    for (const double time : {0.0, end, end + 0.1, end + 1e3}) validate(sea.at(time));
    return 0;
}
