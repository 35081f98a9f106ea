// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "reader_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ocean::fuzz::run_reader(ocean::kNdbcHistorical,
                            {"41010w2019.txt", "41010d2019.txt", "41010i2019.txt", "41010j2019.txt",
                             "41010k2019.txt.gz"},
                            data, size);
    return 0;
}
