// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a table of points: either columns of equal length with numbers in their range, or
// one Error whose message is safe to print. Anything else is a finding.
#include "point_table.hpp"

#include <cmath>

#include "reader_fuzzer.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using ocean::app::PointColumn;
    using ocean::fuzz::require;
    const std::vector<PointColumn> known = {{"x", PointColumn::Kind::needed},
                                            {"y", PointColumn::Kind::needed},
                                            {"z", PointColumn::Kind::optional},
                                            {"name", PointColumn::Kind::text}};
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const auto table = ocean::app::parse_points(text, "points.csv", known);
        for (const char* column : {"x", "y", "z"}) {
            const auto numbers = table.numbers(column);
            require(numbers.size() == (table.has(column) ? table.size() : 0));
            for (const double number : numbers) {
                require(std::abs(number) <= ocean::app::kMaxPointNumber);
            }
        }
        for (const std::string& name : table.texts("name")) {
            require(name.size() <= ocean::app::kMaxPointTextBytes);
            if (!name.empty()) ocean::fuzz::check_message(name);
        }
    } catch (const ocean::Error& error) {
        ocean::fuzz::check_message(error.what());
    }
    return 0;
}
