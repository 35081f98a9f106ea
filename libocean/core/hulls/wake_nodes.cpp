// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/wake_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "field/ease.hpp"

namespace ocean {
namespace {

constexpr int kBlocks = 3;           // a straight block has at most 2^3 ticks
constexpr double kStraight = 1e-3;   // distance from a straight line of constant speed [m]
constexpr double kTrail = 0.26;      // share of the square by which it trails the hull
constexpr double kFadeOfAge = 0.75;  // share of the age at which waves begin to fade
constexpr double kAtRest = 1e-3;     // [m/s]
constexpr double kRounding = 1e-9;
constexpr double kSame = 1e-6;  // lengths of two segments [s], [m]

PathVector operator-(const PathVector& a, const PathVector& b) {
    return {a.x - b.x, a.y - b.y};
}

/// Returns true if a hull moves straight on at one speed between two times.
bool is_straight(const TrackPath& path, double from, double to) {
    const PathVector a = path.place(from);
    const PathVector b = path.place(to);
    for (int i = 1; i < 4; ++i) {
        const double u = 0.25 * i;
        const PathVector at = path.place(from + u * (to - from));
        const double off = std::max(std::abs(at.x - a.x - u * (b.x - a.x)),
                                    std::abs(at.y - a.y - u * (b.y - a.y)));
        if (off > kStraight) return false;
    }
    return true;
}

/// Returns true if a segment goes on from a run with the same length and speed.
bool goes_on(const WakeRun& run, double seconds, const PathVector& step) {
    return std::abs(run.seconds - seconds) < kSame && std::abs(run.dx - step.x) < kSame &&
           std::abs(run.dy - step.y) < kSame;
}

}  // namespace

WakePlace wake_place(const TrackPath& path, double time, double size, double step) {
    // The mean of three past velocities turns and stops smoothly.
    const PathVector now = path.place(time);
    PathVector mean;
    for (const double lag : {1.0, 4.0, 16.0}) {
        const PathVector past = path.place(time - lag);
        mean.x += (now.x - past.x) / lag / 3.0;
        mean.y += (now.y - past.y) / lag / 3.0;
    }
    constexpr double kSlow = 4.0;  // [m^2/s^2]
    const double back = kTrail * size / std::sqrt(mean.x * mean.x + mean.y * mean.y + kSlow);
    const PathVector middle{now.x - back * mean.x, now.y - back * mean.y};
    return {{std::round(middle.x / step) * step, std::round(middle.y / step) * step}, middle};
}

WakeClock::WakeClock(const TrackPath& path, double longest) {
    // In a loop a whole number of the largest blocks fits into the period.
    if (path.period() > 0.0) {
        constexpr double kBlock = kWakeTick * (1 << kBlocks);
        tick_ = path.period() / std::ceil(path.period() / kBlock) / (1 << kBlocks);
    }
    while (ticks_ < 1 << kBlocks && 2.0 * tick_ * static_cast<double>(ticks_) <= longest) {
        ticks_ *= 2;
    }
}

std::int64_t WakeClock::span_of(double time) const {
    const double spans = time / (tick_ * static_cast<double>(ticks_));
    return static_cast<std::int64_t>(std::ceil(spans - kRounding)) - 1;
}

std::vector<double> WakeClock::settled(const TrackPath& path, std::int64_t span, double age) const {
    // Whole blocks, or the weights of the oldest nodes would jump.
    const double block = tick_ * (1 << kBlocks);
    const auto oldest =
        static_cast<std::int64_t>(std::floor((begin(span) - age) / block)) * (1 << kBlocks);
    return nodes(path, oldest, begin(span));
}

std::vector<double> WakeClock::tick(const TrackPath& path, std::int64_t span, int tick) const {
    const std::int64_t n = span * ticks_ + tick;
    return nodes(path, n, at(n + 1));
}

WakeNewest WakeClock::newest(const TrackPath& path, double time) const {
    const std::int64_t span = span_of(time);
    if (begin(span) >= path.begin() && is_straight(path, begin(span), time)) {
        return {0, {begin(span), time}};
    }
    const std::int64_t n = static_cast<std::int64_t>(std::ceil(time / tick_ - kRounding)) - 1;
    return {static_cast<int>(n - span * ticks_), nodes(path, n, time)};
}

/// Returns nodes from the tick `oldest` on, but none before the track begins.
std::vector<double> WakeClock::nodes(const TrackPath& path, std::int64_t oldest,
                                     double time) const {
    if (at(oldest) < path.begin()) {
        oldest = static_cast<std::int64_t>(std::ceil(path.begin() / tick_ - kRounding));
    }
    auto n = static_cast<std::int64_t>(std::floor(time / tick_ + kRounding));
    if (n < oldest) return {};
    std::vector<double> times;
    if (time > at(n) + kRounding) times.push_back(time);
    times.push_back(at(n));
    const auto may_merge = [&](std::int64_t ticks) {
        return n % ticks == 0 && n - ticks >= oldest && is_straight(path, at(n - ticks), at(n));
    };
    while (n > oldest) {
        std::int64_t ticks = 1;
        while (ticks < 1 << kBlocks && may_merge(2 * ticks)) ticks *= 2;
        n -= ticks;
        times.push_back(at(n));
    }
    std::ranges::reverse(times);
    return times;
}

WakePast wake_past(const TrackPath& path, const std::vector<double>& times, double time,
                   const WakePlace& place) {
    WakePast past{place, {}, {}};
    double before = 0.0;
    int pace = 0;
    for (std::size_t j = 0; j < times.size(); ++j) {
        const PathVector at = path.place(times[j]) - place.centre;
        const double seconds = j > 0 ? times[j] - times[j - 1] : 0.0;
        if (std::abs(seconds - before) > kSame) ++pace;
        before = seconds;
        past.nodes.push_back({times[j] - time, at.x, at.y, pace});
    }
    for (std::size_t j = 0; j + 1 < times.size(); ++j) {
        const WakeNode& a = past.nodes[j];
        const WakeNode& b = past.nodes[j + 1];
        const double seconds = times[j + 1] - times[j];
        const PathVector way{b.x - a.x, b.y - a.y};
        if (std::hypot(way.x, way.y) < kAtRest * seconds) continue;
        const auto first = static_cast<int>(j);
        const bool open = !past.runs.empty() && past.runs.back().last == first;
        if (open && goes_on(past.runs.back(), seconds, way)) {
            ++past.runs.back().last;
        } else {
            past.runs.push_back({first, first + 1, seconds, way.x, way.y});
        }
    }
    return past;
}

void WakePast::insert_before(const WakeNode& node) {
    nodes.insert(nodes.begin(), node);
    for (WakeRun& run : runs) {
        ++run.first;
        ++run.last;
    }
}

WindowNodes::WindowNodes(const WakePast& past, double later, const PathVector& middle, double age)
    : count_((past.nodes.size() + kWakeBlock - 1) / kWakeBlock * kWakeBlock), values_(4 * count_) {
    std::ranges::fill(values_, 0.0f);
    const PathVector from_middle = past.place.centre - middle;
    for (std::size_t j = 0; j < past.nodes.size(); ++j) {
        const WakeNode& node = past.nodes[j];
        const double ago = later - node.since;
        values_[j] = static_cast<float>(node.x + from_middle.x);
        values_[count_ + j] = static_cast<float>(node.y + from_middle.y);
        values_[2 * count_ + j] = static_cast<float>(ago);
        values_[3 * count_ + j] = static_cast<float>(ease(1.0, kFadeOfAge, ago / age));
    }
}

WakeWindow WindowNodes::window(int first) const {
    const float* const values = values_.data() + first;
    return {values, values + count_, values + 2 * count_, values + 3 * count_};
}

}  // namespace ocean
