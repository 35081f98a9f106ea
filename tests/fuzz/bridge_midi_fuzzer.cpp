// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as MIDI: reports of channels that there are and values of 14 bits joined from them, the
// same wherever the stream is cut; none that waits for its fine byte waits for ever; and what is
// learnt of them is a map.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "midi_messages.hpp"
#include "ocean/internal/bridge/control_map_file.hpp"
#include "ocean/internal/bridge/learner.hpp"
#include "require.hpp"

namespace {

using namespace ocean::bridge;
using ocean::fuzz::require;

constexpr Clock::time_point kStart{std::chrono::hours(1)};

void check(const MidiReport& report) {
    const bool is_number = report.kind == MidiKind::nrpn || report.kind == MidiKind::rpn;
    require(report.channel >= 1 && report.channel <= 16);
    require(report.number >= 0 && report.number <= (is_number ? kMidiMax14 : kMidiNumbers - 1));
    require(report.value >= 0 && report.value <= kMidiMax14);
    require(report.kind != MidiKind::note || report.value <= 1);
    require(report.kind != MidiKind::controller || report.value <= kMidiMax);
    require(report.kind != MidiKind::pair || report.number < kMidiPairs);
}

/// The reports of a stream in pieces, each with the values that it completes behind it.
std::vector<MidiReport> reports_of(std::span<const std::uint8_t> stream, std::size_t piece) {
    MidiParser parser;
    MidiJoiner joiner;
    std::vector<MidiReport> reports;
    const auto add = [&](const std::vector<MidiReport>& more) {
        reports.insert(reports.end(), more.begin(), more.end());
    };
    for (std::size_t at = 0; at < stream.size(); at += piece) {
        for (const MidiReport& report :
             parser.feed(stream.subspan(at, std::min(piece, stream.size() - at)))) {
            add({report});
            add(joiner.take(report, kStart));
        }
    }
    require(!joiner.next() || *joiner.next() == kStart + MidiJoiner::kFineWait);
    add(joiner.advance(kStart + MidiJoiner::kFineWait));
    require(!joiner.next());
    return reports;
}

void learn(const std::vector<MidiReport>& reports) {
    static const ValueTable values;
    static const Learner fresh(values);
    constexpr std::array kLetters = {"cc", "n", "pb", "pair", "nrpn", "rpn"};
    Learner learner = fresh;
    for (const MidiReport& report : reports) {
        learner.report({kStart,
                        std::string("m/") + kLetters[static_cast<std::size_t>(report.kind)] +
                            std::to_string(report.number),
                        static_cast<double>(report.value), true},
                       nullptr);
    }
    for (const Lesson& lesson : learner.advance(kStart + std::chrono::hours(1))) {
        if (lesson.is_map)
            require(parse_control_map(lesson.text, "learnt", values).maps.size() == 1);
    }
    require(!learner.next());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    // The first byte says how long the pieces are.
    const std::span<const std::uint8_t> stream(data + 1, size - 1);
    const std::vector<MidiReport> whole = reports_of(stream, size);
    std::ranges::for_each(whole, check);
    require(reports_of(stream, data[0] % 16 + 1) == whole);
    learn(whole);
    return 0;
}
