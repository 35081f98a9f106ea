// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "reader_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ocean::fuzz::run_reader(ocean::kObscape, {"fuzz.csv"}, data, size);
    return 0;
}
