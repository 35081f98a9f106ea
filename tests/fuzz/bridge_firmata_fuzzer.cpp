// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as Firmata: reports of inputs that there may be, the same wherever the stream is cut.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "firmata_protocol.hpp"
#include "require.hpp"

namespace {

using namespace ocean::bridge;
using ocean::fuzz::require;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    // The first byte says how long the pieces are.
    const std::span<const std::uint8_t> stream(data + 1, size - 1);
    const std::vector<FirmataReport> whole = FirmataParser().feed(stream);
    for (const FirmataReport& report : whole) {
        const bool numbered =
            report.kind == FirmataKind::analog || report.kind == FirmataKind::digital;
        require(report.number >= 0 && report.number < (numbered ? 16 : 128));
        require(report.value >= 0 && report.value < 1 << 14);
    }
    FirmataParser parser;
    std::vector<FirmataReport> reports;
    const std::size_t piece = data[0] % 16 + 1;
    for (std::size_t at = 0; at < stream.size(); at += piece) {
        const auto next = parser.feed(stream.subspan(at, std::min(piece, stream.size() - at)));
        reports.insert(reports.end(), next.begin(), next.end());
    }
    require(reports == whole);
    return 0;
}
