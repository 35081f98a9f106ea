// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as MIDI: reports of channels that there are, the same wherever the stream is cut.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "midi_messages.hpp"

namespace {

using namespace ocean::bridge;

void require(bool condition) {
    if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    // The first byte says how long the pieces are.
    const std::span<const std::uint8_t> stream(data + 1, size - 1);
    const std::vector<MidiReport> whole = MidiParser().feed(stream);
    for (const MidiReport& report : whole) {
        require(report.channel >= 1 && report.channel <= 16);
        require(report.number >= 0 && report.number < kMidiNumbers);
        require(report.value >= 0 && report.value <= kBendHighest);
        require(report.kind != MidiKind::note || report.value <= 1);
        require(report.kind != MidiKind::controller || report.value <= kMidiHighest);
    }
    MidiParser parser;
    std::vector<MidiReport> reports;
    const std::size_t piece = data[0] % 16 + 1;
    for (std::size_t at = 0; at < stream.size(); at += piece) {
        const auto next = parser.feed(stream.subspan(at, std::min(piece, stream.size() - at)));
        reports.insert(reports.end(), next.begin(), next.end());
    }
    require(reports == whole);
    return 0;
}
