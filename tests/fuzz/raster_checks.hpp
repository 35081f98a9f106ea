// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The promises of every reader of rasters: facts first, then as many rows as they announce, each of
// their width; or one printable fault.
#pragma once

#include "raster.hpp"
#include "reader_fuzzer.hpp"

namespace ocean::fuzz {

/// A raster that is larger is not read on: it only costs time.
struct TooLarge {};

template <typename Read>
void check_raster(const Read& read) {
    constexpr std::int64_t kMaxCells = std::int64_t{1} << 22;
    elevation::RasterFacts facts;
    std::int64_t rows = 0;
    const elevation::RasterReceiver receiver{
        .begin =
            [&](const elevation::RasterFacts& its_facts) {
                facts = its_facts;
                require(facts.columns >= 0 && facts.columns <= INT32_MAX);
                require(facts.rows >= 0 && facts.rows <= INT32_MAX);
                if (facts.columns > kMaxElevationSide || facts.rows > kMaxElevationSide ||
                    facts.columns * facts.rows > kMaxCells) {
                    throw TooLarge();
                }
            },
        .row =
            [&](std::span<const float> row) {
                require(static_cast<std::int64_t>(row.size()) == facts.columns);
                ++rows;
            }};
    try {
        read(receiver);
        require(rows == facts.rows);
    } catch (const elevation::RasterFault& fault) {
        require(!std::string_view(fault.what()).empty());
    } catch (const TooLarge&) {
        require(rows == 0);
    }
}

}  // namespace ocean::fuzz
