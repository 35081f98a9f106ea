// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "reader_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ocean::fuzz::run_reader(ocean::kDatawell, {"fuzz}2024-09-09T01h15Z.spt"}, data, size);
    return 0;
}
