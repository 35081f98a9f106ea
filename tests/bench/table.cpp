// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Frames against rivals: each cell makes every variant of every library, looks at what it computes,
// keeps the strongest and measures those against ours.
#include "table.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "judge.hpp"

namespace ocean::bench {

namespace {

constexpr double kJudged = 12.34;  // s

struct Entry {
    Subject subject;
    double error = -1.0;
};

std::vector<Frame> frames_of(const std::vector<Entry>& entries) {
    std::vector<Frame> frames;
    for (const Entry& entry : entries) frames.push_back(entry.subject.frame);
    return frames;
}

/// False, and a sentence, if a subject's fields are wrong.
bool judge_all(std::vector<Entry>& entries, const Judge& judge, FrameKind kind) {
    bool right = true;
    for (Entry& entry : entries) {
        entry.subject.frame(judge.time());
        entry.error = judge.error(entry.subject, kind);
        if (entry.error < entry.subject.allowed_error) continue;
        std::fprintf(stderr, "WRONG: %s, %s: error %.1e of the field, allowed %.0e\n",
                     entry.subject.library.c_str(), entry.subject.variant.c_str(), entry.error,
                     entry.subject.allowed_error);
        right = false;
    }
    return right;
}

/// Ours, which comes first, and of each library the fastest two; of planar frames also the fastest
/// that leaves planes, if those two leave pairs.
std::vector<Entry> strongest(std::vector<Entry> entries, const std::vector<double>& seconds,
                             FrameKind kind) {
    std::vector<std::size_t> order(entries.size() - 1);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i + 1;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return seconds[a] < seconds[b]; });
    std::vector<Entry> kept;
    kept.push_back(std::move(entries.front()));
    for (const std::size_t i : order) {
        int same = 0;
        bool planes = false;
        for (const Entry& entry : kept) {
            if (entry.subject.library != entries[i].subject.library) continue;
            ++same;
            planes = planes || !entry.subject.pairs;
        }
        const bool wants_planes = kind == FrameKind::planar && !planes && !entries[i].subject.pairs;
        if (same < 2 || wants_planes) kept.push_back(std::move(entries[i]));
    }
    return kept;
}

void report_cell(const Cell& cell, const std::string& frame, State state,
                 const std::vector<Entry>& entries, const Rounds& rounds, Report& report) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Subject& subject = entries[i].subject;
        report.add({frame, cell.resolution(), cell.threads, std::string(simd_name(cell.level)),
                    state, subject.library, subject.variant, subject.pairs,
                    1e3 * median(rounds.seconds[i]), median_ratio(rounds, 0, i), entries[i].error,
                    rounds.kept, rounds.loaded, rounds.dropped});
    }
}

bool measure_cell(const Cell& cell, const Judge& judge, const TableOptions& options,
                  Report& report) {
    std::vector<Entry> entries;
    entries.push_back({make_ours(cell)});
    for (const SubjectMaker& maker : rival_makers(cell.level)) {
        if (cell.threads < maker.least_threads) continue;
        Subject subject = maker.make(cell);
        if (subject.frame) entries.push_back({std::move(subject)});
    }
    const bool right = judge_all(entries, judge, cell.kind);
    if (!options.all_variants) {
        RoundPlan screening = options.rounds(State::hot, cell.threads);
        screening.least = 3;
        screening.most = 15;
        screening.budget = 0.5;
        const Rounds screened = measure(frames_of(entries), screening);
        std::vector<double> fastest;  // which other work disturbs less than the median
        for (const std::vector<double>& seconds : screened.seconds) {
            fastest.push_back(*std::min_element(seconds.begin(), seconds.end()));
        }
        entries = strongest(std::move(entries), fastest, cell.kind);
    }
    for (const State state : {State::hot, State::cold}) {
        const Rounds rounds = measure(frames_of(entries), options.rounds(state, cell.threads));
        report_cell(cell, frame_name(cell.kind), state, entries, rounds, report);
    }
    return right;
}

}  // namespace

RoundPlan TableOptions::rounds(State state, int threads) const {
    RoundPlan plan;
    plan.state = state;
    plan.clock = threads == 1 ? Clock::cpu : Clock::wall;
    if (quick) {
        plan.budget = 0.7;
        plan.least = 3;
        plan.most = 31;
    }
    return plan;
}

bool frames_table(FrameKind kind, const TableOptions& options, Report& report) {
    bool right = true;
    for (const int n : options.sizes) {
        ThreadPool pool;
        const auto sea = std::make_shared<const Sea>(n, pool);
        const auto rivals = std::make_shared<const RivalSea>(sea->modes);
        const Judge judge(*sea, kJudged);
        for (const int threads : {1, 2}) {
            right =
                measure_cell({sea, rivals, kind, threads, options.level}, judge, options, report) &&
                right;
        }
    }
    return right;
}

bool peers_table(int n, const TableOptions& options, Report& report) {
    ThreadPool pool;
    const auto sea = std::make_shared<const Sea>(n, pool);
    const Judge judge(*sea, kJudged);
    bool right = true;
    for (const int threads : {1, 2}) {
        const Cell cell{sea, nullptr, FrameKind::vertices, threads, options.level};
        std::vector<Entry> entries;
        entries.push_back({make_ours(cell)});
        entries.push_back({make_blender_scheme(cell)});
        if (threads == 1) entries.push_back({make_radix2(cell)});
        right = judge_all(entries, judge, cell.kind) && right;
        const Rounds rounds = measure(frames_of(entries), options.rounds(State::hot, threads));
        report_cell(cell, "peers", State::hot, entries, rounds, report);
    }
    return right;
}

}  // namespace ocean::bench
